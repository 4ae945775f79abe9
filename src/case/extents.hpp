// How far the walls reach: the geometry held against the domain.
#pragma once
#include <string>

#include "case/reader.hpp"
#include "physics/shapes.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

// Box round a body where it stands at rest [m]; infinite where a plane belongs to it.
physics::Box extent_of(const Walls& walls, std::size_t body);

// "20 x 20 x 40 mm, from (-10, -10, 0) to (10, 10, 40) mm", or "infinite" for a plane.
std::string to_text(const physics::Box& extent);

// Faults of the walls of [walls], bodies from `first` on: one that holds particles and rests wholly
// outside the domain, where no particle meets it; an STL file 300 times as large as the domain, or
// as much smaller and no larger than a particle, whose `scale` is thus that of another unit.
void check_extents(Table& root, std::size_t first, const Case& made);

}  // namespace pmr::casefile
