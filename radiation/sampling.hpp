// Points and directions of diffuse emission.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"
#include "pmr/base/vec3.hpp"

namespace pmr::radiation {

// Numbers of eight successive rays, for the vector units.
inline constexpr int lanes = 8;
using Lanes = Eigen::Array<double, lanes, 1>;

// Quasi-random points in the unit 4-cube: additive recurrence with the generalised golden ratio
// (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), shifted at random
// (Cranley & Patterson, SIAM J. Numer. Anal. 13, 1976) for each (seed, node, step).
class QuasiPoints {
 public:
  QuasiPoints(std::uint64_t seed, std::uint64_t node, std::uint64_t step);
  std::array<double, 4> point(std::uint64_t index) const;  // [1], each in [0, 1)
  // Coordinate k in [0, 4) of the points from `first` on, the same bits as of point().
  Lanes coordinate(std::size_t k, std::uint64_t first) const;
  double offset() const { return shift_[4]; }  // [1] a fifth, fixed number in [0, 1)

 private:
  std::array<double, 5> shift_;
};

// Cosine and sine of v turns, v in [0, 1], within 1e-8. Quarters of a turn are taken off, the rest,
// within an eighth, goes through the Taylor polynomials: twice as fast as the library's sine and
// cosine, which cost a third of a flight.
template <class Real>
Real sine_near_zero(const Real& x, const Real& y) {  // y = x^2, x [rad]
  return x * (1.0 + y * (-1.0 / 6 + y * (1.0 / 120 + y * (-1.0 / 5040 + y * (1.0 / 362880)))));
}
template <class Real>
Real cosine_near_zero(const Real& y) {
  return 1.0 + y * (-1.0 / 2 + y * (1.0 / 24 + y * (-1.0 / 720 + y * (1.0 / 40320 - y / 3628800))));
}
struct Turn {
  double cosine, sine;  // [1]
};
inline Turn turn(double v) {
  const double quarters = std::nearbyint(4.0 * v);
  const double x = 2.0 * pi * (v - 0.25 * quarters);  // [rad] |x| <= pi/4
  const double y = x * x;
  const double s = sine_near_zero(x, y), c = cosine_near_zero(y);
  const auto quadrant = static_cast<int>(quarters) & 3;
  const bool is_odd = (quadrant & 1) != 0;
  const double cosine = is_odd ? s : c, sine = is_odd ? c : s;
  return {quadrant == 1 || quadrant == 2 ? -cosine : cosine, quadrant >= 2 ? -sine : sine};
}

// Uniform over the unit sphere, from two numbers in [0, 1).
inline Vec3 on_sphere(double u, double v) {
  const double z = 1.0 - 2.0 * u;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const Turn at = turn(v);
  return {r * at.cosine, r * at.sine, z};
}

inline constexpr double grazing =
    1e-12;  // [1] (2 cos theta)^2: below, a direction has no digits left

// Diffuse (Lambert) about the unit normal, density cos(theta)/pi: from the foot of the unit sphere
// that stands on the surface to a point uniform over it.
inline Vec3 diffuse(const Vec3& normal, double u, double v) {
  const Vec3 d = normal + on_sphere(u, v);
  const double square = d.squaredNorm();
  return square > grazing ? Vec3((1.0 / std::sqrt(square)) * d) : normal;
}

// Normals and directions of the diffuse departures of eight rays from a sphere, the same bits as
// from on_sphere() and diffuse().
struct SphereDepartures {
  std::array<Lanes, 3> normal, direction;  // [1] by axis
};
SphereDepartures leave_sphere(const QuasiPoints& quasi, std::uint64_t first);

// Barycentric weights of a point uniform over a triangle.
Vec3 in_triangle(double u, double v);

}  // namespace pmr::radiation
