// Points and directions of diffuse emission.
#pragma once
#include <array>
#include <cstdint>

#include "pmr/base/random.hpp"
#include "pmr/base/vec3.hpp"

namespace pmr::radiation {

// Quasi-random points in the unit 4-cube: additive recurrence with the generalised golden ratio
// (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), shifted at random
// (Cranley & Patterson, SIAM J. Numer. Anal. 13, 1976) for each (seed, node, step).
class QuasiPoints {
 public:
  QuasiPoints(std::uint64_t seed, std::uint64_t node, std::uint64_t step);
  std::array<double, 4> point(std::uint64_t index) const;  // [1], each in [0, 1)
  double offset() const { return shift_[4]; }              // [1] a fifth, fixed number in [0, 1)

 private:
  std::array<double, 5> shift_;
};

// Cosine and sine of v turns, v in [0, 1], within 1e-8.
struct Turn {
  double cosine, sine;  // [1]
};
Turn turn(double v);

// Uniform over the unit sphere, from two numbers in [0, 1).
Vec3 on_sphere(double u, double v);

// Diffuse (Lambert) about the unit normal, density cos(theta)/pi: from the foot of the unit sphere
// that stands on the surface to a point uniform over it.
Vec3 diffuse(const Vec3& normal, double u, double v);

// Barycentric weights of a point uniform over a triangle.
Vec3 in_triangle(double u, double v);

}  // namespace pmr::radiation
