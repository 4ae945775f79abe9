// Particles that cut into walls, as both stand at one time: what a run may not begin with.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::physics {

// Most that what the case puts in one by one may overlap [1] of the (smaller) radius, another
// particle or a wall. Deeper, a contact throws things off: by 10 m/s where a centre lies on a wall.
inline constexpr double largest_opening_overlap = 0.1;

// What is too deep in one body.
struct DeepInWall {
  std::uint32_t body;   // index into Walls::bodies
  std::size_t count;    // [1] particles that overlap it by more than the limit
  std::size_t deepest;  // index of one of them
  double overlap;       // [1] of the deepest one's radius
};
struct WallOverlaps {
  double largest = 0.0;               // [1] of the radius, of all
  std::vector<DeepInWall> excessive;  // by body
};

// Overlaps of more than `limit` [1] with the surfaces that hold particles and for which `counts`
// is true, as they stand at `time` [s]. A particle counts for the body that it is deepest in.
// Grains that adhere are no surface: grain_overlaps tells of them.
WallOverlaps wall_overlaps(const Particles& particles, const Walls& walls, double time,
                           double limit, const std::function<bool(const Surface&)>& counts);

// The same of the grains that adhere to walls; overlaps [1] of the particle's or the grain's
// radius, the smaller.
WallOverlaps grain_overlaps(const Particles& particles, const Walls& walls, double time,
                            double limit);

// "3 particles overlap wall 'side' by more than 10 % of their radius; the deepest, particle 7 of
// radius 1.5 mm at (28, 0, 3) mm, by 62.0 %"
std::string to_text(const DeepInWall& deep, const Particles& particles, const Walls& walls,
                    double limit);

// "particle 7 of radius 1.5 mm at (28, 0, 3) mm"
std::string place_of(const Particles& particles, std::size_t i);

}  // namespace pmr::physics
