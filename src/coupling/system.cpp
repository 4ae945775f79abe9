#include "coupling/system.hpp"

#include <algorithm>

#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// Both halves of the matrix of links that stand in order of (a, b), a < b: each row's lower part
// comes in order of a, its upper part in order of b.
Csr symmetric_rows(const std::vector<HeatLink>& links, std::size_t nodes) {
  Csr csr;
  csr.start.assign(nodes + 1, 0);
  for (const HeatLink& link : links) {
    ++csr.start[link.a + 1];
    ++csr.start[link.b + 1];
  }
  for (std::size_t row = 0; row < nodes; ++row) csr.start[row + 1] += csr.start[row];
  csr.column.resize(2 * links.size());
  csr.value.resize(2 * links.size());
  std::vector<std::uint64_t> next(csr.start.begin(), csr.start.end() - 1);
  const auto put = [&](Node row, Node column, const HeatLink& link) {
    csr.column[next[row]] = column;
    csr.value[next[row]++] = link.contact + link.gap;
  };
  for (const HeatLink& link : links) put(link.b, link.a, link);
  for (const HeatLink& link : links) put(link.a, link.b, link);
  return csr;
}

void list_particles(const Case& c, const State& state, System& system) {
  const Particles& p = state.particles;
  const std::size_t inserted = system.nodes->particles;
  system.solid.assign(inserted, {nullptr, 0.0});
  system.reactant_of.assign(inserted, System::no_reactant);
  system.delta.assign(inserted, 0.0);
  std::vector<std::uint32_t> place(inserted, System::no_reactant);
  for (std::size_t i = 0; i < p.size(); ++i) {
    place[p.id[i]] = static_cast<std::uint32_t>(i);
    system.solid[p.id[i]] = solid_of(c, p, i);
    system.delta[p.id[i]] = p.delta[i];
    system.stores[p.id[i]] = 1;
    system.held_temperature[p.id[i]] = p.temperature[i];  // first guess of the inversion
  }
  if (!c.models.reaction) return;
  for (std::uint32_t id = 0; id < inserted; ++id) {
    if (place[id] == System::no_reactant || !system.solid[id].material->redox) continue;
    const double r = p.radius[place[id]];
    system.reactant_of[id] = static_cast<std::uint32_t>(system.reactants.size());
    system.reactants.push_back({id, 4.0 / 3.0 * pi * r * r * r, p.iron[place[id]]});
  }
}

void list_profiles(const Case& c, const State& state, double pressure, System& system) {
  const Nodes& nodes = *system.nodes;
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
    const Patch& patch = nodes.patches[k];
    const Surface& surface = c.walls.surfaces[patch.surface];
    if (const auto* held = std::get_if<FixedTemperature>(&surface.thermal))
      system.held_temperature[nodes.patch(k)] = held->temperature;
    const auto& column = nodes.columns[patch.surface];
    if (column.size() == 0) continue;
    WallProfile profile{nodes.patch(k), patch.surface, patch.first_cell, patch.area, {}};
    std::vector<double> temperature(column.size());
    profile.conductance.resize(column.size());
    physics::column_temperatures(column, patch.area,
                                 {state.walls.cell_energy.data() + patch.first_cell, column.size()},
                                 temperature);
    physics::column_conductances(column, c.materials, pressure, temperature, profile.conductance);
    system.stores[nodes.patch(k)] = 1;
    system.profiles.push_back(std::move(profile));
  }
}

}  // namespace

System assemble_system(const Case& c, const Nodes& nodes, const State& state,
                       std::vector<HeatLink> links) {
  System system;
  system.kase = &c;
  system.nodes = &nodes;
  system.exchange = state.exchange.factor.rows() > 0 ? &state.exchange.factor : nullptr;
  system.conductance = symmetric_rows(links, nodes.count());
  system.links = std::move(links);
  system.stores.assign(nodes.count(), 0);
  const Atmosphere air = atmosphere(c, state);
  system.held_temperature.assign(nodes.count(), air.temperature);
  if (c.models.radiation)
    system.held_temperature[nodes.surroundings()] = c.models.radiation->surroundings;
  list_particles(c, state, system);
  list_profiles(c, state, air.pressure, system);
  system.closed = state.gas.closed;
  system.stores[nodes.gas()] = system.closed ? 1 : 0;
  system.free_volume = system.closed ? gas_free_volume(c, state.particles) : 0.0;
  system.air_oxygen_pressure = air.oxygen_fraction * air.pressure;
  return system;
}

std::vector<double> pack(const System& system, const State& state) {
  std::vector<double> y(system.size(), 0.0);
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    y[p.id[i]] = p.enthalpy[i];
    const std::uint32_t k = system.reactant_of[p.id[i]];
    if (k != System::no_reactant) y[system.delta_begin() + k] = p.delta[i];
  }
  std::copy(state.walls.cell_energy.begin(), state.walls.cell_energy.end(),
            y.begin() + static_cast<std::ptrdiff_t>(system.cell_begin()));
  if (system.closed) {
    y[system.gas_begin()] = state.gas.oxygen;
    y[system.gas_begin() + 1] = state.gas.nitrogen;
    y[system.gas_begin() + 2] = state.gas.energy;
  }
  return y;
}

void unpack(const System& system, std::span<const double> y, State& state) {
  Particles& p = state.particles;
  parallel_for(p.size(), [&](std::size_t i) {
    p.enthalpy[i] = y[p.id[i]];
    const std::uint32_t k = system.reactant_of[p.id[i]];
    if (k != System::no_reactant) p.delta[i] = y[system.delta_begin() + k];
    p.temperature[i] =
        chemistry::temperature(system.solid[p.id[i]], p.enthalpy[i], p.delta[i], p.temperature[i]);
  });
  for (std::size_t k = 0; k < system.nodes->cells; ++k)
    state.walls.cell_energy[k] = y[system.cell_begin() + k];
  if (system.closed) {
    state.gas.oxygen = y[system.gas_begin()];
    state.gas.nitrogen = y[system.gas_begin() + 1];
    state.gas.energy = y[system.gas_begin() + 2];
  }
}

}  // namespace pmr::coupling
