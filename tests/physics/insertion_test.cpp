// The opening state.
#include "physics/insertion.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <set>

#include "mechanics_scene.hpp"
#include "physics/neighbours.hpp"
#include "physics/size_distribution.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::test;

namespace {

// A tube of the small rig, 12 mm with a 2 mm rod, for spheres of diameter d [m].
Case tube(double d, std::size_t count, double height) {
  Case c = bare_case();
  c.species.resize(1);
  c.species[0].diameter = d;
  c.species[0].count = count;
  c.species[0].region = CylinderRegion{Vec3(0.01, 0, 0.02), 0.012, 0.002, height};
  c.domain_low = Vec3::Constant(-1.0);
  c.domain_high = Vec3::Constant(1.0);
  return c;
}

}  // namespace

TEST_CASE("A tube holds all its particles, apart from each other, between rod and wall") {
  for (const double d : {2.99e-3, 1.47e-3}) {
    const std::size_t count = d > 2e-3 ? 387 : 3475;
    const Case c = tube(d, count, 0.05);
    const Particles p = physics::insert(c);
    REQUIRE(p.size() == count);
    CHECK(physics::pairs_within(p, 0.0).empty());
    double top = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double r = (p.position[i] - Vec3(0.01, 0, 0)).head<2>().norm();
      CHECK(r - 0.5 * d >= 0.002);
      CHECK(r + 0.5 * d <= 0.012);
      CHECK(p.id[i] == i);
      top = std::max(top, p.position[i][2] + 0.5 * d - 0.02);
    }
    // Settled beds have about 0.55 in a tube this narrow; the lattice takes half as much again.
    const double settled = static_cast<double>(count) * pi / 6.0 * d * d * d /
                           (0.55 * pi * (0.012 * 0.012 - 0.002 * 0.002));
    CHECK(top < 1.55 * settled);
    CHECK(p.mass[0] == Approx(3500.0 * pi / 6.0 * d * d * d));
    CHECK(p.temperature[0] == 300.0);
  }
}

TEST_CASE("Two species that share a region are mixed in proportion over its height") {
  Case c = bare_case();
  fill(c, 300, 1200, 0.012, 0.0);
  const Particles p = physics::insert(c);
  CHECK(physics::pairs_within(p, 0.0).empty());
  std::vector<double> heights[2];
  for (std::size_t i = 0; i < p.size(); ++i) heights[p.species[i]].push_back(p.position[i][2]);
  REQUIRE(heights[0].size() == 300);
  REQUIRE(heights[1].size() == 1200);
  double mean[2];
  for (int s = 0; s < 2; ++s) {
    mean[s] = 0.0;
    for (const double z : heights[s]) mean[s] += z / static_cast<double>(heights[s].size());
  }
  CHECK(std::abs(mean[0] - mean[1]) < 2.0 * radius);  // a layer
}

TEST_CASE("Layers along gravity are not flat: each would stand on its edge for good") {
  Case c = tube(2e-3, 300, 0.06);
  const auto heights = [&](const Vec3& gravity) {  // how many there are
    c.gravity = gravity;
    const Particles p = physics::insert(c);
    CHECK(physics::pairs_within(p, 0.0).empty());
    std::set<double> all;
    for (const Vec3& x : p.position) all.insert(x.z());
    return all.size();
  };
  CHECK(heights(Vec3(0, 0, -9.81)) < 15);
  CHECK(heights(Vec3(9.81, 0, 0)) == 300);
  CHECK(heights(Vec3(0, 3.0, -9.0)) == 300);
}

TEST_CASE("A region that is too small says what fits and what it takes") {
  const Case c = tube(2.99e-3, 387, 0.02);
  const auto faults = physics::insertion_faults(c);
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0].problem, Catch::Contains("of 387") && Catch::Contains("need a height"));
  CHECK_THROWS_AS(physics::insert(c), CaseError);
  const auto narrow = physics::insertion_faults(tube(11e-3, 5, 0.02));
  REQUIRE(narrow.size() == 1);
  CHECK_THAT(narrow[0].problem, Catch::Contains("too narrow"));
}

TEST_CASE("Explicit particles that overlap or lie outside are faults, all reported") {
  Case c = bare_case();
  add_particle(c, Vec3::Zero(), Vec3(1, 2, 3), Vec3(4, 5, 6));
  add_particle(c, Vec3(1.95e-3, 0, 0), Vec3::Zero());  // 5 %
  CHECK(physics::insertion_faults(c).empty());
  c.particles[1].radius = 1.2e-3;  // 25 %
  add_particle(c, Vec3(0, 0, 5), Vec3::Zero());
  const auto faults = physics::insertion_faults(c);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].key == "particles[2]");
  CHECK(faults[1].key == "particles[1]");
}

TEST_CASE("Explicit particles keep what was asked for") {
  Case c = bare_case();
  add_particle(c, Vec3(1e-3, 0, 0), Vec3(1, 2, 3), Vec3(4, 5, 6));
  c.particles[0].temperature = 900.0;
  c.particles[0].radius = 0.7e-3;
  const Particles p = physics::insert(c);
  CHECK(p.velocity[0] == Vec3(1, 2, 3));
  CHECK(p.spin[0] == Vec3(4, 5, 6));
  CHECK(p.temperature[0] == 900.0);
  CHECK(p.radius[0] == 0.7e-3);
}

TEST_CASE("Pairs within reach agree with looking at all pairs") {
  Case c = bare_case();
  fill(c, 100, 400, 0.012, 0.0);
  const Particles p = physics::insert(c);
  for (const double reach : {0.1, 0.5, 1.0}) {
    const auto pairs = physics::pairs_within(p, reach);
    std::size_t k = 0;
    bool same = true;
    for (std::uint32_t i = 0; i < p.size(); ++i)
      for (std::uint32_t j = i + 1; j < p.size(); ++j) {
        const double gap = (p.position[i] - p.position[j]).norm() - (p.radius[i] + p.radius[j]);
        if (gap >= reach * std::min(p.radius[i], p.radius[j])) continue;
        same =
            same && k < pairs.size() && pairs[k].i == i && pairs[k].j == j && pairs[k].gap == gap;
        ++k;
      }
    CHECK(same);
    CHECK(k == pairs.size());
  }
}

TEST_CASE("Spheres of many sizes fill a tube in turns, apart from each other") {
  Case c = tube(1.5e-3, 0, 0.08);
  const physics::SizeDistribution sizes =
      physics::cut_at_tails(physics::LogNormalSizes{1.5e-3, 0.25});
  c.species[0].diameters = physics::sizes_of_count(sizes, {c.seed, 0, 3500.0}, 3000);
  c.species[0].count = 3000;
  const Particles p = physics::insert(c);
  REQUIRE(p.size() == 3000);
  CHECK(physics::pairs_within(p, 0.0).empty());
  double top = 0.0, deepest = 1.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    CHECK(2.0 * p.radius[i] == c.species[0].diameters[i]);
    const double r = (p.position[i] - Vec3(0.01, 0, 0)).head<2>().norm();
    CHECK(r - p.radius[i] >= 0.002);
    CHECK(r + p.radius[i] <= 0.012);
    top = std::max(top, p.position[i][2] + p.radius[i] - 0.02);
    deepest = std::min(deepest, p.position[i][2] - p.radius[i] - 0.02);
  }
  CHECK(deepest == Approx(0.0).margin(1e-12));
  // No looser than twice a settled bed of 0.6.
  const double solid = solid_volume(c.species[0]) / (pi * (0.012 * 0.012 - 0.002 * 0.002) * top);
  INFO("solid fraction " << solid);
  CHECK(solid > 0.3);
  c.species[0].region = CylinderRegion{Vec3(0.01, 0, 0.02), 0.012, 0.002, 0.015};
  const auto faults = physics::insertion_faults(c);
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0].problem, Catch::Contains("of 3000") && Catch::Contains("need a height"));
}

TEST_CASE("Particles that begin in a wall are a fault with their number and the deepest one") {
  const auto faults = [](double z, const std::function<void(Case&)>& change = {}) {
    Case c = bare_case();
    add_can(c, 0.02);
    c.walls.bodies[1].name = "floor";
    add_particle(c, Vec3(0, 0, z), Vec3::Zero());
    add_particle(c, Vec3(0, 0.01, 0.02), Vec3::Zero());
    if (change) change(c);
    std::string all;
    for (const Fault& fault : physics::insertion_faults(c)) all += to_string(fault) + "\n";
    return all;
  };
  CHECK(faults(radius).empty());
  CHECK(faults(0.91 * radius).empty());  // by less than a tenth, as two particles may
  CHECK_THAT(faults(0.89 * radius),
             Catch::Contains("particles[0]: at the start 1 particles overlap wall 'floor' by more "
                             "than 10 %") &&
                 Catch::Contains("by 11.0 %"));
  CHECK_THAT(faults(0.0), Catch::Contains("by 100.0 %"));  // the centre on the wall
  CHECK_THAT(faults(-0.5 * radius), Catch::Contains("by 50.0 %"));
  const auto later = [](Case& c) { c.walls.surfaces[1].from = 1e-9; };
  CHECK(faults(0.0, later).empty());  // not there yet
  const auto seen_only = [](Case& c) { c.walls.surfaces[1].holds_particles = false; };
  CHECK(faults(0.0, seen_only).empty());
  const auto away = [](Case& c) {  // as it stands when the fill begins
    c.fill = FillPhase{1.0, {}};
    c.walls.bodies[1].motion = Translate{Vec3(0, 0, 0.01), -2.0, 0.0};
  };
  CHECK_THAT(faults(0.01, away), Catch::Contains("by 100.0 %"));
}

TEST_CASE("A region that is wider than its tube is a fault that names the tube") {
  Case c = bare_case();
  add_can(c, 0.02);
  c.walls.bodies[0].name = "side";
  fill(c, 500, 500, 0.028, 0.0);
  std::string all;
  for (const Fault& fault : physics::insertion_faults(c)) all += to_string(fault) + "\n";
  CHECK_THAT(all, Catch::Contains("overlap wall 'side'"));
}

TEST_CASE("A bed of few layers lies evenly, although the last is not full") {
  // 120 g of beads in a chute of 200 x 50 mm: 1.6 layers. Half of them within half of the chute, to
  // half a bead; a last layer that begins at one side moves that by 2 cm.
  Case c = bare_case();
  c.species.resize(1);
  c.species[0].diameter = 2.99e-3;
  c.species[0].count = 2324;
  c.species[0].region = BoxRegion{Vec3(0.0, -0.025, 0.0), Vec3(0.2, 0.025, 0.04)};
  c.domain_low = Vec3::Constant(-1.0);
  c.domain_high = Vec3::Constant(1.0);
  for (c.seed = 1; c.seed <= 8; ++c.seed) {
    const Particles p = physics::insert(c);
    REQUIRE(p.size() == 2324);
    std::vector<double> x;
    for (const Vec3& at : p.position) x.push_back(at[0]);
    std::sort(x.begin(), x.end());
    CHECK(x[2324 / 4] == Approx(0.25 * 0.2).margin(0.0015));
    CHECK(x[2324 / 2] == Approx(0.5 * 0.2).margin(0.0015));
    CHECK(x[2324 * 3 / 4] == Approx(0.75 * 0.2).margin(0.0015));
  }
}

TEST_CASE("A few particles in a wide region lie about its middle") {
  Case c = bare_case();
  c.species.resize(1);
  c.species[0].diameter = 2.99e-3;
  c.species[0].region = BoxRegion{Vec3(0.0, -0.025, 0.0), Vec3(0.2, 0.025, 0.04)};
  c.domain_low = Vec3::Constant(-1.0);
  c.domain_high = Vec3::Constant(1.0);
  c.species[0].count = 3;
  for (c.seed = 1; c.seed <= 8; ++c.seed) {
    const Particles p = physics::insert(c);
    REQUIRE(p.size() == 3);
    const double middle = (p.position[0][0] + p.position[1][0] + p.position[2][0]) / 3.0;
    CHECK(std::abs(middle - 0.1) < 0.03);  // 0.033 off where the first place of all is taken
  }
}

TEST_CASE("A region of a thousand kilometres is refused at once") {
  Case c = bare_case();
  c.domain_low = Vec3::Constant(-2e6);
  c.domain_high = Vec3::Constant(2e6);
  fill(c, 10, 0, 1e6, 0.0);
  const auto faults = physics::insertion_faults(c);
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0].problem, Catch::Contains("3000 diameters"));
}
