#include <catch2/catch.hpp>
#include <cmath>

#include "beds.hpp"
#include "instruments/mixing.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::instruments;

namespace {

const Sides beads_to_granules{Side::beads, Side::granules};
constexpr double bead = 5e-5, granule = 6e-6;  // [kg]

// 16 sections of the same number of grains, species drawn with probability `share` of beads above
// and below.
BedSections drawn(double share_above, double share_below, std::size_t grains, std::uint64_t seed) {
  Random random(seed, Purpose::test, 0);
  BedSections sections{std::vector<Layer>(2), {}};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t s = 0; s < 8; ++s) {
      Portion section;
      for (std::size_t i = 0; i < grains; ++i)
        ++(random.uniform() < (k == 0 ? share_above : share_below) ? section.beads
                                                                   : section.granules);
      section.bead_mass = bead * static_cast<double>(section.beads);
      section.granule_mass = granule * static_cast<double>(section.granules);
      sections.layers[k].sectors.push_back(section);
    }
  return sections;
}

}  // namespace

TEST_CASE("Lacey's index of species apart is 0") {
  // The random part sR^2 in the denominator multiplies 0: exact to rounding.
  CHECK(std::abs(lacey_index(drawn(1.0, 0.0, 100, 1))) < 1e-12);
}

TEST_CASE("Lacey's index of a random mixture is 1 on average") {
  // Few grains per section, so that sR^2 counts: s^2 of 16 sections scatters by sqrt(2/15) of sR^2
  // per draw. Its mean over 4000 draws misses sR^2 by 1/16 (p taken from the same sections) and by
  // terms in 1/n; with n near 20, M = 1 +- (1/16 + 1/n) / n.
  const std::size_t grains = 60;
  double sum = 0.0;
  const int draws = 4000;
  for (int i = 0; i < draws; ++i)
    sum += lacey_index(drawn(0.3, 0.3, grains, static_cast<std::uint64_t>(i)));
  const double p = 0.3 * bead / (0.3 * bead + 0.7 * granule);
  const double n = 60.0 * (0.3 * bead + 0.7 * granule) / (p * granule + (1.0 - p) * bead);
  CHECK(sum / draws == Approx(1.0).margin((1.0 / 16.0 + 1.0 / n) / n));
  // Without the correction for unequal masses (n = 60) the margin would be missed.
  CHECK(n < 100.0);
}

TEST_CASE("Lacey's index of sections p + a and p - a of equal grains has a closed form") {
  // Half of the sections hold 70 of 100 grains as beads, half 30: p = 1/2, s^2 = a^2 = 0.04. Of
  // equal grains sR^2 is the binomial p (1 - p) / n with n = 100, whatever a grain weighs.
  BedSections sections{std::vector<Layer>(2), {}};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t s = 0; s < 8; ++s) {
      const std::size_t beads = k == 0 ? 70 : 30;
      sections.layers[k].sectors.push_back({granule * static_cast<double>(beads),
                                            granule * static_cast<double>(100 - beads), beads,
                                            100 - beads});
    }
  CHECK(lacey_index(sections) == Approx((0.25 - 0.04) / (0.25 - 0.25 / 100.0)).epsilon(1e-12));
}

TEST_CASE("Lacey's index of a partial mixture lies between") {
  const double index = lacey_index(drawn(0.8, 0.2, 2000, 3));
  CHECK(index > 0.1);
  CHECK(index < 0.9);
}

TEST_CASE("Lacey's index is not a number where nothing can be mixed") {
  CHECK(std::isnan(lacey_index(drawn(1.0, 1.0, 10, 4))));
  CHECK(std::isnan(lacey_index(decompose(Particles{}, test::tool({0.5}), beads_to_granules))));
}
