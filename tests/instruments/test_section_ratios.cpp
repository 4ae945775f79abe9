// Figures made of the sections' mass ratios alone, against sums done by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "instruments/section_ratios.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::instruments;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

// A Poisson number by counting exponential waits (Knuth, The Art of Computer Programming 2, 3.4.1).
double poisson(Random& random, double mean) {
  double product = random.uniform(), count = 0.0;
  for (; product > std::exp(-mean); ++count) product *= random.uniform();
  return count;
}

}  // namespace

TEST_CASE("Asymmetry compares sections opposite about the plane of the ramp") {
  // Sector 1 against 7: |3 - 1| / 2 = 1; the two other pairs are equal. 0 and 4 lie on the plane.
  const SectionRatios ratios{{9, 3, 1, 1, 5, 1, 1, 1}, {1, 1, 1, 1, 1, 1, 1, 1}};
  const Asymmetry asymmetry = left_right_asymmetry(ratios);
  CHECK(asymmetry.layers.at(0) == Approx(1.0 / 3.0).epsilon(1e-15));
  CHECK(asymmetry.layers.at(1) == 0.0);
  CHECK(asymmetry.mean == Approx(1.0 / 6.0).epsilon(1e-15));
  CHECK(asymmetry.largest == 1.0);
}

TEST_CASE("An odd number of sectors pairs all but the ramp's") {
  const Asymmetry asymmetry = left_right_asymmetry({{7, 1, 2, 2, 3}});  // 1 against 3, 2 against 2
  CHECK(asymmetry.mean == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("Pairs without two finite ratios are left out of the asymmetry") {
  const Asymmetry asymmetry =
      left_right_asymmetry({{1, infinite, 2, 1, 1, 1, 1, 4}, {1, none, 1, 1}});
  CHECK(asymmetry.layers.at(0) == Approx((1.0 / 1.5 + 0.0) / 2.0).epsilon(1e-15));
  CHECK(std::isnan(asymmetry.layers.at(1)));
  CHECK(asymmetry.mean == asymmetry.layers.at(0));
  CHECK(std::isnan(left_right_asymmetry({{1}}).mean));
}

TEST_CASE("The asymmetry of a random mixture is what counting makes it") {
  // w of sections with Poisson counts of the study's means, 315 beads and 2,766 granules; the mean
  // of n = 3000 normal differences scatters by sqrt(pi / 2 - 1) / sqrt(n), and w is normal up to
  // terms in 1 / beads.
  Random random(3, Purpose::test, 0);
  SectionRatios ratios;
  for (int layer = 0; layer < 1000; ++layer) {
    std::vector<double> row;
    for (int s = 0; s < 8; ++s) {
      double granules = 0.0;
      for (int part = 0; part < 6; ++part) granules += poisson(random, 461.0);
      row.push_back(poisson(random, 315.0) / granules);
    }
    ratios.push_back(row);
  }
  const double expected = counting_asymmetry(315.0, 2766.0);
  CHECK(left_right_asymmetry(ratios).mean ==
        Approx(expected).epsilon(4.0 * std::sqrt((1.5708 - 1.0) / 3000.0)));
  CHECK(expected == Approx(0.0671).margin(0.0001));
}

TEST_CASE("The deviation is the mean of |1 - w / w_reference| over the layers") {
  const MixtureReference reference{"measured.csv", {2.0, 1.0}, {}};
  const Deviation from = deviation({{2, 4}, {0.25, none}}, reference);  // means 3 and 1/4
  CHECK(from.layers.at(0) == Approx(0.5).epsilon(1e-15));
  CHECK(from.layers.at(1) == Approx(0.75).epsilon(1e-15));
  CHECK(from.mean == Approx(0.625).epsilon(1e-15));
  CHECK(from.sections.empty());
}

TEST_CASE("The deviation of sections counts those that were measured") {
  const MixtureReference reference{"measured.csv", {2.0}, {{1.0, none, 3.0}}};
  const Deviation from = deviation({{2.0, 9.0, 3.0}}, reference);
  CHECK(from.sections.at(0) == Approx((1.0 + 0.0) / 2.0).epsilon(1e-15));
}

TEST_CASE("The peak of a layer is its largest finite ratio") {
  CHECK(peak_sector({1.0, 3.0, none, 2.0}) == 1u);
  CHECK(peak_sector({none, infinite, 0.5}) == 2u);
  CHECK_FALSE(peak_sector({none, none}));
}

TEST_CASE("The mean over sectors leaves out those without granules") {
  CHECK(sector_mean({1.0, infinite, 3.0, none}) == 2.0);
  CHECK(std::isnan(sector_mean({none})));
}
