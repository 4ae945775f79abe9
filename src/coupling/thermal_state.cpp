#include "coupling/thermal_state.hpp"

#include <cmath>
#include <limits>

#include "chemistry/chamber.hpp"
#include "chemistry/gas.hpp"
#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

const Material& material_of(const Case& c, const Particles& particles, std::size_t i) {
  return c.materials.list[c.species[particles.species[i]].material];
}

void begin_walls(const Nodes& nodes, WallNodes& walls) {
  walls.cell_energy.assign(nodes.cells, 0.0);
  for (const Patch& patch : nodes.patches) {
    const auto& column = nodes.columns[patch.surface];
    physics::initial_energies(column, patch.area,
                              {walls.cell_energy.data() + patch.first_cell, column.size()});
  }
}

// Every shell has its part of what the particle holds.
void begin_shells(const Nodes& nodes, const Particles& p, Shells& shells) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < nodes.shells; ++k) {
      shells.enthalpy[nodes.kept(p.id[i], k)] = p.enthalpy[i] / static_cast<double>(nodes.shells);
      shells.delta[nodes.kept(p.id[i], k)] = p.delta[i];
    }
}

// C T of particles [J]; zero where they have no temperature (mechanics alone).
double heat_content(const Case& c, const Particles& p) {
  return parallel_sum(p.size(), [&](std::size_t i) {
    const double T = p.temperature[i];
    return T > 0.0 ? T * chemistry::heat_capacity(solid_of(c, p, i), T, p.delta[i]) : 0.0;
  });
}

double heat_content(const Nodes& nodes) {  // of the walls [J]
  double sum = 0.0;
  for (const Patch& patch : nodes.patches) {
    const auto& column = nodes.columns[patch.surface];
    for (const double capacity : column.capacity)
      sum += patch.area * capacity * column.initial_temperature;
  }
  return sum;
}

void open_books(const Case& c, const Nodes& nodes, State& state) {
  Opening& opening = state.opening;
  opening.energy = stored_energy(state);
  opening.oxygen = bound_oxygen(c, state.particles) + bound_oxygen(c, state.waiting);
  opening.particles = state.particles.size() + state.waiting.size();
  opening.heat_content =
      heat_content(c, state.particles) + heat_content(c, state.waiting) + heat_content(nodes);
  const Holdings there = holdings(c, state.particles), waiting = holdings(c, state.waiting);
  opening.species_energy = there.energy;
  opening.species_oxygen = there.oxygen;
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    opening.species_energy[s] += waiting.energy[s];
    opening.species_oxygen[s] += waiting.oxygen[s];
  }
}

}  // namespace

Holdings holdings(const Case& c, const Particles& p) {
  const std::size_t species = c.species.size();
  auto sums = parallel_bins(p.size(), 2 * species, [&](std::size_t i, std::vector<double>& sum) {
    sum[p.species[i]] += p.enthalpy[i];
    if (const auto& redox = material_of(c, p, i).redox)
      sum[species + p.species[i]] += p.formula_units[i] * 0.5 * (redox->oxygen_atoms - p.delta[i]);
  });
  const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(species);
  return {{sums.begin(), middle}, {middle, sums.end()}};
}

double initial_delta(const Case& c, const Species& species) {
  const Material& material = c.materials.list[species.material];
  if (!material.redox) return 0.0;
  if (const auto* given = std::get_if<double>(&species.initial_delta)) return *given;
  const auto& at = std::get<EquilibriumDelta>(species.initial_delta);
  return chemistry::equilibrium_delta(material.redox->equilibrium, at.temperature,
                                      at.oxygen_pressure);
}

chemistry::Solid solid_of(const Case& c, const Particles& particles, std::size_t i) {
  return chemistry::solid_of(material_of(c, particles, i), particles.mass[i],
                             particles.formula_units[i]);
}

void begin_particles(const Case& c, const std::vector<double>& delta, Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Material& material = material_of(c, p, i);
    p.delta[i] = delta[p.species[i]];
    if (material.redox) {
      const Redox& redox = *material.redox;
      p.formula_units[i] = p.mass[i] / chemistry::molar_mass(redox, redox.density_delta);
      if (!c.models.mechanics_only)
        p.mass[i] = p.formula_units[i] * chemistry::molar_mass(redox, p.delta[i]);
    }
    p.enthalpy[i] = chemistry::enthalpy(solid_of(c, p, i), p.temperature[i], p.delta[i]);
  }
}

void begin_thermal_state(const Case& c, const Nodes& nodes, State& state) {
  std::vector<double> delta;
  for (const Species& species : c.species) delta.push_back(initial_delta(c, species));
  begin_particles(c, delta, state.particles);
  begin_particles(c, delta, state.waiting);
  begin_walls(nodes, state.walls);
  if (nodes.shells > 1) {
    state.shells = {std::vector<double>(nodes.solids(), 0.0),
                    std::vector<double>(nodes.solids(), 0.0)};
    begin_shells(nodes, state.particles, state.shells);
    begin_shells(nodes, state.waiting, state.shells);
  }
  state.breakdown = empty_breakdown({c.species.size()});
  open_books(c, nodes, state);
}

void renew_masses(const Case& c, Particles& particles) {
  parallel_for(particles.size(), [&](std::size_t i) {
    const Material& material = material_of(c, particles, i);
    if (material.redox)
      particles.mass[i] =
          particles.formula_units[i] * chemistry::molar_mass(*material.redox, particles.delta[i]);
  });
}

double stored_energy(const State& state) {
  const auto& enthalpy = state.particles.enthalpy;
  const auto& waiting = state.waiting.enthalpy;
  const auto& cells = state.walls.cell_energy;
  const auto& pores = state.gas.pore_energy;
  return parallel_sum(enthalpy.size(), [&](std::size_t i) { return enthalpy[i]; }) +
         parallel_sum(waiting.size(), [&](std::size_t i) { return waiting[i]; }) +
         parallel_sum(cells.size(), [&](std::size_t k) { return cells[k]; }) +
         parallel_sum(pores.size(), [&](std::size_t k) { return pores[k]; }) + state.gas.energy;
}

double bound_oxygen(const Case& c, const Particles& p) {
  return parallel_sum(p.size(), [&](std::size_t i) {
    const auto& redox = material_of(c, p, i).redox;
    return redox ? p.formula_units[i] * 0.5 * (redox->oxygen_atoms - p.delta[i]) : 0.0;
  });
}

double gas_free_volume(const Case& c, const State& state) {
  const Particles& p = state.particles;
  const double solids = parallel_sum(p.size(), [&](std::size_t i) {
    return 4.0 / 3.0 * pi * p.radius[i] * p.radius[i] * p.radius[i];
  });
  double free = c.chamber->volume - solids;
  for (const double pores : state.gas.pore_volume) free -= pores;
  if (free <= 0.0) throw NumericsError("chamber: the bed fills its whole volume");
  return free;
}

void close_chamber(const Case& c, State& state) {
  ensure(c.chamber.has_value() && !state.gas.closed, "an open chamber closes once");
  const auto air = chemistry::air_in(*c.chamber, gas_free_volume(c, state));
  state.gas.closed = true;
  state.gas.oxygen = air.oxygen;
  state.gas.nitrogen = air.nitrogen;
  state.gas.energy = chemistry::internal_energy(air, c.chamber->gas_temperature);
  state.fluxes.oxygen_closed_in += air.oxygen;
  state.fluxes.nitrogen_closed_in += air.nitrogen;
  state.fluxes.gas_energy_in += state.gas.energy;
  state.fluxes.gas_turnover +=
      chemistry::total(air) * chemistry::enthalpy_from_zero(c.chamber->gas_temperature);
}

Atmosphere atmosphere(const Case& c, const State& state) {
  if (!c.chamber) return {standard_atmosphere, 0.21, zero_celsius + 20.0};
  const ChamberCase& chamber = *c.chamber;
  if (!state.gas.closed)
    return {chamber.pressure, chamber.oxygen_fraction, chamber.gas_temperature};
  const chemistry::GasAmount gas{state.gas.oxygen, state.gas.nitrogen};
  const double T = chemistry::gas_temperature(gas, state.gas.energy, chamber.gas_temperature);
  const double volume = gas_free_volume(c, state);
  return {chemistry::gas_pressure(chemistry::total(gas), T, volume),
          chemistry::oxygen_fraction(gas), T};
}

}  // namespace pmr::coupling
