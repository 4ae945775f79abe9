#include <catch2/catch.hpp>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"
#include "statistics/effects.hpp"

using namespace pmr;
using namespace pmr::statistics;

namespace {

// Ishigami & Homma, ISUMA '90 (1990) 398, with a = 7, b = 0.1, over (-pi, pi)^3.
double ishigami(std::span<const double> u) {
  const auto x = [&](std::size_t k) { return pi * (2.0 * u[k] - 1.0); };
  const double s = std::sin(x(1));
  return std::sin(x(0)) + 7.0 * s * s + 0.1 * std::pow(x(2), 4.0) * std::sin(x(0));
}

}  // namespace

TEST_CASE("Sobol' indices of Ishigami's function are the known ones") {
  // Closed form: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2, V1 = (1 + b pi^4/5)^2 / 2, V2 = a^2/8,
  // V13 = 8 b^2 pi^8 / 225. Sums over 4096 quasi-random points miss by about 0.005.
  const double v1 = 0.5 * std::pow(1.0 + 0.1 * std::pow(pi, 4.0) / 5.0, 2.0), v2 = 49.0 / 8.0;
  const double v13 = 8.0 * 0.01 * std::pow(pi, 8.0) / 225.0, v = v1 + v2 + v13;
  const Effects effects = sobol_indices(ishigami, 3);
  CHECK(v1 / v == Approx(0.3139).margin(5e-5));
  CHECK(effects.first[0] == Approx(v1 / v).margin(0.01));
  CHECK(effects.first[1] == Approx(v2 / v).margin(0.01));
  CHECK(effects.first[2] == Approx(0.0).margin(0.01));
  CHECK(effects.total[0] == Approx((v1 + v13) / v).margin(0.01));
  CHECK(effects.total[1] == Approx(v2 / v).margin(0.01));
  CHECK(effects.total[2] == Approx(v13 / v).margin(0.01));
  CHECK(effects.pair[0][2] == Approx(v13 / v).margin(0.02));
  CHECK(effects.pair[2][0] == effects.pair[0][2]);
  CHECK(effects.pair[0][1] == Approx(0.0).margin(0.02));
  CHECK(effects.pair[1][2] == Approx(0.0).margin(0.02));
  CHECK(effects.pair[1][1] == 0.0);
}

TEST_CASE("A large constant changes no index, and only a constant has none") {
  const auto shifted = [](std::span<const double> u) { return 1e6 + ishigami(u); };
  CHECK(sobol_indices(shifted, 3, 512).first[0] ==
        Approx(sobol_indices(ishigami, 3, 512).first[0]).margin(1e-6));
  const Effects none = sobol_indices([](std::span<const double>) { return 0.1; }, 2, 512);
  CHECK(std::isnan(none.first[0]));
  CHECK(std::isnan(none.total[1]));
  CHECK(std::isnan(none.pair[0][1]));
}

TEST_CASE("One variable has all the variance") {
  // Total: the quadrature of (f(a) - f(b))^2 / 2V over 4096 points.
  const Effects effects = sobol_indices([](std::span<const double> u) { return u[0]; }, 1);
  CHECK(effects.first[0] == Approx(1.0).margin(2e-3));
  CHECK(effects.total[0] == Approx(1.0).margin(2e-3));
}

TEST_CASE("Sobol' indices are the same bits on one thread and on two") {
  const auto total = [](int threads) {
    const ThreadLimit limit(threads);
    return sobol_indices(ishigami, 3, 512).total;
  };
  CHECK(total(1) == total(2));
}
