#include <catch2/catch.hpp>
#include <cmath>

#include "beds.hpp"
#include "instruments/bed.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::instruments;

TEST_CASE("The solid fraction of a simple cubic lattice is pi / 6") {
  const double d = 0.003;
  const Particles bed = test::cubic_bed(8, 12, d);
  const double area = 64.0 * d * d;
  // Slabs of whole periods, wherever they start.
  for (const double low : {0.0, d, 1.37 * d, 2.5 * d})
    CHECK(solid_fraction(bed, Slab{low, low + 7.0 * d, area}) == Approx(pi / 6.0).epsilon(1e-12));
}

TEST_CASE("A slab cuts one sphere into its exact parts") {
  Particles bed;
  test::add_sphere(bed, 0, Vec3(0.0, 0.0, 0.0), 2.0, 1.0);
  // Half of it, 2 pi r^3 / 3, and a cap of height r/2: pi h^2 (3 r - h) / 3 with h = 1.
  CHECK(solid_fraction(bed, Slab{0.0, 5.0, 1.0}) * 5.0 ==
        Approx(2.0 * pi * 8.0 / 3.0).epsilon(1e-14));
  CHECK(solid_fraction(bed, Slab{1.0, 5.0, 1.0}) * 4.0 ==
        Approx(pi * (6.0 - 1.0) / 3.0).epsilon(1e-14));
  CHECK(solid_fraction(bed, Slab{3.0, 5.0, 1.0}) == 0.0);
}

TEST_CASE("The representative slab of a vessel leaves out a diameter and a tenth of the height") {
  // A column of 10 touching spheres of diameter 1 in a vessel of radius 1/2: from 1 to 9, eight
  // spheres of pi / 6 in cylinders of pi / 4: 2/3.
  Particles bed;
  for (int k = 0; k < 10; ++k) test::add_sphere(bed, 0, Vec3(0.0, 0.0, k + 0.5), 0.5, 1.0);
  test::add_sphere(bed, 0, Vec3(3.0, 0.0, 2.0), 0.5, 1.0);  // outside, not counted
  CHECK(solid_fraction(bed, Vessel{Vec3(0.0, 0.0, 0.0), 0.5}) == Approx(2.0 / 3.0).epsilon(1e-12));
  CHECK(enclosing_vessel(bed, Vec3::Zero()).radius == Approx(3.5).epsilon(1e-15));
}

TEST_CASE("The bed's height is that of 99 % of the mass") {
  Particles bed = test::cubic_bed(10, 5, 0.002);
  CHECK(bed_height(bed, Vec3::Zero()) == Approx(0.010).epsilon(1e-12));
  test::add_sphere(bed, 0, Vec3(0.0, 0.0, 0.5), 0.001, 1e-3);  // stuck high up
  CHECK(bed_height(bed, Vec3::Zero()) == Approx(0.010).epsilon(1e-12));
  CHECK(bed_height(bed, Vec3(0.0, 0.0, -1.0)) == Approx(1.010).epsilon(1e-12));
}

TEST_CASE("Each contact counts for both partners") {
  State state;
  resize(state.particles, 3);
  state.pair_contacts.start = {0, 1, 2, 2};  // a chain of three: 0-1, 1-2
  state.pair_contacts.partner = {1, 2};
  CHECK(coordination_number(state) == Approx(4.0 / 3.0).epsilon(1e-15));
}

TEST_CASE("The spread of a species weighs particles with their mass") {
  Particles bed;
  for (int i = 0; i < 4; ++i) test::add_sphere(bed, 1, Vec3::Zero(), 0.001, i == 3 ? 7.0 : 1.0);
  test::add_sphere(bed, 0, Vec3::Zero(), 0.001, 100.0);
  bed.temperature = {300.0, 400.0, 500.0, 600.0, 5000.0};
  bed.delta = {0.1, 0.1, 0.1, 0.1, 0.0};
  const SpeciesFigures figures = species_figures(bed, 1);
  CHECK(figures.count == 4);
  CHECK(figures.mass == 10.0);
  // (300 + 400 + 500 + 7 600) / 10 = 540; variance (240^2 + 140^2 + 40^2 + 7 60^2) / 10 = 10400
  CHECK(figures.temperature.mean == Approx(540.0).epsilon(1e-14));
  CHECK(figures.temperature.deviation == Approx(std::sqrt(10400.0)).epsilon(1e-14));
  CHECK(figures.temperature.low == 300.0);
  CHECK(figures.temperature.high == 600.0);
  CHECK(figures.delta.mean == 0.1);
  CHECK(figures.delta.deviation == 0.0);
}

TEST_CASE("A bed without particles has figures or says that it has none") {
  const Particles none;
  CHECK(bed_height(none, Vec3::Zero()) == 0.0);
  CHECK(std::isnan(solid_fraction(none, Vessel{Vec3::Zero(), 0.05})));
  CHECK(coordination_number(State{}) == 0.0);
  CHECK(enclosing_vessel(none, Vec3::Zero()).radius == 0.0);
  const SpeciesFigures figures = species_figures(none, 0);
  CHECK(figures.count == 0);
  CHECK(std::isnan(figures.temperature.mean));
}
