#include "coupling/linearisation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

std::vector<double> row_sums(const Csr* matrix, std::size_t rows) {
  std::vector<double> sums(rows, 0.0);
  if (matrix != nullptr)
    parallel_for(matrix->rows(), [&](std::size_t i) {
      sums[i] = sum_row(*matrix, i, [](std::uint32_t, double value) { return value; });
    });
  return sums;
}

// Of the entries in the columns of reservoirs. Particles don't count as such.
std::vector<double> reservoir_sums(const System& system, const Csr* matrix) {
  std::vector<double> sums(system.nodes->count(), 0.0);
  if (matrix == nullptr) return sums;
  parallel_for(matrix->rows(), [&](std::size_t i) {
    const auto columns = matrix->columns(i);
    const auto values = matrix->values(i);
    for (std::size_t k = columns.size(); k-- > 0 && columns[k] >= system.nodes->solids();)
      if (system.stores[columns[k]] == 0) sums[i] += values[k];
  });
  return sums;
}

Vec3 net_gas_rates(const System& system, double t, const Vec3& gas) {
  const GasRates g = gas_rates(system, t, std::span<const double, 3>(gas.data(), 3));
  return {g.oxygen_leaked - g.oxygen_pumped, g.nitrogen_leaked - g.nitrogen_pumped,
          g.energy_leaked - g.energy_pumped};
}

}  // namespace

Linearisation::Linearisation(const System& system)
    : system_(system),
      conduction_sum_(row_sums(&system.conductance, system.nodes->count())),
      exchange_sum_(row_sums(system.exchange, system.nodes->count())),
      conduction_out_(reservoir_sums(system, &system.conductance)),
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
    const double T = at.temperature[grain.id], delta = y[system_.delta_begin() + k];
    const auto slopes = chemistry::oxygen_rate_slopes(*system_.solid[grain.id].material->redox,
                                                      {T, delta, at.gas.oxygen_pressure});
    const auto oxygen = chemistry::oxygen_heat(T);
    const double v = grain.volume;
    reactions_[k] = {v * slopes.rate,
                     v * slopes.by_temperature,
                     v * slopes.by_delta,
                     v * slopes.by_oxygen_pressure,
                     oxygen.enthalpy,
                     oxygen.heat_capacity,
                     chemistry::enthalpy_delta_slope(system_.solid[grain.id], T, delta),
                     grain.iron,
                     grain.id};
  });
  if (system_.closed) fix_gas(t, y);
}

void Linearisation::fix_gas(double t, std::span<const double> y) {
  const Vec3 gas(y[system_.gas_begin()], y[system_.gas_begin() + 1], y[system_.gas_begin() + 2]);
  const GasRates g = gas_rates(system_, t, std::span<const double, 3>(gas.data(), 3));
  const chemistry::GasAmount amount{gas[0], gas[1]};
  const double capacity = chemistry::heat_capacity_constant_volume(amount, g.temperature);
  temperature_row_ = Vec3(-chemistry::internal_energy({1.0, 0.0}, g.temperature),
                          -chemistry::internal_energy({0.0, 1.0}, g.temperature), 1.0) /
                     capacity;
  pressure_row_ = gas[0] * temperature_row_;
  pressure_row_[0] += g.temperature;
  pressure_row_ *= gas_constant / system_.free_volume;

  const double moles = 1e-6 * chemistry::total(amount);
  const Vec3 step(moles, moles, moles * capacity * g.temperature / chemistry::total(amount));
  for (int k = 0; k < 3; ++k) {
    const Vec3 shift = step[k] * Vec3::Unit(k);
    gas_jacobian_.col(k) =
        (net_gas_rates(system_, t, gas + shift) - net_gas_rates(system_, t, gas - shift)) /
        (2.0 * step[k]);
  }
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
  if (system_.closed)
    change[system_.nodes->gas()] = temperature_row_.dot(
        Vec3(v[system_.gas_begin()], v[system_.gas_begin() + 1], v[system_.gas_begin() + 2]));
}

double Linearisation::heat_change(std::size_t i, const std::vector<double>& change,
                                  const std::vector<double>& emission_change) const {
  double heat =
      sum_row(system_.conductance, i, [&](std::uint32_t j, double w) { return w * change[j]; }) -
      conduction_sum_[i] * change[i];
  const Csr* g = system_.exchange;
  if (g == nullptr || i >= g->rows()) return heat;
  heat += sum_row(*g, i, [&](std::uint32_t j, double G) { return G * emission_change[j]; }) -
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

void Linearisation::product(std::span<const double> v, std::span<double> jv) const {
  std::vector<double> change, heat(system_.nodes->count()), emission_change(heat.size());
  temperature_changes(v, change);
  parallel_for(heat.size(),
               [&](std::size_t i) { emission_change[i] = emission_slope_[i] * change[i]; });
  parallel_for(heat.size(),
               [&](std::size_t i) { heat[i] = heat_change(i, change, emission_change); });
  parallel_for(capacity_.size(),
               [&](std::size_t id) { jv[id] = system_.stores[id] != 0 ? heat[id] : 0.0; });
  const std::size_t gas = system_.gas_begin();
  const Vec3 dgas = system_.closed ? Vec3(v[gas], v[gas + 1], v[gas + 2]) : Vec3(Vec3::Zero());
  const double pressure = pressure_row_.dot(dgas);
  Vec3 to_gas = gas_jacobian_ * dgas;
  to_gas += parallel_sum(reactions_.size(), Vec3(Vec3::Zero()), [&](std::size_t k) {
    const Reaction& r = reactions_[k];
    const double dT = change[r.id];
    const double release =
        r.by_T * dT + r.by_delta * v[system_.delta_begin() + k] + r.by_pressure * pressure;
    const double energy = release * r.oxygen_heat + r.release * r.oxygen_capacity * dT;
    jv[r.id] -= energy;
    jv[system_.delta_begin() + k] = 2.0 * release / r.iron;
    return Vec3(release, 0.0, energy);
  });
  wall_product(heat, v, jv);
  if (!system_.closed) return;
  to_gas[2] += heat[system_.nodes->gas()];
  for (std::size_t k = 0; k < 3; ++k) jv[gas + k] = to_gas[static_cast<Eigen::Index>(k)];
}

}  // namespace pmr::coupling
