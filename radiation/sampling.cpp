#include "radiation/sampling.hpp"

#include <cmath>

namespace pmr::radiation {
namespace {

constexpr double golden = 1.1673039782614187;  // [1] real root of x^5 = x + 1
constexpr std::array<double, 4> stride{1.0 / golden, 1.0 / (golden * golden),
                                       1.0 / (golden * golden * golden),
                                       1.0 / (golden * golden * golden * golden)};

using Axes = std::array<Lanes, 3>;

// 1 where the whole number in a lane is odd, else 0.
Lanes odd_part(const Lanes& number) { return number - 2.0 * (0.5 * number).floor(); }

// on_sphere() of eight pairs. Quadrants choose by factors of 0, 1 and -1 instead of branches.
Axes on_spheres(const Lanes& u, const Lanes& v) {
  const Lanes z = 1.0 - 2.0 * u;
  const Lanes r = (1.0 - z * z).max(0.0).sqrt();
  const Lanes quarters = (4.0 * v).rint();
  const Lanes x = 2.0 * pi * (v - 0.25 * quarters);
  const Lanes y = x * x;
  const Lanes s = sine_near_zero(x, y), c = cosine_near_zero(y);
  const Lanes odd = odd_part(quarters), even = 1.0 - odd;
  const Lanes cosine_sign = 1.0 - 2.0 * odd_part((0.5 * (quarters + 1.0)).floor());
  const Lanes sine_sign = 1.0 - 2.0 * odd_part((0.5 * quarters).floor());
  return {r * (cosine_sign * (even * c + odd * s)), r * (sine_sign * (even * s + odd * c)), z};
}

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

Lanes QuasiPoints::coordinate(std::size_t k, std::uint64_t first) const {
  Lanes index;
  for (int lane = 0; lane < lanes; ++lane)
    index[lane] = static_cast<double>(first + static_cast<std::uint64_t>(lane));
  const Lanes x = shift_[k] + index * stride[k];
  return x - x.floor();
}

SphereDepartures leave_sphere(const QuasiPoints& quasi, std::uint64_t first) {
  SphereDepartures out;
  out.normal = on_spheres(quasi.coordinate(0, first), quasi.coordinate(1, first));
  const Axes ahead = on_spheres(quasi.coordinate(2, first), quasi.coordinate(3, first));
  Axes d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = out.normal[k] + ahead[k];
  const Lanes square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const Lanes scale = 1.0 / square.sqrt();
  for (std::size_t k = 0; k < 3; ++k)
    out.direction[k] = (square > grazing).select(scale * d[k], out.normal[k]);
  return out;
}

Vec3 in_triangle(double u, double v) {
  const double root = std::sqrt(u);
  return {1.0 - root, root * (1.0 - v), root * v};
}

}  // namespace pmr::radiation
