#include "coupling/linearisation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

template <class Rows>
std::vector<double> row_sums(const Rows& matrix, std::size_t rows) {
  std::vector<double> sums(rows, 0.0);
  parallel_for(matrix.rows(), [&](std::size_t i) {
    sums[i] = sum_row(matrix, i, [](std::uint32_t, double value) { return value; });
  });
  return sums;
}

// Of the entries in the columns of reservoirs. Particles don't count as such.
template <class Rows>
std::vector<double> reservoir_sums(const System& system, const Rows& matrix) {
  std::vector<double> sums(system.nodes->count(), 0.0);
  parallel_for(matrix.rows(), [&](std::size_t i) {
    const auto columns = matrix.columns(i);
    const auto values = matrix.values(i);
    for (std::size_t k = columns.size(); k-- > 0 && columns[k] >= system.nodes->solids();)
      if (system.stores[columns[k]] == 0) sums[i] += values[k];
  });
  return sums;
}

}  // namespace

Linearisation::Linearisation(const System& system)
    : system_(system),
      conduction_sum_(row_sums(system.conductance, system.nodes->count())),
      exchange_sum_(row_sums(system.exchange, system.nodes->count())),
      conduction_out_(reservoir_sums(system, system.conductance)),
      exchange_out_(reservoir_sums(system, system.exchange)),
      emission_slope_(system.nodes->count()),
      capacity_(system.nodes->solids(), 1.0),
      cell_capacity_(system.nodes->cells, 1.0),
      reactions_(system.reactants.size()) {
  for (const WallProfile& wall : system.profiles) {
    const auto& column = system.nodes->columns[wall.surface];
    for (std::size_t j = 0; j < column.size(); ++j)
      cell_capacity_[wall.first_cell + j] = column.capacity[j] * wall.area;
  }
}

void Linearisation::fix(double t, std::span<const double> y, const Evaluation& at) {
  sums_gamma_ = 0.0;
  parallel_for(emission_slope_.size(), [&](std::size_t i) {
    const double T = at.temperature[i];
    emission_slope_[i] = 4.0 * stefan_boltzmann * T * T * T;
  });
  parallel_for(capacity_.size(), [&](std::size_t id) {
    if (system_.stores[id] != 0)
      capacity_[id] =
          chemistry::heat_capacity(system_.solid[id], at.temperature[id], delta_of(system_, y, id));
  });
  parallel_for(reactions_.size(), [&](std::size_t k) {
    const Reactant& grain = system_.reactants[k];
    const double T = at.temperature[grain.id];
    const auto slopes = chemistry::oxygen_rate_slopes(*system_.solid[grain.id].material->redox,
                                                      rate_state(system_, y, at, k));
    const auto oxygen = chemistry::oxygen_heat(T);
    const double v = grain.volume;
    reactions_[k] = {v * slopes.rate,
                     v * slopes.by_temperature,
                     v * slopes.by_delta,
                     v * slopes.by_oxygen_pressure,
                     oxygen.enthalpy,
                     oxygen.heat_capacity,
                     chemistry::enthalpy_bond_slope(system_.solid[grain.id], T, at.bond[k]),
                     grain.iron,
                     grain.id,
                     system_.body_of(grain.id)};
  });
  fix_gas(t, y);
}

void Linearisation::fix_gas(double t, std::span<const double> y) {
  const std::size_t bodies = system_.bodies();
  const auto size = static_cast<Eigen::Index>(3 * bodies);
  gas_jacobian_ = Eigen::MatrixXd::Zero(size, size);
  temperature_row_.assign(bodies, Vec3::Zero());
  pressure_row_.assign(bodies, Vec3::Zero());
  if (bodies == 0) return;
  const Eigen::VectorXd gas = gas_part(y);
  const std::vector<double> temperature =
      gas_rates(system_, t, {gas.data(), 3 * bodies}).body_temperature;
  const auto rates_at = [&](const Eigen::VectorXd& shifted) {
    const auto rate = gas_rates(system_, t, {shifted.data(), 3 * bodies}).rate;
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(rate.data(), size));
  };
  for (std::size_t body = 0; body < bodies; ++body) {
    const auto first = static_cast<Eigen::Index>(3 * body);
    const chemistry::GasAmount amount{gas[first], gas[first + 1]};
    const double T = temperature[body], total = chemistry::total(amount);
    const double capacity = chemistry::heat_capacity_constant_volume(amount, T);
    const double volume = body < system_.pores.layers.size() ? system_.pores.layers[body].volume
                                                             : system_.free_volume;
    temperature_row_[body] = Vec3(-chemistry::internal_energy({1.0, 0.0}, T),
                                  -chemistry::internal_energy({0.0, 1.0}, T), 1.0) /
                             capacity;
    pressure_row_[body] = gas[first] * temperature_row_[body];
    pressure_row_[body][0] += T;
    pressure_row_[body] *= gas_constant / volume;
    const double moles = 1e-7 * total;
    const Vec3 step(moles, moles, moles * capacity * T / total);
    for (Eigen::Index k = 0; k < 3; ++k) {
      Eigen::VectorXd up = gas, down = gas;
      up[first + k] += step[k];
      down[first + k] -= step[k];
      gas_jacobian_.col(first + k) = (rates_at(up) - rates_at(down)) / (2.0 * step[k]);
    }
  }
}

Eigen::VectorXd Linearisation::gas_part(std::span<const double> v) const {
  return Eigen::Map<const Eigen::VectorXd>(v.data() + system_.gas_begin(),
                                           static_cast<Eigen::Index>(3 * system_.bodies()));
}

std::vector<double> Linearisation::pressure_changes(const Eigen::VectorXd& gas) const {
  std::vector<double> change(system_.bodies());
  for (std::size_t body = 0; body < change.size(); ++body)
    change[body] = pressure_row_[body].dot(gas.segment<3>(static_cast<Eigen::Index>(3 * body)));
  return change;
}

std::vector<double> Linearisation::film_changes(const Eigen::VectorXd& gas,
                                                const std::vector<double>& change) const {
  auto heat = layer_means(system_.pores, [&](std::size_t node) { return change[node]; });
  for (std::size_t k = 0; k < heat.size(); ++k) {
    const double dT = temperature_row_[k].dot(gas.segment<3>(static_cast<Eigen::Index>(3 * k)));
    heat[k] = system_.pores.layers[k].film * (dT - heat[k]);
  }
  return heat;
}

void Linearisation::temperature_changes(std::span<const double> v,
                                        std::vector<double>& change) const {
  change.assign(system_.nodes->count(), 0.0);
  parallel_for(capacity_.size(), [&](std::size_t id) {
    if (system_.stores[id] == 0) return;
    double energy = v[id];
    const std::uint32_t k = system_.reactant_of[id];
    if (k != System::no_reactant)
      energy -= reactions_[k].delta_slope * v[system_.delta_begin() + k];
    change[id] = energy / capacity_[id];
  });
  for (const WallProfile& wall : system_.profiles)
    change[wall.node] = v[system_.cell_begin() + wall.first_cell] / cell_capacity_[wall.first_cell];
  if (system_.closed) {
    const double* const chamber = v.data() + system_.chamber_begin();
    change[system_.nodes->gas()] =
        temperature_row_.back().dot(Vec3(chamber[0], chamber[1], chamber[2]));
  }
}

double Linearisation::heat_change(std::size_t i, const std::vector<double>& change,
                                  const std::vector<double>& emission_change) const {
  double heat =
      sum_row(system_.conductance, i, [&](std::uint32_t j, double w) { return w * change[j]; }) -
      conduction_sum_[i] * change[i];
  const RoundedRows& g = system_.exchange;
  if (i >= g.rows()) return heat;
  heat += sum_row(g, i, [&](std::uint32_t j, double G) { return G * emission_change[j]; }) -
          exchange_sum_[i] * emission_change[i];
  return heat;
}

void Linearisation::wall_product(const std::vector<double>& heat, std::span<const double> v,
                                 std::span<double> jv) const {
  for (const WallProfile& wall : system_.profiles) {
    const std::size_t cells = wall.conductance.size();
    const std::size_t first = system_.cell_begin() + wall.first_cell;
    double inflow = heat[wall.node];
    for (std::size_t j = 0; j < cells; ++j) {
      const double here = v[first + j] / cell_capacity_[wall.first_cell + j];
      const double next =
          j + 1 < cells ? v[first + j + 1] / cell_capacity_[wall.first_cell + j + 1] : 0.0;
      const double outflow = wall.area * wall.conductance[j] * (here - next);
      jv[first + j] = inflow - outflow;
      inflow = outflow;
    }
  }
}

Linearisation::Mat32 Linearisation::gas_slopes(const Reaction& r) const {
  const double capacity = capacity_[r.id];
  const double release_H = r.by_T / capacity;
  const double release_delta = r.by_delta - release_H * r.delta_slope;
  const double warming = r.release * r.oxygen_capacity / capacity;  // n c_O2 dT/dH
  Mat32 slopes;
  slopes << release_H, release_delta,  //
      0.0, 0.0,                        //
      release_H * r.oxygen_heat + warming, release_delta * r.oxygen_heat - warming * r.delta_slope;
  return slopes;
}

Linearisation::Given Linearisation::given_change(const Reaction& r, std::size_t k,
                                                 std::span<const double> v,
                                                 const std::vector<double>& change,
                                                 const std::vector<double>& pressure) const {
  const double dT = change[r.id];
  const double release = r.by_T * dT + r.by_delta * v[system_.delta_begin() + k] +
                         (r.body == System::no_body ? 0.0 : r.by_pressure * pressure[r.body]);
  return {release, release * r.oxygen_heat + r.release * r.oxygen_capacity * dT};
}

void Linearisation::product(std::span<const double> v, std::span<double> jv) const {
  std::vector<double> change, heat(system_.nodes->count()), emission_change(heat.size());
  temperature_changes(v, change);
  parallel_for(heat.size(),
               [&](std::size_t i) { emission_change[i] = emission_slope_[i] * change[i]; });
  parallel_for(heat.size(),
               [&](std::size_t i) { heat[i] = heat_change(i, change, emission_change); });
  const Eigen::VectorXd gas = gas_part(v);
  const std::vector<double> pressure = pressure_changes(gas), film = film_changes(gas, change);
  const PoreSpace& pores = system_.pores;
  parallel_for(capacity_.size(), [&](std::size_t id) {
    jv[id] = system_.stores[id] != 0 ? heat[id] : 0.0;
    if (id < pores.share.size()) jv[id] += pores.share[id] * film[pores.layer_of[id]];
  });
  const auto given =
      given_by_bed(v, change, pressure, [&](const Reaction& r, std::size_t k, const Given& one) {
        jv[r.id] -= one.energy;
        jv[system_.delta_begin() + k] = 2.0 * one.oxygen / r.iron;
      });
  wall_product(heat, v, jv);
  const Eigen::VectorXd rows = gas_rows(gas, given, film, heat[system_.nodes->gas()]);
  for (std::size_t k = 0; k < given.size(); ++k)
    jv[system_.gas_begin() + k] = rows[static_cast<Eigen::Index>(k)];
}

Eigen::VectorXd Linearisation::gas_rows(const Eigen::VectorXd& gas,
                                        const std::vector<double>& given,
                                        const std::vector<double>& film, double to_chamber) const {
  Eigen::VectorXd rows = gas_jacobian_ * gas;
  for (std::size_t k = 0; k < given.size(); ++k) rows[static_cast<Eigen::Index>(k)] += given[k];
  for (std::size_t k = 0; k < film.size(); ++k)
    rows[static_cast<Eigen::Index>(3 * k + 2)] -= film[k];
  if (system_.closed) rows[rows.size() - 1] += to_chamber;
  return rows;
}

}  // namespace pmr::coupling
