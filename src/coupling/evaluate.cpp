// The right-hand side of the network: temperatures, heat flows, reaction, gas.
#include <Eigen/Core>
#include <cmath>

#include "chemistry/chamber.hpp"
#include "coupling/system.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

GasRates gas_rates(const System& system, double t, std::span<const double, 3> y) {
  const ChamberCase& chamber = *system.kase->chamber;
  const chemistry::GasAmount gas{y[0], y[1]};
  const double amount = chemistry::total(gas), x = chemistry::oxygen_fraction(gas);
  GasRates r{};
  r.temperature = chemistry::gas_temperature(gas, y[2], chamber.gas_temperature);
  r.pressure = chemistry::gas_pressure(amount, r.temperature, system.free_volume);
  r.oxygen_pressure = x * r.pressure;
  const double out =
      chamber.pump ? chemistry::pump_outflow(*chamber.pump, r.pressure, r.temperature, t) : 0.0;
  const double in = chemistry::leak_inflow(chamber, r.pressure);
  r.oxygen_pumped = x * out;
  r.nitrogen_pumped = (1.0 - x) * out;
  r.oxygen_leaked = chamber.oxygen_fraction * in;
  r.nitrogen_leaked = (1.0 - chamber.oxygen_fraction) * in;
  r.energy_pumped = chemistry::enthalpy({r.oxygen_pumped, r.nitrogen_pumped}, r.temperature);
  r.energy_leaked =
      chemistry::enthalpy({r.oxygen_leaked, r.nitrogen_leaked}, chamber.gas_temperature);
  return r;
}

namespace {

void find_gas(const System& system, double t, std::span<const double> y, Evaluation& at) {
  if (!system.closed) {
    at.gas = {};
    at.gas.oxygen_pressure = system.air_oxygen_pressure;
    return;
  }
  at.gas = gas_rates(system, t, std::span<const double, 3>(y.data() + system.gas_begin(), 3));
  at.temperature[system.nodes->gas()] = at.gas.temperature;
}

void find_temperatures(const System& system, std::span<const double> y, Evaluation& at) {
  parallel_for(system.nodes->solids(), [&](std::size_t id) {
    if (system.stores[id] == 0) return;
    at.temperature[id] = chemistry::temperature(system.solid[id], y[id], delta_of(system, y, id),
                                                at.temperature[id]);
  });
  at.wall_temperature.resize(system.nodes->cells);
  for (const WallProfile& wall : system.profiles) {
    const std::size_t cells = wall.conductance.size();
    const auto energy = y.subspan(system.cell_begin() + wall.first_cell, cells);
    const std::span<double> T(at.wall_temperature.data() + wall.first_cell, cells);
    physics::column_temperatures(system.nodes->columns[wall.surface], wall.area, energy, T);
    at.temperature[wall.node] = T[0];
  }
}

// Q_i = sum_j w_ij (T_j - T_i) + sum_j G_ij (sigma T_j^4 - sigma T_i^4), gathered row by row.
void gather_heat(const System& system, Evaluation& at) {
  const std::vector<double>&T = at.temperature, &E = at.emission;
  const Csr* g = system.exchange;
  parallel_for(system.conductance.rows(), [&](std::size_t i) {
    at.heat[i] = sum_row(system.conductance, i,
                         [&](std::uint32_t j, double w) { return w * (T[j] - T[i]); });
    if (g != nullptr && i < g->rows())
      at.heat[i] += sum_row(*g, i, [&](std::uint32_t j, double G) { return G * (E[j] - E[i]); });
  });
}

bool react(const System& system, std::span<const double> y, Evaluation& at) {
  at.release.resize(system.reactants.size());
  parallel_for(system.reactants.size(), [&](std::size_t k) {
    const Reactant& grain = system.reactants[k];
    const Redox& redox = *system.solid[grain.id].material->redox;
    const double delta = y[system.delta_begin() + k];
    at.release[k] = grain.volume * chemistry::oxygen_rate(redox, {at.temperature[grain.id], delta,
                                                                  at.gas.oxygen_pressure});
  });
  for (const double r : at.release)
    if (!std::isfinite(r)) return false;
  return true;
}

}  // namespace

bool evaluate(const System& system, double t, std::span<const double> y, Evaluation& at) {
  if (at.temperature.size() != system.nodes->count()) at.temperature = system.held_temperature;
  try {
    find_gas(system, t, y, at);
    find_temperatures(system, y, at);
  } catch (const NumericsError&) {
    return false;  // no temperature belongs to these energies
  }
  at.emission.resize(at.temperature.size());
  at.heat.resize(at.temperature.size());
  parallel_for(at.emission.size(), [&](std::size_t i) {
    const double square = at.temperature[i] * at.temperature[i];
    at.emission[i] = stefan_boltzmann * square * square;
  });
  gather_heat(system, at);
  return react(system, y, at);
}

void fill_rates(const System& system, const Evaluation& at, std::span<double> rate) {
  parallel_for(system.nodes->solids(),
               [&](std::size_t id) { rate[id] = system.stores[id] != 0 ? at.heat[id] : 0.0; });
  // [mol/s], [W] given to the gas
  const Eigen::Vector2d given =
      parallel_sum(system.reactants.size(), Eigen::Vector2d(0.0, 0.0), [&](std::size_t k) {
        const Reactant& grain = system.reactants[k];
        const double heat =
            at.release[k] * chemistry::oxygen_heat(at.temperature[grain.id]).enthalpy;
        rate[grain.id] -= heat;
        rate[system.delta_begin() + k] = 2.0 * at.release[k] / grain.iron;
        return Eigen::Vector2d(at.release[k], heat);
      });
  for (const WallProfile& wall : system.profiles) {
    const std::size_t cells = wall.conductance.size();
    physics::column_rates(system.nodes->columns[wall.surface], {wall.area, at.heat[wall.node]},
                          {at.wall_temperature.data() + wall.first_cell, cells}, wall.conductance,
                          rate.subspan(system.cell_begin() + wall.first_cell, cells));
  }
  if (!system.closed) return;
  const GasRates& g = at.gas;
  rate[system.gas_begin()] = given[0] - g.oxygen_pumped + g.oxygen_leaked;
  rate[system.gas_begin() + 1] = g.nitrogen_leaked - g.nitrogen_pumped;
  rate[system.gas_begin() + 2] =
      given[1] - g.energy_pumped + g.energy_leaked + at.heat[system.nodes->gas()];
}

}  // namespace pmr::coupling
