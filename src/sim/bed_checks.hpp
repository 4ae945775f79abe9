// What is wrong with a bed that was read from elsewhere.
#pragma once
#include <vector>

#include "pmr/base/errors.hpp"
#include "sim/bed.hpp"

namespace pmr::sim {

// Particles outside the domain, overlaps of more than a tenth of the smaller radius with particles
// or with walls as they stand at the bed's time; sets Bed::overlap_ratio.
std::vector<Fault> bed_faults(const Case& c, Bed& bed);

}  // namespace pmr::sim
