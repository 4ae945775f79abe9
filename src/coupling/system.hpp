// The heat and reaction network over one interval, as an ODE system: what is constant during the
// interval, where each unknown stands, and the physics of its right-hand side.
//
// Unknowns y: enthalpy of each solid node [J], delta of each that reacts [1], energy of each
// wall cell [J], and of each gas zone n_O2 [mol], n_N2 [mol], U [J]: the layers of the bed's
// pores where they are resolved, then the chamber once it is closed. With energies and moles as
// unknowns, the books are linear invariants of the system, which BDF keeps.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "chemistry/gas.hpp"
#include "chemistry/kinetics.hpp"
#include "chemistry/solids.hpp"
#include "coupling/bed_gas.hpp"
#include "coupling/heat_links.hpp"
#include "coupling/nodes.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

// A particle, or a shell of one, that gives off oxygen.
struct Reactant {
  Node id;
  double volume;         // [m3]
  double formula_units;  // [mol]
  double radius;         // [m] of the particle
};

// A surface patch with a transient profile.
struct WallProfile {
  Node node;
  std::uint32_t surface;
  std::uint32_t first_cell;
  double area;                      // [m2]
  std::vector<double> conductance;  // [W/m2/K] from cell to cell and to the outside
  std::vector<double> capacity;     // [J/K] of each cell
};

struct System {
  const Case* setup;
  const Nodes* nodes;
  RoundedRows exchange;                    // [m2] radiation; empty when off
  std::vector<HeatLink> links;             // [W/K]
  Csr conductance;                         // [W/K] the links as symmetric rows over all nodes
  std::vector<chemistry::Solid> solid;     // by solid node; amount 0: no longer there
  std::vector<Reactant> reactants;         // those that may react, in order of their nodes
  std::vector<std::uint32_t> reactant_of;  // by solid node; no_reactant
  std::vector<double> delta;               // [1] by solid node, of those that do not react
  std::vector<WallProfile> profiles;
  Groups groups;                         // that heat is booked between
  std::vector<std::uint16_t> group;      // by node
  std::vector<std::uint32_t> rarity;     // [1] by species: how many species have fewer particles
  std::vector<char> stores;              // by node: 1 where heat is stored, 0 for reservoirs
  std::vector<double> held_temperature;  // [K] by node, of reservoirs; of particles the first guess
  PoreSpace pores;                       // of the bed; not resolved: its gas is the chamber's
  bool closed;                           // the chamber holds gas of its own
  double free_volume;                    // [m3] of the chamber without the pores
  double air_oxygen_pressure;            // [Pa] while open

  static constexpr std::uint32_t no_reactant = ~std::uint32_t{0};
  std::size_t delta_begin() const { return solid.size(); }
  std::size_t cell_begin() const { return delta_begin() + reactants.size(); }
  std::size_t gas_begin() const { return cell_begin() + nodes->cells; }
  std::size_t zones() const { return pores.layers.size() + (closed ? 1 : 0); }  // of gas
  std::size_t chamber_begin() const { return gas_begin() + 3 * pores.layers.size(); }
  std::size_t size() const { return gas_begin() + 3 * zones(); }
  // The gas zone around a solid node; `open_air`: open air.
  std::size_t zone_of(Node node) const {
    if (pores.is_resolved()) return pores.layer_of[node % nodes->particles];
    return closed ? 0 : open_air;
  }
  static constexpr std::size_t open_air = ~std::size_t{0};
};

// delta [1] of a particle: an unknown if it reacts, else what it was.
inline double delta_of(const System& system, std::span<const double> y, std::size_t id) {
  const std::uint32_t k = system.reactant_of[id];
  return k == System::no_reactant ? system.delta[id] : y[system.delta_begin() + k];
}

// Walls conduct as they will in the outlook.
System assemble_system(const Case& c, const Nodes& nodes, const State& state,
                       const Outlook& outlook, std::vector<HeatLink> links, PoreSpace pores = {});

std::vector<double> pack(const System& system, const State& state);
void unpack(const System& system, std::span<const double> y, State& state);

// What the gas does by itself, without what the bed gives off and without heat from solids.
struct GasRates {
  double temperature, pressure, oxygen_pressure;  // [K], [Pa], [Pa] of the chamber or the open air
  double oxygen_pumped, nitrogen_pumped;          // [mol/s]
  double oxygen_leaked, nitrogen_leaked;          // [mol/s] by leak and vent
  double oxygen_to_air, nitrogen_to_air;          // [mol/s] into open air or out by the vent
  double energy_out, energy_in;                   // [W] with all of them
  double pump_power;                              // [W]
  std::vector<double> zone_temperature;           // [K] by gas zone
  std::vector<double> zone_oxygen_pressure;       // [Pa] likewise
  std::vector<double> rate;                       // d(n_O2, n_N2, U)/dt of each
};
GasRates gas_rates(const System& system, double t, std::span<const double> gas);

// Everything the right-hand side and the quadratures are made from, at one (t, y).
struct Evaluation {
  std::vector<double> temperature;       // [K] by node
  std::vector<double> emission;          // [W/m2] sigma T^4 by node
  std::vector<double> heat;              // [W] received by each node by conduction and radiation
  std::vector<double> release;           // [mol O2/s] of each reactant
  std::vector<double> wall_temperature;  // [K] by wall cell
  std::vector<double> film_heat;         // [W] from the gas of each layer of pores to its solids
  std::vector<double> bond;              // [J/mol O] reduction enthalpy of each reactant
  GasRates gas{};

  double oxygen_pressure(std::size_t zone) const {  // [Pa]
    return zone == System::open_air ? gas.oxygen_pressure : gas.zone_oxygen_pressure[zone];
  }
};

// Mean over the particles of each layer of pores, weighed by their shares, of a figure of theirs.
template <class Figure>
std::vector<double> layer_means(const PoreSpace& pores, const Figure& figure) {
  return parallel_bins(pores.share.size(), pores.layers.size(),
                       [&](std::size_t node, std::vector<double>& mean) {
                         mean[pores.layer_of[node]] += pores.share[node] * figure(node);
                       });
}
// Where reactant k is, as its rate law asks.
inline chemistry::RateState rate_state(const System& system, std::span<const double> y,
                                       const Evaluation& at, std::size_t k) {
  const Reactant& grain = system.reactants[k];
  return {at.temperature[grain.id],
          y[system.delta_begin() + k],
          at.oxygen_pressure(system.zone_of(grain.id)),
          grain.formula_units / grain.volume,
          grain.radius,
          at.bond[k]};
}

// False where y lies outside the domain of the physics (the integrator tries a smaller step).
bool evaluate(const System& system, double t, std::span<const double> y, Evaluation& at);

// The same but for `heat`, which stays as it was: half of the work.
bool evaluate_without_heat(const System& system, double t, std::span<const double> y,
                           Evaluation& at);

// dy/dt from an evaluation.
void fill_rates(const System& system, const Evaluation& at, std::span<double> rate);

}  // namespace pmr::coupling
