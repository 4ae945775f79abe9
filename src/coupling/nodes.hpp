// Numbers the nodes of the heat network: particles (or rather their outermost shells, then the next
// ones, likewise, and so on), then wall patches, then the surroundings, then the gas of the chamber
// (or the open air before it is closed).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "physics/wall_column.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::coupling {

using Node = std::uint32_t;

// A piece of a surface with one face temperature.
struct Patch {
  std::uint32_t surface;     // index into Walls::surfaces
  double area;               // [m2] of the facing side
  std::string name;          // "chamber.side[3,1]"
  std::uint32_t first_cell;  // index of its first wall cell; meaningless without a column
};

struct Nodes {
  std::size_t particles = 0;  // inserted
  std::vector<Node> place;    // by particle id: its node; empty: the id itself
  std::size_t shells = 1;     // of each
  std::vector<Patch> patches;
  std::vector<std::uint32_t> first_patch;    // per surface
  std::vector<physics::WallColumn> columns;  // per surface; empty where the boundary has no profile
  std::size_t cells = 0;                     // of all patches

  std::size_t solids() const { return particles * shells; }
  Node particle(ParticleId id) const { return place.empty() ? id : place[id]; }
  Node shell(ParticleId id, std::size_t k) const {
    return static_cast<Node>(particle(id) + k * particles);
  }
  // Where State::shells keeps it.
  std::size_t kept(ParticleId id, std::size_t k) const { return id + k * particles; }
  Node patch(std::size_t k) const { return static_cast<Node>(solids() + k); }
  Node surroundings() const { return static_cast<Node>(solids() + patches.size()); }
  Node gas() const { return surroundings() + 1; }
  std::size_t radiating() const { return solids() + patches.size() + 1; }  // without the gas
  std::size_t count() const { return radiating() + 1; }
};

Nodes number_nodes(const Case& c, std::size_t particles);  // particles by id

// Numbers the particles of a bed at rest by where they lie, neighbours close to each other: most of
// what a row of the network refers to is then at hand. Those that were lost come last.
void number_in_space(const Particles& particles, Nodes& nodes);

// Local index of the patch that holds `point` [m] of the surface, in the body's frame; numbered as
// tessellate() does.
std::uint32_t patch_at(const Surface& surface, const Vec3& point);

// Face temperature [K] of each patch; adiabatic ones have none and report NaN.
std::vector<double> patch_temperatures(const Case& c, const Nodes& nodes, const WallNodes& walls);

}  // namespace pmr::coupling
