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

namespace {

// A slice of face-centred packing (solid fraction pi/sqrt(18) = 0.7405) of `n` x `n` x `n` cells
// of edge sqrt(2) d.
Particles close_packed(int n, double d) {
  Particles bed;
  const double a = std::sqrt(2.0) * d;
  const Vec3 corners[] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (const Vec3& corner : corners)
          test::add_sphere(bed, 0, a * (Vec3(x, y, z) + corner), 0.5 * d, 1.0);
  return bed;
}

double fraction_along(const Particles& bed, const Vec3& up) {
  const Particles turned = upright(bed, up);
  return solid_fraction(turned, lowest_point(turned));
}

Particles turned_about(const Particles& bed, const Mat3& rotation, const Vec3& shift) {
  Particles turned = bed;
  for (Vec3& x : turned.position) x = rotation * x + shift;
  return turned;
}

}  // namespace

TEST_CASE("A column's solid fraction leaves out a diameter and a tenth of the height") {
  // Ten touching spheres of diameter 1: from 1 to 9 eight spheres of pi / 6 in cylinders of pi / 4:
  // 2/3; circles stand as polygons of the same area.
  Particles bed;
  for (int k = 0; k < 10; ++k) test::add_sphere(bed, 0, Vec3(0.0, 0.0, k + 0.5), 0.5, 1.0);
  CHECK(solid_fraction(bed, 0.0) == Approx(2.0 / 3.0).epsilon(1e-12));
}

TEST_CASE("A bed's solid fraction is its own, whatever box it lies in and wherever that stands") {
  const Particles bed = close_packed(12, 0.003);
  const double upright_one = fraction_along(bed, Vec3::UnitZ());
  // The hull reaches a radius beyond the outermost centres, half a plane's distance would be the
  // lattice's own share: 3.4 % less.
  CHECK(upright_one == Approx(pi / std::sqrt(18.0)).epsilon(0.05));
  // Far from the origin and turned about the vertical: the same.
  const Mat3 yaw = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  CHECK(fraction_along(turned_about(bed, yaw, Vec3(0.4, -0.2, 0.1)), Vec3::UnitZ()) ==
        Approx(upright_one).epsilon(2e-3));
  // With gravity along another axis: the same.
  for (const Vec3& up : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.0, 0.8)}) {
    const Mat3 tilt = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), up).toRotationMatrix();
    CHECK(fraction_along(turned_about(bed, tilt, Vec3::Zero()), up) ==
          Approx(upright_one).epsilon(1e-2));
  }
}

TEST_CASE("A bed that does not fill the region round it has no solid fraction") {
  const Particles bed = close_packed(12, 0.003);
  const auto kept = [&](const auto& keeps) {
    Particles part;
    for (const Vec3& x : bed.position)
      if (keeps(x)) test::add_sphere(part, 0, x, 0.0015, 1.0);
    return fraction_along(part, Vec3::UnitZ());
  };
  const Vec3 middle(0.024, 0.024, 0.0);
  CHECK(std::isnan(kept([](const Vec3& x) { return x.z() < 0.05 - x.x(); })));  // a heap's slope
  CHECK(std::isnan(kept([&](const Vec3& x) {                                    // round a rod
    return std::hypot(x.x() - middle.x(), x.y() - middle.y()) > 0.011;
  })));
  CHECK(std::isnan(fraction_along(bed, Vec3(0.6, 0.0, 0.8))));  // a floor that is not level
  CHECK(kept([&](const Vec3& x) {                               // in a tube
          return std::hypot(x.x() - middle.x(), x.y() - middle.y()) < 0.022;
        }) == Approx(pi / std::sqrt(18.0)).epsilon(0.15));
}

TEST_CASE("The vessel that encloses a bed reaches to its farthest sphere") {
  Particles bed;
  test::add_sphere(bed, 0, Vec3(3.0, 0.0, 2.0), 0.5, 1.0);
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
  CHECK(std::isnan(solid_fraction(none, 0.0)));
  CHECK(coordination_number(State{}) == 0.0);
  CHECK(enclosing_vessel(none, Vec3::Zero()).radius == 0.0);
  const SpeciesFigures figures = species_figures(none, 0);
  CHECK(figures.count == 0);
  CHECK(std::isnan(figures.temperature.mean));
}
