// The settled bed of an earlier run.
#pragma once
#include "sim/bed.hpp"

namespace pmr::sim {

// From the run's checkpoint, which keeps places, motions and springs of the end of its motion
// through the react phase. CaseError when the run is still moving, or a species is unknown.
Bed read_run_bed(const Case& c);

}  // namespace pmr::sim
