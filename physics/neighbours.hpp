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

// Places of the particles in spatial order: the cloud is halved across its longest side, and its
// halves likewise, at multiples of whole blocks and runs (physics/blocks.hpp), so that each of them
// fills a box of its own, in dense beds and in loose streams alike (recursive coordinate bisection,
// Berger and Bokhari, IEEE Trans. Comput. C-36 (1987) 570).
std::vector<std::uint32_t> spatial_order(const Particles& particles);

}  // namespace pmr::physics
