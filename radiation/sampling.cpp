#include "radiation/sampling.hpp"

#include <cmath>

namespace pmr::radiation {
namespace {

constexpr double golden = 1.1673039782614187;  // [1] real root of x^5 = x + 1
constexpr std::array<double, 4> stride{1.0 / golden, 1.0 / (golden * golden),
                                       1.0 / (golden * golden * golden),
                                       1.0 / (golden * golden * golden * golden)};

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

Vec3 in_triangle(double u, double v) {
  const double root = std::sqrt(u);
  return {1.0 - root, root * (1.0 - v), root * v};
}

}  // namespace pmr::radiation
