#include "radiation/dealing.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "radiation/exchange.hpp"
#include "radiation/symmetry.hpp"
#include "scenes.hpp"

using namespace pmr;
using namespace pmr::radiation;

namespace {

double sum_of(const std::vector<double>& emissions, const Dealing& dealing) {
  double sum = 0.0;
  for (const double e : emissions) sum += dealing.sent(e);
  return sum;
}

}  // namespace

TEST_CASE("Rays go with what is emitted, at least one each") {
  const std::vector<double> emissions{2.0, 3.0, 7.0, 1e-9};
  const Dealing dealing = deal(emissions, 2.0, 100.0);
  CHECK(dealing.sent(2.0) == 100.0);
  CHECK(dealing.sent(3.0) == 150.0);
  CHECK(dealing.sent(7.0) == 350.0);
  CHECK(dealing.sent(1e-9) == 1.0);
}

TEST_CASE(
    "However small a grain in however large a room, rays have a bound that spares the grain") {
  std::vector<double> emissions(6, 0.16);  // [m2] the walls of a box of 0.4 m
  for (const double diameter : {1e-3, 1e-4, 1e-6}) {
    emissions.push_back(3.14159265 * diameter * diameter);
    const double least = emissions.back();
    const Dealing dealing = deal(emissions, least, 320.0);
    CHECK(sum_of(emissions, dealing) <= 1e7);
    CHECK(sum_of(emissions, dealing) > 0.999e7);
    CHECK(dealing.sent(least) == 320.0);
    CHECK(dealing.wanted(0.16) == Approx(320.0 * 0.16 / least));
    CHECK(dealing.sent(0.16) == Approx((1e7 - 320.0) / 6.0).epsilon(1e-3));  // a wall of six
    emissions.pop_back();
  }
}

TEST_CASE("Many emitters may send more: twenty times the smallest one's rays in the mean") {
  std::vector<double> emissions(100000, 1.0);
  CHECK(sum_of(emissions, deal(emissions, 1.0, 320.0)) == 3.2e7);
  emissions.back() = 1e9;
  CHECK(sum_of(emissions, deal(emissions, 1.0, 320.0)) == Approx(20 * 3.2e7).epsilon(1e-6));
}

TEST_CASE("Of two estimates of a factor each weighs with the inverse of its variance") {
  // Node 0 sends 100 rays of 0.01 m2, node 1, thinned out tenfold, 1000 rays of 0.1 m2.
  const Counted counted{{{{1, 60}, {2, 40}}, {{0, 7}, {1, 993}}, {}},
                        {100, 1000, 0},
                        {1.0, 10.0, 1.0},
                        {1.0, 100.0, 0.0}};
  Csr factor = merge(counted).factor;
  // (n01 + n10) / (1/c0 + 1/c1), c = 0.01 and 0.1 m2: the variance is that of 67 counts.
  CHECK(factor.value[0] == Approx(67.0 / (1.0 / 0.01 + 1.0 / 0.1)));
}

TEST_CASE("A tracing that is asked to stop is given up") {
  const auto spheres = jittered_lattice(3);
  std::vector<double> emissivity(28, 0.8), area(28, sphere_area(1e-3));
  std::atomic<bool> stop{true};
  CHECK_THROWS_AS(trace({spheres, {}, emissivity, area, 28, 60.0, 5, 2, {}, stop}), Stopped);
}
