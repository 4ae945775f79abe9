// The heat and reaction network over one interval, as an ODE system: what is constant during the
// interval, where each unknown stands, and the physics of its right-hand side.
//
// Unknowns y: enthalpy of each solid node [J], delta of each that reacts [1], energy of each
// wall cell [J], and for a closed chamber n_O2 [mol], n_N2 [mol], U [J]. With energies and moles as
// unknowns, the books are linear invariants of the system, which BDF keeps.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "chemistry/gas.hpp"
#include "chemistry/kinetics.hpp"
#include "chemistry/solids.hpp"
#include "coupling/heat_links.hpp"
#include "coupling/nodes.hpp"

namespace pmr::coupling {

// A particle, or a shell of one, that gives off oxygen.
struct Reactant {
  Node id;
  double volume;  // [m3]
  double iron;    // [mol]
};

// A surface patch with a transient profile.
struct WallProfile {
  Node node;
  std::uint32_t surface;
  std::uint32_t first_cell;
  double area;                      // [m2]
  std::vector<double> conductance;  // [W/m2/K] from cell to cell and to the outside
};

struct System {
  const Case* kase;
  const Nodes* nodes;
  const Csr* exchange;                     // [m2] radiation; nullptr when off
  std::vector<HeatLink> links;             // [W/K]
  Csr conductance;                         // [W/K] the links as symmetric rows over all nodes
  std::vector<chemistry::Solid> solid;     // by solid node; amount 0: no longer there
  std::vector<Reactant> reactants;         // those that may react, in order of their nodes
  std::vector<std::uint32_t> reactant_of;  // by solid node; no_reactant
  std::vector<double> delta;               // [1] by solid node, of those that do not react
  std::vector<WallProfile> profiles;
  std::vector<char> stores;              // by node: 1 where heat is stored, 0 for reservoirs
  std::vector<double> held_temperature;  // [K] by node, of reservoirs; of particles the first guess
  bool closed;                           // the chamber holds gas of its own
  double free_volume;                    // [m3]
  double air_oxygen_pressure;            // [Pa] while open

  static constexpr std::uint32_t no_reactant = ~std::uint32_t{0};
  std::size_t delta_begin() const { return solid.size(); }
  std::size_t cell_begin() const { return delta_begin() + reactants.size(); }
  std::size_t gas_begin() const { return cell_begin() + nodes->cells; }
  std::size_t size() const { return gas_begin() + (closed ? 3 : 0); }
};

// delta [1] of a particle: an unknown if it reacts, else what it was.
inline double delta_of(const System& system, std::span<const double> y, std::size_t id) {
  const std::uint32_t k = system.reactant_of[id];
  return k == System::no_reactant ? system.delta[id] : y[system.delta_begin() + k];
}

// Walls conduct as they will in the outlook.
System assemble_system(const Case& c, const Nodes& nodes, const State& state,
                       const Outlook& outlook, std::vector<HeatLink> links);

std::vector<double> pack(const System& system, const State& state);
void unpack(const System& system, std::span<const double> y, State& state);

// Rates of the chamber's gas, without what the bed gives off: d(n_O2, n_N2, U)/dt.
struct GasRates {
  double temperature, pressure, oxygen_pressure;  // [K], [Pa], [Pa]
  double oxygen_pumped, nitrogen_pumped;          // [mol/s]
  double oxygen_leaked, nitrogen_leaked;          // [mol/s]
  double energy_pumped, energy_leaked;            // [W]
};
GasRates gas_rates(const System& system, double t, std::span<const double, 3> gas);

// Everything the right-hand side and the quadratures are made from, at one (t, y).
struct Evaluation {
  std::vector<double> temperature;       // [K] by node
  std::vector<double> emission;          // [W/m2] sigma T^4 by node
  std::vector<double> heat;              // [W] received by each node by conduction and radiation
  std::vector<double> release;           // [mol O2/s] of each reactant
  std::vector<double> wall_temperature;  // [K] by wall cell
  GasRates gas{};
};
// False where y lies outside the domain of the physics (the integrator tries a smaller step).
bool evaluate(const System& system, double t, std::span<const double> y, Evaluation& at);

// dy/dt from an evaluation.
void fill_rates(const System& system, const Evaluation& at, std::span<double> rate);

}  // namespace pmr::coupling
