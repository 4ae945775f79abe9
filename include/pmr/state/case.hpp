// A case: all that a run is made from. Plain data in SI, filled by src/case, read by everyone.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pmr/base/constants.hpp"
#include "pmr/base/vec3.hpp"
#include "pmr/state/contact_laws.hpp"
#include "pmr/state/materials.hpp"
#include "pmr/state/particles.hpp"
#include "pmr/state/walls.hpp"

namespace pmr {

// --- Particles
// Vertical cylinder or ring, filled from its base upwards.
struct CylinderRegion {
  Vec3 base;            // [m] centre of the lowest disc
  double radius;        // [m]
  double inner_radius;  // [m] kept free (a rod), 0 for none
  double height;        // [m]
};
struct BoxRegion {
  Vec3 low, high;  // [m]
};
using Region = std::variant<CylinderRegion, BoxRegion>;

// Particles that rain into the run one after another, from anywhere in the region, and fall freely
// until they meet something.
struct Pour {
  Region region;
  double mass_rate;      // [kg/s] or else ...
  double particle_rate;  // [1/s] ... this; the other is NaN
  Vec3 velocity;         // [m/s] on entry
  double begin;          // [s] the first enters; minus infinity: when the run begins
};

// Initial delta is given, or is the equilibrium with pO2 at a temperature.
struct EquilibriumDelta {
  double temperature;      // [K] of the equilibrium (the freeze-in temperature of a cold charge)
  double oxygen_pressure;  // [Pa]
};
using InitialDelta = std::variant<double, EquilibriumDelta>;

struct Species {
  std::string name;
  std::uint32_t material;
  double diameter;                // [m] of every particle; the Sauter diameter where they differ
  std::vector<double> diameters;  // [m] of each particle where they differ, else empty
  std::size_t count;              // [1] of particles
  double requested_mass;          // [kg] as asked; mass of all particles where a count was given
  double initial_temperature;     // [K]
  InitialDelta initial_delta;     // [1], ignored for inert materials
  std::optional<Region> region;   // where they are filled in; none: explicit particles only
  std::optional<Pour> pour;       // they come in while the run moves
  std::uint32_t dump_type;        // [1] atom type in a text dump that a bed is read from; 0: none
};

inline double smallest_diameter(const Species& s) {  // [m]
  return s.diameters.empty() ? s.diameter
                             : *std::min_element(s.diameters.begin(), s.diameters.end());
}
inline double largest_diameter(const Species& s) {  // [m]
  return s.diameters.empty() ? s.diameter
                             : *std::max_element(s.diameters.begin(), s.diameters.end());
}
inline double solid_volume(const Species& s) {  // [m3] of all its particles
  const auto sphere = [](double d) { return pi / 6.0 * d * d * d; };
  if (s.diameters.empty()) return static_cast<double>(s.count) * sphere(s.diameter);
  double sum = 0.0;
  for (const double d : s.diameters) sum += sphere(d);
  return sum;
}

struct ExplicitParticle {
  SpeciesIndex species;
  Vec3 position, velocity, spin;      // [m], [m/s], [rad/s]
  std::optional<double> temperature;  // [K] instead of the species'
  std::optional<double> radius;       // [m] instead of the species'
};

// --- Phases. Time zero is the release of the first valve; the fill has negative times.
struct RestCriterion {
  double rms_speed;  // [m/s] sqrt(2 (E_translation + E_rotation) / mass) below this ...
  double hold;       // [s] ... for this long
};
struct FillPhase {
  double duration;  // [s] at most
  RestCriterion rest;
};
struct MixPhase {
  double duration;    // [s] at most
  double not_before;  // [s] rest is not looked for earlier
  RestCriterion rest;
  double heat_interval;  // [s] of lockstep between mechanics and heat
};
struct ReactPhase {
  double end;               // [s] on the clock of the run
  double first_interval;    // [s]
  double growth;            // [1] interval = growth * time since the bed came to rest ...
  double longest_interval;  // [s] ... up to this
};

// --- Gas. Before closing the chamber stands open to air; from then on it is a volume with a pump.
struct Pump {
  double start;       // [s]
  Table speed;        // [Pa] -> [m3/s] at its inlet
  double ultimate;    // [Pa] pressure it cannot pump below
  double set_point;   // [Pa] held by its control
  double efficiency;  // [1] of isothermal compression to the air's pressure
};
// A valve to the outside air, opened when the pump is stopped; it lets gas in, and out.
struct Vent {
  double start;        // [s]
  double conductance;  // [mol/s/Pa]
};
struct ChamberCase {
  double closing;           // [s] open air before
  double volume;            // [m3] empty
  double pressure;          // [Pa] at closing, and of the air before
  double oxygen_fraction;   // [1] of the air
  double gas_temperature;   // [K] of the air
  double film_coefficient;  // [W/m2/K] gas to walls and to the bed's top (assumed)
  std::optional<Pump> pump;
  std::optional<Vent> vent;
  double leak;  // [mol/s] of air per Pa of pressure difference
};

// --- Models
struct MechanicsModel {
  std::optional<double> time_step;  // [s]; none: fraction_of_rayleigh
  double fraction_of_rayleigh;      // [1] of the smallest critical step
  double skin;                      // [1] of the smallest radius, of a bed at rest
  std::optional<double> impact_speed = std::nullopt;  // [m/s] of contacts to be resolved
  bool allows_long_step = false;                      // an explicit step above the stable range
  ContactModel contact = {};
  std::size_t allowed_losses = 0;  // [1] particles that may leave the domain; more: the run failed
};
// The values behind the first of each are kept for comparison with other codes.
enum class ContactConduction { batchelor_obrien, liggghts };
enum class ContactArea { of_real_solid, of_soft_contact };
enum class RadiationLaw { traced, environment };
struct ConductionModel {
  bool contact;               // solid contacts
  bool gap;                   // gas in the gaps
  double gap_reach;           // [1] of the smaller radius: across it half is conducted
  double bed_solid_fraction;  // [1] phi in r_ij of the gap model
  std::size_t shells = 1;     // [1] of equal volume in each particle; 1: isothermal
  ContactConduction contact_law = ContactConduction::batchelor_obrien;
  ContactArea contact_area = ContactArea::of_real_solid;
};
struct RadiationModel {
  double rays_moving;        // [1] per smallest particle, while the bed moves
  double rays_settled;       // [1] per smallest particle, settled bed
  double retrace_interval;   // [s] while moving, at least
  double emissivity_change;  // [1] settled: factors are scaled at this mean change ...
  double surroundings;       // [K] temperature where rays leave the rig
  double emissivity_change_traced = 0.05;  // [1] ... and traced anew at this one since the tracing
  double retrace_displacement = 0.05;      // [1] mean way of the particles, in diameters
  RadiationLaw law = RadiationLaw::traced;
};
// Gas in the pores of the bed at rest, layer by layer.
struct BedGasModel {
  std::size_t layers;  // [1]
  double tortuosity;   // [1] of the pores
};
struct NetworkModel {
  double relative_tolerance;     // [1]
  double temperature_tolerance;  // [K] absolute, per particle and wall cell
  double delta_tolerance;        // [1] absolute
};
struct Models {
  MechanicsModel mechanics;
  bool mechanics_only = false;  // particles move, and nothing else happens
  std::optional<ConductionModel> conduction;
  std::optional<RadiationModel> radiation;
  bool reaction = false;
  std::optional<BedGasModel> bed_gas;  // none: the bed's gas is the chamber's
  NetworkModel network;

  bool heat() const { return conduction || radiation || reaction; }
};

// --- Instruments and output
// Mass ratios of a bed that was taken apart elsewhere, to compare with.
struct MixtureReference {
  std::string name;            // of its file
  std::vector<double> layers;  // [1] w per layer, the mean over its sections if given
  std::vector<std::vector<double>> sections;  // [1] w per layer and sector; NaN: not measured
};
struct Decomposition {
  Vec3 axis_point;                     // [m] on the floor, axis +z
  double ramp_azimuth;                 // [rad] direction of phi = 0
  std::vector<double> layer_fraction;  // [1] of the bed's mass, from the top; the rest is residuum
  std::uint32_t sectors;
  std::string reference_source;
  std::optional<MixtureReference> reference;
};
struct Thermocouple {
  std::string name;
  Vec3 position;  // [m]
  double radius;  // [m] reads the particles whose centres are within
  bool is_plane =
      false;  // what a plane through their temperatures has at the position, not the mean
};
// Hot and cold plate over a bed at rest, all other walls insulated: effective conductivity.
struct ConductivityInstrument {
  std::uint32_t hot, cold;           // index into Walls::surfaces; the hot one above
  double difference;                 // [K] between them
  std::vector<double> temperatures;  // [K] of their mean
  std::vector<double> pressures;     // [Pa] of the gas in the bed
};
// An opening that catches: a rectangle; particles whose centre crosses it from its facing side (of
// along x across) leave the run and are booked as caught.
struct CatchInstrument {
  std::string name;
  Vec3 corner, along, across;       // [m]
  std::optional<double> threshold;  // [kg] it is told when so much has been caught ...
  bool ends_motion;                 // ... and the phase that moves is over then
};
// Angle of repose of what lies round a vertical axis when the run ends.
// A plane heap, between two walls a stated way apart: it slopes along a direction from its centre.
struct PlaneHeap {
  Vec3 along;    // [1] horizontal, of unit length
  double width;  // [m] across
};
struct HeapInstrument {
  Vec3 centre;            // [m] of its base, on the axis +z
  double radius;          // [m] of the base: a heap that reaches it has an edge, and is no free one
  std::uint32_t sectors;  // [1]
  double bin;             // [m] of the radius
  std::optional<PlaneHeap> plane = {};  // none: round the axis
};
// Force and torque of the particles on a wall over time.
struct WallForce {
  std::string name;    // of the wall
  std::uint32_t body;  // index into Walls::bodies
  Vec3 about;          // [m] point of the world that the torque counts about
};
struct OutputCase {
  double snapshot_interval;            // [s] while moving
  std::vector<double> snapshot_times;  // [s]
  double checkpoint_wall_time;         // [s] of wall time between checkpoints
  Vec3 cut_point = Vec3::Zero();       // [m] pictures are cut open at this plane
  Vec3 cut_normal = Vec3::UnitY();     // [1]
};

struct Case {
  std::string title;
  std::string description;
  std::uint64_t seed;
  Vec3 gravity = Vec3::Zero();     // [m/s2]
  Vec3 domain_low = Vec3::Zero();  // [m] a particle outside is lost, and booked as lost
  Vec3 domain_high = Vec3::Zero();
  Materials materials;
  std::vector<Species> species;
  std::vector<ExplicitParticle> particles;
  std::string bed;  // run folder or text dump whose particles open the run; "": they are inserted
  Walls walls;
  std::optional<FillPhase> fill;
  std::optional<MixPhase> mix;
  std::optional<ReactPhase> react;
  std::optional<ChamberCase> chamber;
  Models models;
  std::optional<Decomposition> decomposition;
  std::vector<Thermocouple> thermocouples;
  std::optional<ConductivityInstrument> conductivity;
  std::vector<CatchInstrument> catches;
  std::optional<HeapInstrument> heap;
  std::vector<WallForce> wall_forces;
  OutputCase output;
  std::vector<Provenance> provenance;  // of dimensions and settings: key, value, paper or assumed
  std::string text;                    // the TOML as read, with --set applied, for the record
  // The text without all that moves no particle: titles, temperatures, heat, gas, chemistry,
  // instruments. Cases of equal mechanical text and equal particles mix the same bed.
  std::string mechanical_text;
  std::vector<std::string> warnings;  // what the reader took otherwise than it is written
};

}  // namespace pmr
