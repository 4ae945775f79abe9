#include "coupling/system.hpp"

#include <algorithm>
#include <numeric>

#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// Between whom heat is booked; particles come with their lists.
void list_groups(const Case& c, const Particles& p, System& system) {
  const Nodes& nodes = *system.nodes;
  system.groups = {c.species.size()};
  const auto number = [](std::size_t group) { return static_cast<std::uint16_t>(group); };
  system.group.assign(nodes.count(), 0);
  for (std::size_t k = 0; k < nodes.patches.size(); ++k)
    system.group[nodes.patch(k)] = number(system.groups.walls());
  system.group[nodes.surroundings()] = number(system.groups.surroundings());
  system.group[nodes.gas()] = number(system.groups.gas());
  std::vector<std::size_t> count(c.species.size(), 0);
  for (const SpeciesIndex species : p.species) ++count[species];
  std::vector<std::uint32_t> order(c.species.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return count[a] < count[b]; });
  system.rarity.resize(order.size());
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) system.rarity[order[rank]] = rank;
}

void list_particles(const Case& c, const State& state, System& system) {
  const Particles& p = state.particles;
  const Nodes& nodes = *system.nodes;
  const auto parts = static_cast<double>(nodes.shells);
  system.solid.assign(nodes.solids(), {nullptr, 0.0});
  system.reactant_of.assign(nodes.solids(), System::no_reactant);
  system.delta.assign(nodes.solids(), 0.0);
  std::vector<std::uint32_t> place(nodes.particles, System::no_reactant);
  for (std::size_t i = 0; i < p.size(); ++i) {
    place[nodes.particle(p.id[i])] = static_cast<std::uint32_t>(i);
    for (std::size_t k = 0; k < nodes.shells; ++k) {
      const Node node = nodes.shell(p.id[i], k);
      system.solid[node] = solid_of(c, p, i);
      system.solid[node].amount /= parts;
      system.delta[node] =
          nodes.shells > 1 ? state.shells.delta[nodes.kept(p.id[i], k)] : p.delta[i];
      system.group[node] = p.species[i];
      system.stores[node] = 1;
      system.held_temperature[node] = p.temperature[i];  // first guess of the inversion
    }
  }
  if (!c.models.reaction) return;
  for (Node node = 0; node < nodes.solids(); ++node) {
    const std::uint32_t i = place[node % nodes.particles];
    if (i == System::no_reactant || !system.solid[node].material->redox) continue;
    const double r = p.radius[i];
    system.reactant_of[node] = static_cast<std::uint32_t>(system.reactants.size());
    system.reactants.push_back(
        {node, 4.0 / 3.0 * pi * r * r * r / parts, p.formula_units[i] / parts, r});
  }
}

void list_profiles(const Case& c, const Outlook& outlook, System& system) {
  const Nodes& nodes = *system.nodes;
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
    const Patch& patch = nodes.patches[k];
    const Surface& surface = c.walls.surfaces[patch.surface];
    if (const auto* held = std::get_if<FixedTemperature>(&surface.thermal))
      system.held_temperature[nodes.patch(k)] = held->temperature;
    const auto& column = nodes.columns[patch.surface];
    if (column.size() == 0) continue;
    WallProfile profile{nodes.patch(k), patch.surface, patch.first_cell, patch.area, {}, {}};
    std::vector<double> temperature(column.size());
    profile.conductance.resize(column.size());
    physics::column_temperatures(
        column, patch.area, {outlook.walls.cell_energy.data() + patch.first_cell, column.size()},
        temperature);
    physics::column_conductances(column, c.materials, outlook.gas.pressure, temperature,
                                 profile.conductance);
    for (const double per_area : column.capacity) profile.capacity.push_back(per_area * patch.area);
    system.stores[nodes.patch(k)] = 1;
    system.profiles.push_back(std::move(profile));
  }
}

}  // namespace

System assemble_system(const Case& c, const Nodes& nodes, const State& state,
                       const Outlook& outlook, std::vector<HeatLink> links, PoreSpace pores) {
  System system;
  system.setup = &c;
  system.nodes = &nodes;
  if (state.exchange.factor.rows() > 0) system.exchange = RoundedRows(state.exchange.factor);
  system.conductance = symmetric_rows(links, nodes.count());
  system.links = std::move(links);
  system.stores.assign(nodes.count(), 0);
  const Atmosphere air = atmosphere(c, state);
  system.held_temperature.assign(nodes.count(), air.temperature);
  if (c.models.radiation)
    system.held_temperature[nodes.surroundings()] = c.models.radiation->surroundings;
  list_groups(c, state.particles, system);
  list_particles(c, state, system);
  list_profiles(c, outlook, system);
  system.pores = std::move(pores);
  system.closed = state.gas.closed;
  system.stores[nodes.gas()] = system.closed ? 1 : 0;
  system.free_volume = system.closed ? gas_free_volume(c, state) : 0.0;
  system.air_oxygen_pressure = air.oxygen_fraction * air.pressure;
  return system;
}

std::vector<double> pack(const System& system, const State& state) {
  std::vector<double> y(system.size(), 0.0);
  const Particles& p = state.particles;
  const Nodes& nodes = *system.nodes;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < nodes.shells; ++k) {
      const Node node = nodes.shell(p.id[i], k);
      y[node] = nodes.shells > 1 ? state.shells.enthalpy[nodes.kept(p.id[i], k)] : p.enthalpy[i];
      const std::uint32_t reactant = system.reactant_of[node];
      if (reactant != System::no_reactant) y[system.delta_begin() + reactant] = system.delta[node];
    }
  std::copy(state.walls.cell_energy.begin(), state.walls.cell_energy.end(),
            y.begin() + static_cast<std::ptrdiff_t>(system.cell_begin()));
  const Gas& gas = state.gas;
  for (std::size_t k = 0; k < system.pores.layers.size(); ++k) {
    double* const layer = y.data() + system.gas_begin() + 3 * k;
    layer[0] = gas.pore_oxygen[k];
    layer[1] = gas.pore_nitrogen[k];
    layer[2] = gas.pore_energy[k];
  }
  if (system.closed) {
    y[system.chamber_begin()] = gas.oxygen;
    y[system.chamber_begin() + 1] = gas.nitrogen;
    y[system.chamber_begin() + 2] = gas.energy;
  }
  return y;
}

void unpack(const System& system, std::span<const double> y, State& state) {
  Particles& p = state.particles;
  const Nodes& nodes = *system.nodes;
  const auto parts = static_cast<double>(nodes.shells);
  parallel_for(p.size(), [&](std::size_t i) {
    double enthalpy = 0.0, delta = 0.0;
    for (std::size_t k = 0; k < nodes.shells; ++k) {
      const Node node = nodes.shell(p.id[i], k);
      enthalpy += y[node];
      delta += delta_of(system, y, node);
      if (nodes.shells == 1) continue;
      state.shells.enthalpy[nodes.kept(p.id[i], k)] = y[node];
      state.shells.delta[nodes.kept(p.id[i], k)] = delta_of(system, y, node);
    }
    p.enthalpy[i] = enthalpy;
    p.delta[i] = delta / parts;
    chemistry::Solid whole = system.solid[nodes.particle(p.id[i])];
    whole.amount *= parts;
    p.temperature[i] = chemistry::temperature(whole, enthalpy, p.delta[i], p.temperature[i]);
  });
  for (std::size_t k = 0; k < system.nodes->cells; ++k)
    state.walls.cell_energy[k] = y[system.cell_begin() + k];
  Gas& gas = state.gas;
  for (std::size_t k = 0; k < system.pores.layers.size(); ++k) {
    const double* const layer = y.data() + system.gas_begin() + 3 * k;
    gas.pore_oxygen[k] = layer[0];
    gas.pore_nitrogen[k] = layer[1];
    gas.pore_energy[k] = layer[2];
  }
  if (!system.closed) return;
  gas.oxygen = y[system.chamber_begin()];
  gas.nitrogen = y[system.chamber_begin() + 1];
  gas.energy = y[system.chamber_begin() + 2];
}

}  // namespace pmr::coupling
