// The one owner of what the next step depends on, which is exactly what a checkpoint holds.
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "pmr/base/csr.hpp"
#include "pmr/state/contacts.hpp"
#include "pmr/state/particles.hpp"

namespace pmr {

enum class Phase : std::uint8_t { fill, mix, react, done };

// One piece of wall with one temperature at its face: a node of the heat network.
struct WallNodes {
  std::vector<double> cell_energy;  // [J] rows of cells, patch by patch (coupling/wall_nodes.hpp)
};

// The insides of particles, where they are resolved: shell k of a particle, 0 the outermost, stands
// at id + k * inserted. Empty where particles are isothermal.
struct Shells {
  std::vector<double> enthalpy;  // [J]
  std::vector<double> delta;     // [1]
};

// Gas in the closed chamber, and in the bed's pores where they are resolved: by layer from the
// bottom, also while the chamber stands open.
struct Gas {
  bool closed = false;
  double oxygen = 0.0;                // [mol] in the chamber, without the pores
  double nitrogen = 0.0;              // [mol]
  double energy = 0.0;                // [J] internal
  std::vector<double> pore_volume;    // [m3]
  std::vector<double> pore_oxygen;    // [mol]
  std::vector<double> pore_nitrogen;  // [mol]
  std::vector<double> pore_energy;    // [J] internal
};

// Symmetric exchange of radiation between nodes: particles, then wall patches, then the
// surroundings (numbered as src/coupling/nodes.hpp says).
struct Exchange {
  Csr factor;                             // [m2] G_ij = eps_i A_i D_ij, G_ij = G_ji, no diagonal
  std::vector<double> self;               // [m2] G_ii
  std::vector<double> emissivity;         // [1] of each node that the factors now have
  std::vector<double> traced_emissivity;  // [1] of each node when traced
  std::vector<Vec3> traced_place;         // [m] of each particle when traced, by id
  double traced_at = -std::numeric_limits<double>::infinity();  // [s]
  double rays = 0.0;                                            // [1] of that tracing
  double relative_error = 0.0;  // [1] mean standard error of a row's largest factors
  double row_sum_error = 0.0;   // [1] largest |sum_j G_ij/(eps_i A_i) - 1|, G_ii included
  double unfinished = 0.0;      // [1] rays given back to their emitter after too many reflections
};

// Integrals of fluxes since the start, each integrated on its own; the ledger holds them against
// the change of what is stored.
struct Fluxes {
  double to_outside = 0.0;          // [J] walls to their outside and to fixed temperatures
  double to_surroundings = 0.0;     // [J] radiation that left the rig
  double reaction = 0.0;            // [J] taken up by the redox reaction, integral of dH(delta)
  double oxygen_released = 0.0;     // [mol] from solids, net
  double oxygen_to_air = 0.0;       // [mol] O2 that went to open air, net, or out by the vent
  double nitrogen_to_air = 0.0;     // [mol] N2 likewise
  double oxygen_pumped = 0.0;       // [mol] O2
  double nitrogen_pumped = 0.0;     // [mol] N2
  double oxygen_closed_in = 0.0;    // [mol] O2 of the air shut in, in pores and chamber
  double nitrogen_closed_in = 0.0;  // [mol] N2 of the air shut in
  double oxygen_leaked = 0.0;       // [mol] O2 that came in by leak and vent
  double nitrogen_leaked = 0.0;     // [mol] N2 likewise
  double pump_work = 0.0;           // [J] of isothermal compression, not part of the books
  double gas_energy_out = 0.0;      // [J] enthalpy pumped, and of oxygen that left to open air
  double gas_energy_in = 0.0;       // [J] enthalpy of air let in, and of the air closed in
  double lost_energy = 0.0;         // [J] held by particles that were lost or caught
  double lost_oxygen = 0.0;         // [mol] O2 bound in them
  double heat_exchanged = 0.0;      // [J] sum over particles, lined walls, gas of |heat received|
  double gas_turnover = 0.0;        // [J] enthalpy from 0 K on of all gas that passed the border or
                                    // a grain's surface, whichever way
  double oxygen_turnover = 0.0;     // [mol] O2 of that gas
  double nitrogen_turnover = 0.0;   // [mol] N2 of it
  double grain_turnover = 0.0;      // [mol] O2 that left or entered grains, sum of magnitudes
  double dissipated = 0.0;          // [J] kinetic energy lost in contacts (mechanics, not heat)
};

template <class F, class Visitor>
void for_each_flux(F& f, Visitor&& visit) {
  visit("to_outside", "J", f.to_outside);
  visit("to_surroundings", "J", f.to_surroundings);
  visit("reaction", "J", f.reaction);
  visit("oxygen_released", "mol", f.oxygen_released);
  visit("oxygen_to_air", "mol", f.oxygen_to_air);
  visit("nitrogen_to_air", "mol", f.nitrogen_to_air);
  visit("oxygen_pumped", "mol", f.oxygen_pumped);
  visit("nitrogen_pumped", "mol", f.nitrogen_pumped);
  visit("oxygen_closed_in", "mol", f.oxygen_closed_in);
  visit("nitrogen_closed_in", "mol", f.nitrogen_closed_in);
  visit("oxygen_leaked", "mol", f.oxygen_leaked);
  visit("nitrogen_leaked", "mol", f.nitrogen_leaked);
  visit("pump_work", "J", f.pump_work);
  visit("gas_energy_out", "J", f.gas_energy_out);
  visit("gas_energy_in", "J", f.gas_energy_in);
  visit("lost_energy", "J", f.lost_energy);
  visit("lost_oxygen", "mol", f.lost_oxygen);
  visit("heat_exchanged", "J", f.heat_exchanged);
  visit("gas_turnover", "J", f.gas_turnover);
  visit("oxygen_turnover", "mol", f.oxygen_turnover);
  visit("nitrogen_turnover", "mol", f.nitrogen_turnover);
  visit("grain_turnover", "mol", f.grain_turnover);
  visit("dissipated", "J", f.dissipated);
}

// Between whom heat is booked: the species in the case's order, all walls, the surroundings, the
// gas.
struct Groups {
  std::size_t species;

  std::size_t walls() const { return species; }
  std::size_t surroundings() const { return species + 1; }
  std::size_t gas() const { return species + 2; }
  std::size_t count() const { return species + 3; }
  std::size_t pairs() const { return count() * (count() - 1) / 2; }
  // Place of a pair, a < b.
  std::size_t pair(std::size_t a, std::size_t b) const {
    return a * count() - a * (a + 1) / 2 + (b - a - 1);
  }
};

// The same integrals by pair of groups and by species. A pair's heat counts from its first group to
// its second; films of gas count as gaps.
struct Breakdown {
  std::vector<double> contact;      // [J] by pair, through solid contacts
  std::vector<double> gap;          // [J] by pair, through gas
  std::vector<double> radiation;    // [J] by pair
  std::vector<double> released;     // [mol O2] by species, net
  std::vector<double> carried;      // [J] by species, enthalpy of that oxygen
  std::vector<double> reaction;     // [J] by species, taken up by the redox reaction
  std::vector<double> lost_energy;  // [J] by species, held by those lost or caught
  std::vector<double> lost_oxygen;  // [mol O2] by species, bound in them
};

// visit(name, unit, vector).
template <class B, class Visitor>
void for_each_part(B& by, Visitor&& visit) {
  visit("contact", "J", by.contact);
  visit("gap", "J", by.gap);
  visit("radiation", "J", by.radiation);
  visit("released", "mol", by.released);
  visit("carried", "J", by.carried);
  visit("reaction", "J", by.reaction);
  visit("lost_energy", "J", by.lost_energy);
  visit("lost_oxygen", "mol", by.lost_oxygen);
}

inline Breakdown empty_breakdown(const Groups& groups) {
  const std::vector<double> by_pair(groups.pairs(), 0.0), by_species(groups.species, 0.0);
  return {by_pair, by_pair, by_pair, by_species, by_species, by_species, by_species, by_species};
}

// What changed over the last interval of the network; what the next one's coefficients expect.
struct Trend {
  double length = 0.0;                   // [s] of that interval; 0: there was none
  double ln_pressure = 0.0;              // [1] change of ln p of the gas
  std::vector<double> ln_pore_pressure;  // [1] likewise in each layer of pores
  std::vector<double> warming;           // [K] of each particle, by id
  std::vector<double> heating;           // [J] of each wall cell
};

struct LostParticle {
  ParticleId id;
  double time;    // [s]
  Vec3 position;  // [m] first place outside the domain
};

// A particle that crossed an opening which catches (Case::catches) and left the run there.
struct CaughtParticle {
  ParticleId id;
  SpeciesIndex species;
  std::uint32_t by;  // index into Case::catches
  double time;       // [s] of crossing
  double mass;       // [kg]
  Vec3 position;     // [m] of its centre in the opening
};

// What was there at the start, for the books.
struct Opening {
  double energy = 0.0;  // [J] stored in particles and walls
  double oxygen = 0.0;  // [mol] O2 bound in solids
  std::uint64_t particles = 0;
  double heat_content = 0.0;  // [J] sum of C T over particles and walls: what rounding is of
  std::vector<double> species_energy;  // [J] stored in the particles of each species
  std::vector<double> species_oxygen;  // [mol] O2 bound in them
};

// Largest values so far, for the report's limits.
struct Extremes {
  double overlap_ratio = 0.0;  // [1] overlap over the smaller radius
  double speed = 0.0;          // [m/s]
};

struct State {
  double time = 0.0;  // [s] zero at the first valve's release
  Phase phase = Phase::fill;
  std::uint64_t step = 0;                                         // mechanical sub-steps so far
  std::uint64_t interval = 0;                                     // intervals so far
  double rest_since = std::numeric_limits<double>::infinity();    // [s] bed below the rest speed
  double settled_at = std::numeric_limits<double>::infinity();    // [s] start of the react phase
  double set_point_at = std::numeric_limits<double>::infinity();  // [s] pressure first at set-point
  double elastic_energy = 0.0;  // [J] of the Hertz springs of all contacts
  double network_step = 0.0;    // [s] CVODES tries this first in the next interval
  Particles particles;
  Particles waiting;  // still to be poured in, by id: the order of their entry
  ContactHistory pair_contacts;
  ContactHistory wall_contacts;
  WallNodes walls;
  Shells shells;
  Gas gas;
  Exchange exchange;
  Trend trend;
  Fluxes fluxes;
  Breakdown breakdown;
  Opening opening;
  Extremes extremes;
  std::vector<LostParticle> lost;
  std::vector<CaughtParticle> caught;  // in the order of crossing
};

}  // namespace pmr
