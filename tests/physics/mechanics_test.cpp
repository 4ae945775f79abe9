// What must hold for the whole machine: determinism, restart, losses, rest.
#include "physics/mechanics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mechanics_scene.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

using namespace pmr;
using namespace pmr::test;

namespace {

// A can with a shaking floor and a paddle that turns in the bed.
Case stirred_case(std::size_t large, std::size_t small) {
  Case c = bare_case();
  add_can(c, 0.015, Oscillate{Vec3(0, 0, 1e-3), 30.0, 0.0});
  const auto paddle = add_body(c, Rotate{Vec3::Zero(), Vec3::UnitZ(), 20.0, 0.005, 1.0});
  add_surface(c, rectangle(Vec3(-0.012, 0, 0.002), Vec3(0.024, 0, 0), Vec3(0, 0, 0.006)), paddle);
  fill(c, large, small, 0.015, 0.010);
  return c;
}

// The case's particles, thrown down at 1 m/s.
State thrown(const Case& c) {
  State state = opened(c);
  for (Vec3& v : state.particles.velocity) v = Vec3(0, 0, -1);
  return state;
}

}  // namespace

TEST_CASE("One and two threads give the same bits") {
  const Case c = stirred_case(600, 2400);
  std::uint64_t hashes[2];
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    State state = thrown(c);
    run(c, state, 2000);
    CHECK(state.lost.empty());
    CHECK(state.pair_contacts.partner.size() > 500);
    hashes[threads - 1] = hash(state);
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("A run that goes on from a saved state gives the same bits") {
  const Case c = stirred_case(200, 400);
  State straight = thrown(c);
  Timings timings;
  physics::Mechanics mechanics(c);
  mechanics.advance(straight, 1500, timings);
  State resumed = straight;
  mechanics.advance(straight, 1500, timings);
  run(c, resumed, 1500);  // another machine
  CHECK(hash(straight) == hash(resumed));
}

// A force is summed in the order of the lists, which borders and skins decide; nothing else may
// depend on them. Sums of doubles differ by 1e-16; collisions multiply that.
TEST_CASE("Borders and the lists' skin change the result by rounding only") {
  Case c = bare_case();
  add_can(c, 0.01);
  fill(c, 100, 300, 0.01, 0.0);
  State once = opened(c), twice = once, wide = once;
  run(c, once, 1000);
  run(c, twice, 450);
  run(c, twice, 550);
  c.models.mechanics.skin = 1.3;
  run(c, wide, 1000);
  const auto by_id = [](const State& state) {
    std::vector<Vec3> places(state.particles.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      places[state.particles.id[i]] = state.particles.position[i];
    return places;
  };
  const auto largest_difference = [&](const State& a, const State& b) {
    double largest = 0.0;
    for (std::size_t id = 0; id < 400; ++id)
      largest = std::max(largest, (by_id(a)[id] - by_id(b)[id]).norm());
    return largest;
  };
  CHECK(once.pair_contacts.partner.size() > 100);
  CHECK(largest_difference(once, twice) < 1e-12);
  CHECK(largest_difference(once, wide) < 1e-12);
}

TEST_CASE("A bed comes to rest in a cylinder with nothing lost and a sane solid fraction") {
  Case c = bare_case();
  c.models.mechanics.time_step = 2e-5;
  add_can(c, 0.008);
  fill(c, 250, 250, 0.008, 0.0);
  State state = opened(c);
  const double start = physics::rms_speed(state.particles);
  CHECK(start == 0.0);
  run(c, state, 20000);
  CHECK(state.lost.empty());
  CHECK(physics::rms_speed(state.particles) < 1e-3);
  CHECK(state.extremes.overlap_ratio < 0.1);
  CHECK(state.fluxes.dissipated > 0.0);
  // Solids between 1/4 and 3/4 of the height: away from the floor's and the top's loose layers.
  double top = 0.0, solid = 0.0;
  for (const Vec3& x : state.particles.position) top = std::max(top, x[2]);
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    const double z = state.particles.position[i][2];
    if (z > 0.25 * top && z < 0.75 * top) solid += state.particles.mass[i] / 3500.0;
  }
  const double fraction = solid / (0.5 * top * pi * 0.008 * 0.008);
  CHECK(fraction > 0.50);  // random loose 0.56 less the wall's share at D/d = 8
  CHECK(fraction < 0.66);  // random close of two sizes
}

TEST_CASE("The weight of a settled bed stands on its walls") {
  Case c = bare_case();
  add_can(c, 0.006);
  fill(c, 30, 60, 0.006, 0.0);
  State state = opened(c);
  run(c, state, 60000);
  // Sum of contact forces: pairs cancel, walls carry the weight.
  Vec3 carried = Vec3::Zero();
  double weight = 0.0;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    carried += state.particles.force[i];
    weight += 9.81 * state.particles.mass[i];
  }
  CHECK((carried - Vec3(0, 0, weight)).norm() < 0.02 * weight);  // slow creep remains
}

TEST_CASE("A particle that leaves the domain is taken out and booked") {
  Case c = bare_case();
  c.gravity = Vec3::Zero();
  add_particle(c, Vec3(0, 0, 0), Vec3::Zero());
  add_particle(c, Vec3(0.0995, 0, 0), Vec3(1, 0, 0));
  add_particle(c, Vec3(1.95e-3, 0, 0), Vec3::Zero());  // touches the first
  State state = opened(c);
  run(c, state, 100);
  REQUIRE(state.lost.size() == 1);
  CHECK(state.lost[0].id == 1);
  CHECK(state.lost[0].time == Approx(5e-4).margin(1.01e-5));  // 0.5 mm at 1 m/s, one step
  CHECK(state.lost[0].position[0] == Approx(0.1).margin(1e-5));
  REQUIRE(state.particles.size() == 2);
  CHECK(state.particles.id[0] + state.particles.id[1] == 2);
  CHECK(state.pair_contacts.start.size() == 3);
  CHECK(state.particles.temperature.size() == 2);
  run(c, state, 100);
  CHECK(state.step == 200);
}

TEST_CASE("A motion that is no number stops the run with the particle and the time") {
  Case c = bare_case();
  add_particle(c, Vec3::Zero(), Vec3::Zero());
  add_particle(c, Vec3(0.01, 0, 0), Vec3::Zero());
  State state = opened(c);
  state.particles.velocity[1][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(run(c, state, 10), Catch::Contains("particle 1") && Catch::Contains("t ="));
  CHECK_THROWS_AS(run(c, state, 10), NumericsError);
}

TEST_CASE("No particle and one particle are beds too") {
  Case c = bare_case();
  add_can(c, 0.01);
  State none = opened(c);
  run(c, none, 10);
  CHECK(none.step == 10);
  CHECK(physics::rms_speed(none.particles) == 0.0);
  add_particle(c, Vec3(0, 0, 0.05), Vec3::Zero());
  State one = opened(c);
  run(c, one, 1000);
  CHECK(one.time == Approx(0.01));
  CHECK(one.particles.position[0][2] == Approx(0.05 - 0.5 * 9.81 * 1e-4).epsilon(1e-12));
}

// Johnson, Contact Mechanics (1985), eq. 4.23: F = 4/3 E* sqrt(R*) d^3/2, whose work from touch to
// d is 8/15 E* sqrt(R*) d^5/2 = 2/5 k_n d^2.
TEST_CASE("In the middle of a contact the springs hold the energy of Hertz") {
  const double modulus = 5e6 / (2.0 * (1.0 - 0.3 * 0.3));  // [Pa] E* of a soft sphere on its like
  const auto hertz = [&](double reduced_radius, double overlap) {
    return 8.0 / 15.0 * modulus * std::sqrt(reduced_radius) * std::pow(overlap, 2.5);
  };
  Case c = bare_case();
  c.gravity = Vec3::Zero();
  SECTION("of two unlike spheres") {
    c.particles.push_back({0, Vec3(0, 0, 0), Vec3(0, 0, 0.2), Vec3::Zero(), {}, {}});
    c.particles.push_back({1, Vec3(0, 0, 1.501 * radius), Vec3(0, 0, -0.3), Vec3::Zero(), {}, {}});
    State state = opened(c);
    run(c, state, 8);
    const auto& x = state.particles.position;
    const double overlap = 1.5 * radius - (x[0] - x[1]).norm();
    REQUIRE(overlap > 0.01 * radius);
    CHECK(state.elastic_energy == Approx(hertz(radius / 3.0, overlap)).epsilon(1e-9));
  }
  SECTION("of a sphere on a wall") {
    add_surface(c, rectangle(Vec3(-0.05, -0.05, 0), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0)), add_body(c));
    add_particle(c, Vec3(0, 0, 1.001 * radius), Vec3(0, 0, -0.5));
    State state = opened(c);
    run(c, state, 8);
    const double overlap = radius - state.particles.position[0].z();
    REQUIRE(overlap > 0.01 * radius);
    CHECK(state.elastic_energy == Approx(hertz(radius, overlap)).epsilon(1e-9));
  }
}
