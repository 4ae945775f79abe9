// The thermal side of a State: its first values, its stored energy and oxygen.
#pragma once
#include "chemistry/solids.hpp"
#include "coupling/nodes.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::coupling {

// Initial delta of a species [1]: as given, or equilibrium (chemistry/redox.hpp); 0 if inert.
double initial_delta(const Case& c, const Species& species);

// Fills formula units, delta and enthalpy of fresh particles, those that wait to be poured too,
// whose temperatures are set, and the walls' profiles; writes State::opening.
void begin_thermal_state(const Case& c, const Nodes& nodes, State& state);

// The solid of particle at index i.
chemistry::Solid solid_of(const Case& c, const Particles& particles, std::size_t i);

// Mass of a particle [kg] from its formula units and delta; inert particles keep theirs.
void renew_masses(const Case& c, Particles& particles);

// What the particles of each species hold.
struct Holdings {
  std::vector<double> energy;  // [J]
  std::vector<double> oxygen;  // [mol O2] bound
};
Holdings holdings(const Case& c, const Particles& particles);

double stored_energy(const State& state);  // [J] particles, waiting, walls, gas
double bound_oxygen(const Case& c, const Particles& particles);  // [mol O2] in the solids
// [m3] chamber less solids, and less pores where their gas is kept apart
double gas_free_volume(const Case& c, const State& state);

// Air of the moment is shut in; the books take it in.
void close_chamber(const Case& c, State& state);

// Total pressure [Pa] and oxygen's mole fraction [1] of the gas round the bed.
struct Atmosphere {
  double pressure;         // [Pa]
  double oxygen_fraction;  // [1]
  double temperature;      // [K]
};
Atmosphere atmosphere(const Case& c, const State& state);

}  // namespace pmr::coupling
