#include "radiation/sampling.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::radiation {
namespace {

constexpr double golden = 1.1673039782614187;  // [1] real root of x^5 = x + 1
constexpr std::array<double, 4> stride{1.0 / golden, 1.0 / (golden * golden),
                                       1.0 / (golden * golden * golden),
                                       1.0 / (golden * golden * golden * golden)};

constexpr double grazing = 1e-12;  // [1] (2 cos theta)^2 below which a direction has no digits left

}  // namespace

QuasiPoints::QuasiPoints(std::uint64_t seed, std::uint64_t node, std::uint64_t step) {
  Random random(seed, Purpose::quasi_shift, node, step);
  for (double& s : shift_) s = random.uniform();
}

std::array<double, 4> QuasiPoints::point(std::uint64_t index) const {
  std::array<double, 4> p;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = shift_[k] + static_cast<double>(index) * stride[k];
    p[k] = x - std::floor(x);
  }
  return p;
}

// A quarter of the turn is taken off, the rest, within an eighth of a turn, goes through the Taylor
// polynomials: twice as fast as the library's sine and cosine, which cost a third of a flight.
Turn turn(double v) {
  const double quarters = std::nearbyint(4.0 * v);
  const double x = 2.0 * pi * (v - 0.25 * quarters);  // [rad] |x| <= pi/4
  const double y = x * x;
  const double s =
      x * (1.0 + y * (-1.0 / 6 + y * (1.0 / 120 + y * (-1.0 / 5040 + y * (1.0 / 362880)))));
  const double c =
      1.0 + y * (-1.0 / 2 + y * (1.0 / 24 + y * (-1.0 / 720 + y * (1.0 / 40320 - y / 3628800))));
  const auto quadrant = static_cast<int>(quarters) & 3;
  const bool is_odd = (quadrant & 1) != 0;
  const double cosine = is_odd ? s : c, sine = is_odd ? c : s;
  return {quadrant == 1 || quadrant == 2 ? -cosine : cosine, quadrant >= 2 ? -sine : sine};
}

Vec3 on_sphere(double u, double v) {
  const double z = 1.0 - 2.0 * u;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const Turn at = turn(v);
  return {r * at.cosine, r * at.sine, z};
}

Vec3 diffuse(const Vec3& normal, double u, double v) {
  const Vec3 d = normal + on_sphere(u, v);
  const double square = d.squaredNorm();
  return square > grazing ? Vec3(d / std::sqrt(square)) : normal;
}

Vec3 in_triangle(double u, double v) {
  const double root = std::sqrt(u);
  return {1.0 - root, root * (1.0 - v), root * v};
}

}  // namespace pmr::radiation
