// Particles that rain in.
#include "physics/pouring.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mechanics_scene.hpp"
#include "physics/neighbours.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// The small species from a disc 40 mm above the floor, 2000 a second, for a fill of 1 s.
Case pouring(std::size_t count) {
  Case c = bare_case();
  c.fill = FillPhase{1.0, {1e-3, 0.02}};
  c.species[1].count = count;
  c.species[1].pour = Pour{CylinderRegion{Vec3(0, 0, 0.04), 0.01, 0.0, 2e-3}, none, 2000.0,
                           Vec3(0, 0, -0.5), -std::numeric_limits<double>::infinity()};
  return c;
}

State begun(const Case& c) {
  State state;
  state.time = -1.0;
  state.waiting = physics::waiting_particles(c, 0);
  return state;
}

}  // namespace

TEST_CASE("Poured particles are due at their rate, by number or by mass") {
  Case c = pouring(1000);
  const auto by_number = physics::entries(c);
  REQUIRE(by_number.size() == 1000);
  CHECK(by_number[0].due == -1.0);
  CHECK(by_number[999].due == Approx(-1.0 + 999.0 / 2000.0));
  const double mass = 3500.0 * 4.0 / 3.0 * pi * std::pow(0.5e-3, 3);
  c.species[1].pour->mass_rate = 100.0 * mass;
  c.species[1].pour->begin = -0.25;
  CHECK(physics::entries(c)[50].due == Approx(-0.25 + 0.5));
}

TEST_CASE("Those that are due enter within their source, apart from all others") {
  const Case c = pouring(1000);
  const auto entries = physics::entries(c);
  State state = begun(c);
  state.time = -1.0 + 30.5 / 2000.0;
  CHECK(physics::pour(c, entries, state) == 31);
  CHECK(state.particles.size() == 31);
  CHECK(state.waiting.size() == 969);
  CHECK(state.waiting.id.front() == 31);
  CHECK(physics::pairs_within(state.particles, 0.0).empty());
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    const Vec3& x = state.particles.position[i];
    CHECK(x.head<2>().norm() + state.particles.radius[i] <= 0.01);
    CHECK(x[2] - state.particles.radius[i] >= 0.04);
    CHECK(x[2] + state.particles.radius[i] <= 0.042);
    CHECK(state.particles.velocity[i] == Vec3(0, 0, -0.5));
  }
  CHECK(physics::pour(c, entries, state) == 0);
}

TEST_CASE("A full source makes those behind wait, and none is lost") {
  const Case c = pouring(1000);
  const auto entries = physics::entries(c);
  State state = begun(c);
  state.time = 0.0;  // all are due, the disc holds about a hundred and fifty
  const std::size_t came = physics::pour(c, entries, state);
  CHECK(came > 50);
  CHECK(came < 300);
  CHECK(state.particles.size() + state.waiting.size() == 1000);
  CHECK(physics::pairs_within(state.particles, 0.0).empty());
  for (std::size_t i = 0; i < state.particles.size(); ++i) CHECK(state.particles.id[i] == i);
}

TEST_CASE("A newcomer has its row in the histories of contacts, and enters without a push") {
  Case c = pouring(600);
  add_can(c, 0.0105);
  const auto entries = physics::entries(c);
  State state = begun(c);
  for (int k = 0; k < 80; ++k) {
    physics::pour(c, entries, state);
    run(c, state, 500);
    ++state.interval;
  }
  CHECK(state.waiting.size() == 0);
  CHECK(state.particles.size() == 600);
  CHECK(state.pair_contacts.start.size() == 601);
  CHECK(state.pair_contacts.partner.size() > 100);
  // No faster than a free fall from the top of the source allows.
  CHECK(state.extremes.speed < std::sqrt(0.5 * 0.5 + 2.0 * 9.81 * 0.042));
}

TEST_CASE("Sources that cannot do what is asked are faults") {
  CHECK(physics::pouring_faults(pouring(1000)).empty());
  const auto late = physics::pouring_faults(pouring(3000));
  REQUIRE(late.size() == 1);
  CHECK_THAT(late[0].problem, Contains("due at 0.4995 s") && Contains("ends at 0 s"));
  Case narrow = pouring(10);
  narrow.species[1].diameters.assign(10, 0.021);
  REQUIRE(physics::pouring_faults(narrow).size() == 1);
  CHECK_THAT(physics::pouring_faults(narrow)[0].problem, Contains("too narrow"));
  Case outside = pouring(10);
  outside.domain_high = Vec3(0.1, 0.1, 0.041);
  REQUIRE(physics::pouring_faults(outside).size() == 1);
  CHECK_THAT(physics::pouring_faults(outside)[0].problem, Contains("outside the domain"));
}
