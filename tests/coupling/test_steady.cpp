// The heat network at rest against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "coupling/steady.hpp"

using namespace pmr;
using coupling::HeatLink;
using coupling::steady_temperatures;

namespace {

// G between nodes 0-1 and 1-2.
Csr two_factors(double g01, double g12) {
  Csr csr;
  csr.start = {0, 1, 3, 4};
  csr.column = {1, 0, 2, 1};
  csr.value = {g01, g01, g12, g12};
  return csr;
}

}  // namespace

TEST_CASE("A chain of links at rest falls by its resistances") {
  // T0 = 300 K, T3 = 600 K; resistances 1, 2 and 3 K/W.
  const std::vector<HeatLink> links{{0, 1, 0.4, 0.6}, {1, 2, 0.5, 0.0}, {2, 3, 0.0, 1.0 / 3.0}};
  const auto T = steady_temperatures(links, nullptr, {1, 0, 0, 1}, {300.0, 0.0, 0.0, 600.0});
  CHECK(T[0] == 300.0);
  CHECK(T[1] == Approx(350.0).epsilon(1e-10));
  CHECK(T[2] == Approx(450.0).epsilon(1e-10));
}

TEST_CASE("A node between two radiators takes the mean of their fourth powers") {
  const Csr g = two_factors(2e-6, 1e-6);
  const auto T = steady_temperatures({}, &g, {1, 0, 1}, {400.0, 700.0, 1300.0});
  const double power = (2.0 * std::pow(400.0, 4) + std::pow(1300.0, 4)) / 3.0;
  CHECK(std::abs(T[1] - std::pow(power, 0.25)) < 1e-9 * 900.0);  // as promised
}

TEST_CASE("A node without links keeps its temperature") {
  const std::vector<HeatLink> links{{0, 1, 1.0, 0.0}};
  const auto T = steady_temperatures(links, nullptr, {1, 0, 0}, {500.0, 400.0, 321.0});
  CHECK(T[1] == Approx(500.0).epsilon(1e-12));
  CHECK(T[2] == 321.0);
}
