// The right-hand side of the network: temperatures, heat flows, reaction, gas.
#include <cmath>

#include "chemistry/redox.hpp"
#include "coupling/system.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

namespace {

void find_gas(const System& system, double t, std::span<const double> y, Evaluation& at) {
  if (system.zones() == 0) {
    at.gas = {};
    at.gas.oxygen_pressure = system.air_oxygen_pressure;
    return;
  }
  at.gas = gas_rates(system, t, y.subspan(system.gas_begin()));
  at.temperature[system.nodes->gas()] = at.gas.temperature;
}

// The gas of a layer warms the mean of its particles, and each of them by its share: particles of
// one layer don't exchange heat by way of their gas, which gaps between them do already.
void find_film_heat(const System& system, Evaluation& at) {
  const auto mean =
      layer_means(system.pores, [&](std::size_t node) { return at.temperature[node]; });
  at.film_heat.resize(mean.size());
  for (std::size_t k = 0; k < mean.size(); ++k)
    at.film_heat[k] = system.pores.layers[k].film * (at.gas.zone_temperature[k] - mean[k]);
}

void find_temperatures(const System& system, std::span<const double> y, Evaluation& at) {
  at.bond.resize(system.reactants.size());
  parallel_for(system.nodes->solids(), [&](std::size_t id) {
    if (system.stores[id] == 0) return;
    const chemistry::Solid& solid = system.solid[id];
    const double delta = delta_of(system, y, id);
    double& T = at.temperature[id];
    const std::uint32_t k = system.reactant_of[id];
    if (k == System::no_reactant) {
      T = chemistry::temperature(solid, y[id], delta, T);
      return;
    }
    const auto bond = chemistry::bond_at(solid.material->redox->equilibrium, delta);
    at.bond[k] = bond.enthalpy;
    T = chemistry::redox_temperature(solid, y[id], delta, bond.heat, T);
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
  const RoundedRows& g = system.exchange;
  at.heat.resize(T.size());
  parallel_for(system.conductance.rows(), [&](std::size_t i) {
    at.heat[i] = sum_row(system.conductance, i,
                         [&](std::uint32_t j, double w) { return w * (T[j] - T[i]); });
    if (i < g.rows())
      at.heat[i] += sum_row(g, i, [&](std::uint32_t j, double G) { return G * (E[j] - E[i]); });
    if (i < system.pores.share.size())
      at.heat[i] += system.pores.share[i] * at.film_heat[system.pores.layer_of[i]];
  });
}

bool react(const System& system, std::span<const double> y, Evaluation& at) {
  at.release.resize(system.reactants.size());
  parallel_for(system.reactants.size(), [&](std::size_t k) {
    const Reactant& grain = system.reactants[k];
    const Redox& redox = *system.solid[grain.id].material->redox;
    at.release[k] = grain.volume * chemistry::oxygen_rate(redox, rate_state(system, y, at, k));
  });
  for (const double r : at.release)
    if (!std::isfinite(r)) return false;
  return true;
}

}  // namespace

bool evaluate(const System& system, double t, std::span<const double> y, Evaluation& at) {
  if (!evaluate_without_heat(system, t, y, at)) return false;
  gather_heat(system, at);
  return true;
}

bool evaluate_without_heat(const System& system, double t, std::span<const double> y,
                           Evaluation& at) {
  if (at.temperature.size() != system.nodes->count()) at.temperature = system.held_temperature;
  try {
    find_gas(system, t, y, at);
    find_temperatures(system, y, at);
  } catch (const NumericsError&) {
    return false;  // no temperature belongs to these energies
  }
  at.emission.resize(at.temperature.size());
  parallel_for(at.emission.size(), [&](std::size_t i) {
    const double square = at.temperature[i] * at.temperature[i];
    at.emission[i] = stefan_boltzmann * square * square;
  });
  find_film_heat(system, at);
  return react(system, y, at);
}

void fill_rates(const System& system, const Evaluation& at, std::span<double> rate) {
  parallel_for(system.nodes->solids(),
               [&](std::size_t id) { rate[id] = system.stores[id] != 0 ? at.heat[id] : 0.0; });
  // [mol/s], 0, [W] given to each gas zone
  const auto given = parallel_bins(
      system.reactants.size(), 3 * system.zones(), [&](std::size_t k, std::vector<double>& sums) {
        const Reactant& grain = system.reactants[k];
        const double heat =
            at.release[k] * chemistry::oxygen_heat(at.temperature[grain.id]).enthalpy;
        rate[grain.id] -= heat;
        rate[system.delta_begin() + k] = 2.0 * at.release[k] / grain.formula_units;
        const std::size_t zone = system.zone_of(grain.id);
        if (zone == System::open_air) return;
        sums[3 * zone] += at.release[k];
        sums[3 * zone + 2] += heat;
      });
  for (const WallProfile& wall : system.profiles) {
    const std::size_t cells = wall.conductance.size();
    physics::column_rates(system.nodes->columns[wall.surface], {wall.area, at.heat[wall.node]},
                          {at.wall_temperature.data() + wall.first_cell, cells}, wall.conductance,
                          rate.subspan(system.cell_begin() + wall.first_cell, cells));
  }
  for (std::size_t k = 0; k < given.size(); ++k)
    rate[system.gas_begin() + k] = at.gas.rate[k] + given[k];
  for (std::size_t k = 0; k < at.film_heat.size(); ++k)
    rate[system.gas_begin() + 3 * k + 2] -= at.film_heat[k];
  if (system.closed) rate[system.chamber_begin() + 2] += at.heat[system.nodes->gas()];
}

}  // namespace pmr::coupling
