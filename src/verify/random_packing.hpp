// A random packing of equal spheres in a periodic cube, and radiation through it.
#pragma once
#include <cstdint>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr::verify {

struct RandomPacking {
  double side;              // [m] of the periodic cube
  double diameter;          // [m]
  std::vector<Vec3> place;  // [m] of centres, in [0, side)
};

// `count` spheres at random places, each pushed out of its neighbours by half of every overlap,
// over and over, until none is deeper than 1e-5 of the diameter. For solid fractions below that of
// random close packing (0.64). NumericsError when it does not come to that.
RandomPacking random_packing(std::size_t count, double diameter, double solid_fraction,
                             std::uint64_t seed);

// F* = k_rad/(4 sigma d T^3) [1] of isothermal spheres of one emissivity, mean over the three
// directions: exchange factors by ray tracing among the cube and as much of its images as rays
// reach, temperatures at rest under a mean gradient (conjugate gradients on the periodic network).
double exchange_factor(const RandomPacking& packing, double emissivity, double rays);

}  // namespace pmr::verify
