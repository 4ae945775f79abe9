#include "coupling/slopes.hpp"

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

RowSums::RowSums(const System& system)
    : conduction(row_sums(system.conductance, system.nodes->count())),
      exchange(row_sums(system.exchange, system.nodes->count())),
      conduction_out(reservoir_sums(system, system.conductance)),
      exchange_out(reservoir_sums(system, system.exchange)) {}

HeatSlopes::HeatSlopes(const RowSums& row_sums, const Evaluation& at)
    : sums(&row_sums), emission(at.temperature.size()) {
  parallel_for(emission.size(), [&](std::size_t i) {
    const double T = at.temperature[i];
    emission[i] = 4.0 * stefan_boltzmann * T * T * T;
  });
}

std::vector<ReactionSlopes> reaction_slopes(const System& system, std::span<const double> y,
                                            const Evaluation& at) {
  std::vector<ReactionSlopes> reactions(system.reactants.size());
  parallel_for(reactions.size(), [&](std::size_t k) {
    const Reactant& grain = system.reactants[k];
    const double T = at.temperature[grain.id];
    const auto slopes = chemistry::oxygen_rate_slopes(*system.solid[grain.id].material->redox,
                                                      rate_state(system, y, at, k));
    const auto oxygen = chemistry::oxygen_heat(T);
    const double v = grain.volume;
    reactions[k] = {v * slopes.rate,
                    v * slopes.by_temperature,
                    v * slopes.by_delta,
                    v * slopes.by_oxygen_pressure,
                    oxygen.enthalpy,
                    oxygen.heat_capacity,
                    chemistry::enthalpy_bond_slope(system.solid[grain.id], T, at.bond[k]),
                    grain.formula_units,
                    grain.id,
                    system.zone_of(grain.id)};
  });
  return reactions;
}

Eigen::VectorXd gas_part(const System& system, std::span<const double> v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data() + system.gas_begin(),
                                           static_cast<Eigen::Index>(3 * system.zones()));
}

GasSlopes::GasSlopes(const System& system, double t, std::span<const double> y)
    : temperature(system.zones(), Vec3::Zero()), pressure(system.zones(), Vec3::Zero()) {
  const std::size_t zones = system.zones();
  const auto size = static_cast<Eigen::Index>(3 * zones);
  rates = Eigen::MatrixXd::Zero(size, size);
  if (zones == 0) return;
  const Eigen::VectorXd gas = gas_part(system, y);
  const std::vector<double> T_of = gas_rates(system, t, {gas.data(), 3 * zones}).zone_temperature;
  const auto rates_at = [&](const Eigen::VectorXd& shifted) {
    const auto rate = gas_rates(system, t, {shifted.data(), 3 * zones}).rate;
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(rate.data(), size));
  };
  for (std::size_t zone = 0; zone < zones; ++zone) {
    const auto first = static_cast<Eigen::Index>(3 * zone);
    const chemistry::GasAmount amount{gas[first], gas[first + 1]};
    const double T = T_of[zone], total = chemistry::total(amount);
    const double capacity = chemistry::heat_capacity_constant_volume(amount, T);
    const double volume =
        zone < system.pores.layers.size() ? system.pores.layers[zone].volume : system.free_volume;
    temperature[zone] = Vec3(-chemistry::internal_energy({1.0, 0.0}, T),
                             -chemistry::internal_energy({0.0, 1.0}, T), 1.0) /
                        capacity;
    pressure[zone] = gas[first] * temperature[zone];
    pressure[zone][0] += T;
    pressure[zone] *= gas_constant / volume;
    const double moles = 1e-7 * total;
    const Vec3 step(moles, moles, moles * capacity * T / total);
    for (Eigen::Index k = 0; k < 3; ++k) {
      Eigen::VectorXd up = gas, down = gas;
      up[first + k] += step[k];
      down[first + k] -= step[k];
      rates.col(first + k) = (rates_at(up) - rates_at(down)) / (2.0 * step[k]);
    }
  }
}

}  // namespace pmr::coupling
