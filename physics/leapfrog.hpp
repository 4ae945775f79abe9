// The integrator: leapfrog (velocity Verlet), half kick, drift, forces, half kick; second order in
// the step.
#pragma once
#include <span>

#include "physics/blocks.hpp"
#include "physics/spheres.hpp"

namespace pmr::physics {

struct Leapfrog {
  double dt;     // [s]
  Vec3 gravity;  // [m/s2]
};

// What a block's particles did in one pass.
struct Passage {
  double fastest = 0.0;       // [m/s] speed in it
  bool is_finite = true;      // no place has become no number
  double contact_work = 0.0;  // [J] of contacts on particles in the half sub-steps passed
};

// Half kick and drift of a block's particles under their loads and gravity, into `after`: what was
// before is still read by other blocks. `ends_step`: after the
// half kick that ends the sub-step before. Force times the velocity at full steps is the work that
// contacts do, exactly: kinetic energy changes by it and by gravity's.
Passage kick_and_drift(const Spheres& spheres, std::span<const Load> loads, const Block& block,
                       const Leapfrog& leapfrog, bool ends_step, Places& after);

// The half kick alone, at the end of an integration.
Passage kick(const Spheres& spheres, std::span<const Load> loads, const Block& block,
             const Leapfrog& leapfrog, Places& after);

}  // namespace pmr::physics
