// Where heat may pass between the bodies of a bed as it lies: which surfaces come near each other,
// and how near. Depends on places alone, so that a bed at rest is looked at once.
#pragma once
#include <limits>
#include <vector>

#include "coupling/nodes.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::coupling {

struct Gap {
  Node a, b;               // a < b: two particles, or a particle and a wall patch
  std::uint32_t particle;  // index of a
  std::uint32_t other;     // index of the particle b, or of the patch
  double width;            // [m] between the surfaces, negative: the soft overlap
  double share;            // [1] of the conductance of such a gap (physics/wall_feet.hpp)
};

struct Gaps {
  std::vector<Gap> all;                                        // in order of (a, b)
  double found_at = -std::numeric_limits<double>::infinity();  // [s]
};

// All gaps narrower than the conduction model's reach; none without that model. One gap where there
// is one surface, however many facets it has.
Gaps find_gaps(const Case& c, const Nodes& nodes, const State& state);

// True if no wall has come, gone or moved since the gaps were found; particles are the caller's.
bool walls_stand(const Case& c, const Gaps& gaps, double now);

}  // namespace pmr::coupling
