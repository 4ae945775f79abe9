// The particles of a case at its start.
#pragma once
#include <vector>

#include "pmr/base/errors.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::physics {

// Fills the species' regions from the base upwards, layer upon layer: each layer is a hexagonal
// lattice of one species, turned and shifted at random and jittered (so that the bed does not
// settle into a crystal; also out of its plane where gravity is not across it), nothing overlaps.
// Where sizes differ, particles are let down one by one instead (physics/deposition.hpp). Species
// that share a region take turns, so that they are mixed in proportion. Explicit particles follow.
// Ids count from 0 in that order. Fields of heat and chemistry stay zero, except the temperature.
// Throws CaseError with insertion_faults.
Particles insert(const Case& c);

// Sources that cannot pour (physics/pouring.hpp), regions that are too small (with what fits and
// the height it takes) or thousands of diameters wide, particles outside the domain, particles that
// overlap each other or a wall by more than a tenth of the (smaller) radius.
std::vector<Fault> insertion_faults(const Case& c);

}  // namespace pmr::physics
