#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "beds.hpp"
#include "instruments/bed.hpp"
#include "instruments/decomposition.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::instruments;

namespace {

const Sides pair{Side::beads, Side::granules};
constexpr double radius = 0.001;  // [m]

// Levels of equal mass 0.8 kg, 10 mm apart, the lowest at 5 mm: in each sector of level k (from
// the top) `beads[k][sector]` kg of beads and the rest to 0.1 kg of granules.
Particles levels(const std::vector<std::vector<double>>& beads) {
  Particles bed;
  for (std::size_t k = 0; k < beads.size(); ++k)
    for (std::size_t s = 0; s < 8; ++s) {
      const double z = 0.005 + 0.01 * static_cast<double>(beads.size() - 1 - k);
      const double mass = beads[k][s];
      if (mass > 0.0) test::add_sphere(bed, 0, test::on_ring(s, z), radius, mass);
      if (mass < 0.1) test::add_sphere(bed, 1, test::on_ring(s, z), radius, 0.1 - mass);
    }
  return bed;
}

Particles random_bed(std::size_t count) {
  Particles bed;
  Random random(7, Purpose::test, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place(0.1 * random.uniform() - 0.05, 0.1 * random.uniform() - 0.05,
                     0.12 * random.uniform());
    const bool is_bead = random.uniform() < 0.1;
    test::add_sphere(bed, is_bead ? 0 : 1, place, radius, is_bead ? 5e-5 : 6e-6);
  }
  return bed;
}

}  // namespace

TEST_CASE("A bed of two layers is cut between them") {
  const std::vector<double> upper(8, 0.075), lower(8, 0.025);  // w = 3 above, 1/3 below
  const BedSections cut = decompose(levels({upper, lower}), test::tool({0.5, 0.5}), pair);
  REQUIRE(cut.layers.size() == 2);
  CHECK(cut.layers[0].content.mass_ratio() == Approx(3.0).epsilon(1e-12));
  CHECK(cut.layers[1].content.mass_ratio() == Approx(1.0 / 3.0).epsilon(1e-12));
  CHECK(cut.layers[0].mass == Approx(0.8).epsilon(1e-12));
  // Centres at 15 and 5 mm: the cut lies at 10 mm, the tops of the upper spheres at 16 mm.
  CHECK(cut.layers[0].thickness() == Approx(0.006).epsilon(1e-12));
  CHECK(cut.layers[0].bottom == Approx(0.010).epsilon(1e-12));
  CHECK(cut.residuum.mass == 0.0);
}

TEST_CASE("Sections hold the mass ratios that were put into them") {
  std::vector<double> masses;
  for (std::size_t s = 0; s < 8; ++s) masses.push_back(0.01 * static_cast<double>(s + 1));
  const BedSections cut = decompose(levels({masses, masses}), test::tool({0.5}), pair);
  REQUIRE(cut.layers.size() == 1);
  for (std::size_t s = 0; s < 8; ++s) {
    const double w = masses[s] / (0.1 - masses[s]);
    CHECK(cut.layers[0].sectors[s].mass_ratio() == Approx(w).epsilon(1e-12));
  }
  CHECK(cut.residuum.mass == Approx(0.8).epsilon(1e-12));
  CHECK(cut.residuum.thickness() == Approx(0.010).epsilon(1e-12));
}

TEST_CASE("Sectors turn with the ramp") {
  std::vector<double> masses(8, 0.02);
  masses[6] = 0.08;  // at 270 degrees
  Decomposition turned = test::tool({1.0});
  turned.ramp_azimuth = -0.5 * pi;
  const BedSections cut = decompose(levels({masses}), turned, pair);
  CHECK(cut.layers[0].sectors[0].mass_ratio() == Approx(4.0).epsilon(1e-12));
  CHECK(cut.layers[0].sectors[6].mass_ratio() == Approx(0.25).epsilon(1e-12));
  CHECK(sector_azimuth(turned, 6) == Approx(1.5 * pi).epsilon(1e-15));
}

TEST_CASE("The axis of the tool is the axis of the sectors and its floor that of the heights") {
  const std::vector<double> masses{0.09, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07};
  Particles bed = levels({masses});
  Decomposition moved = test::tool({1.0});
  moved.axis_point = Vec3(1.0, -2.0, 3.0);
  for (Vec3& position : bed.position) position += moved.axis_point;
  const BedSections cut = decompose(bed, moved, pair);
  CHECK(cut.layers[0].sectors[0].mass_ratio() == Approx(9.0).epsilon(1e-12));
  CHECK(cut.layers[0].top == Approx(0.006).epsilon(1e-9));
}

TEST_CASE("Layers hold their fractions to within half a particle and masses add up") {
  const Particles bed = random_bed(20000);
  // Mean layer masses of the demonstrator's four runs over their sum of 1999.03 g; the residuum
  // of 197.02 g is the rest (decomposition tool of the mixing study).
  const std::vector<double> grams{259.09, 266.77, 270.89, 292.30, 266.02, 259.52, 187.42};
  std::vector<double> fractions;
  for (const double mass : grams) fractions.push_back(mass / 1999.03);
  const BedSections cut = decompose(bed, test::tool(fractions), pair);
  double total = 0.0, sum = 0.0, target = 0.0, thickness = 0.0;
  for (const double mass : bed.mass) total += mass;
  for (std::size_t k = 0; k < cut.layers.size(); ++k) {
    const Layer& layer = cut.layers[k];
    sum += layer.mass;
    thickness += layer.thickness();
    target += fractions[k] * total;
    CHECK(std::abs(sum - target) <= 0.5 * 5e-5 * (1.0 + 1e-9));  // half a bead
    double sections = 0.0;
    for (const Portion& section : layer.sectors) sections += section.mass();
    CHECK(sections == Approx(layer.mass).epsilon(1e-12));
    CHECK(layer.content.mass() == Approx(layer.mass).epsilon(1e-12));
    CHECK(layer.content.beads + layer.content.granules > 0);
  }
  CHECK(sum + cut.residuum.mass == Approx(total).epsilon(1e-12));
  CHECK(thickness + cut.residuum.thickness() ==
        Approx(bed_height(bed, Vec3::Zero())).epsilon(1e-12));
}

TEST_CASE("A section without granules has an infinite ratio, an empty one none") {
  std::vector<double> masses(8, 0.05);
  masses[3] = 0.1;
  Particles bed = levels({masses});
  const BedSections cut = decompose(bed, test::tool({1.0}), pair);
  CHECK(std::isinf(cut.layers[0].sectors[3].mass_ratio()));
  CHECK(std::isnan(Portion{}.mass_ratio()));
}

TEST_CASE("The decomposition does not depend on the order of particles") {
  Particles bed = random_bed(3000);
  const BedSections before = decompose(bed, test::tool({0.3, 0.3}), pair);
  for_each_field(bed, [](const char*, const char*, auto& f) { std::reverse(f.begin(), f.end()); });
  const BedSections after = decompose(bed, test::tool({0.3, 0.3}), pair);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(after.layers[k].bottom == before.layers[k].bottom);
    CHECK(after.layers[k].content.beads == before.layers[k].content.beads);
  }
}

TEST_CASE("No particles make empty layers without failure") {
  const BedSections cut = decompose(Particles{}, test::tool({0.5, 0.3}), pair);
  REQUIRE(cut.layers.size() == 2);
  CHECK(cut.layers[0].mass == 0.0);
  CHECK(cut.layers[0].thickness() == 0.0);
  CHECK(std::isnan(cut.layers[1].content.mass_ratio()));
  CHECK(cut.residuum.mass == 0.0);
}
