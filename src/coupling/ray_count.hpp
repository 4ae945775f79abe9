// How many rays a case asks for, known before it runs.
#pragma once
#include "pmr/state/case.hpp"

namespace pmr::coupling {

struct RayCount {
  double sent = 0.0;    // [1] by one tracing
  double wanted = 0.0;  // [1] that would carry equal power each (radiation/dealing.hpp)
};

// Of one tracing with `rays` [1] from the sphere that emits least, all walls present, emissivities
// as at the start.
RayCount count_rays(const Case& c, double rays);

}  // namespace pmr::coupling
