// Who is near whom.
#pragma once
#include <cstdint>
#include <vector>

#include "pmr/state/particles.hpp"

namespace pmr::physics {

struct NeighbourPair {
  std::uint32_t i, j;  // indices, i < j
  double gap;          // [m] between the surfaces, negative where they overlap
};

// All pairs whose surfaces are closer than reach [1] times the smaller radius, sorted by (i, j).
std::vector<NeighbourPair> pairs_within(const Particles& particles, double reach);

// Places of the particles in spatial order: along the Morton curve through cells of `cell` [m],
// by id within a cell.
std::vector<std::uint32_t> spatial_order(const Particles& particles, double cell);

}  // namespace pmr::physics
