// Places for spheres of many sizes: ballistic deposition.
#pragma once
#include <span>
#include <vector>

#include "physics/ground.hpp"
#include "pmr/base/random.hpp"

namespace pmr::physics {

// Lets spheres of the given radii [m] down one by one onto those that lie already; each takes the
// lowest of a few places drawn at random and sticks where it first touches (a gap of 0.1 % of the
// distance keeps them apart). Centres [m] in the order of the radii; fewer, when one finds no place
// between the region's sides. Nothing rolls, so the heap is loose: about 0.4 solid in a narrow
// tube.
std::vector<Vec3> deposit(const Ground& ground, std::span<const double> radii, std::uint64_t seed,
                          std::uint64_t key);

}  // namespace pmr::physics
