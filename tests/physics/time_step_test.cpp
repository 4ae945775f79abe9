// How the time step follows from the particles.
#include "physics/time_step.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mechanics_scene.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

// Y* of like materials, 5 MPa and 0.3.
constexpr double effective = 0.5 * 5e6 / (1.0 - 0.09);  // [Pa]

double mass(double r) { return 3500.0 * 4.0 / 3.0 * pi * r * r * r; }

Case automatic() {
  Case c = bare_case();
  c.models.mechanics.time_step.reset();
  c.models.mechanics.fraction_of_rayleigh = 0.189;
  return c;
}

}  // namespace

TEST_CASE("The automatic step is a fraction of the smallest particle's Rayleigh step") {
  Case c = automatic();
  // pi R sqrt(rho/G) / (0.1631 nu + 0.8766), G = Y / (2 (1 + nu)); the small species has R = 0.5
  // mm.
  const auto critical = [](double r) {
    return pi * r * std::sqrt(3500.0 / (5e6 / 2.6)) / (0.1631 * 0.3 + 0.8766);
  };
  CHECK(physics::time_step(c).step == Approx(0.189 * critical(0.5e-3)).epsilon(1e-12));
  CHECK(physics::time_step(c).species == "small");
  c.species[0].diameters = {2e-3, 0.6e-3, 3e-3};
  CHECK(physics::time_step(c).step == Approx(0.189 * critical(0.3e-3)).epsilon(1e-12));
  CHECK(physics::time_step(c).species == "large");
}

TEST_CASE("A stated impact speed is resolved with twenty steps of a Hertz contact") {
  Case c = automatic();
  const double rayleigh = physics::time_step(c).step;
  // Duration 2.87 (m*^2/(R* Y*^2 v))^(1/5) (e.g. Johnson, Contact Mechanics, 1985, eq. 11.24).
  const auto duration = [](double r, double v) {
    const double m = 0.5 * mass(r);
    return 2.87 * std::pow(m * m / (0.5 * r * effective * effective * v), 0.2);
  };
  for (const double v : {0.5, 5.0}) {
    c.models.mechanics.impact_speed = v;
    CHECK(physics::time_step(c).step == Approx(duration(0.5e-3, v) / 20.0).epsilon(2e-3));
    CHECK(physics::time_step(c).step < rayleigh);
  }
  c.models.mechanics.impact_speed = 1e-4;
  CHECK(physics::time_step(c).step == rayleigh);
}

TEST_CASE("Twenty steps of a contact keep the restitution of an elastic collision within 0.5 %") {
  Case c = automatic();
  c.gravity = Vec3::Zero();
  c.materials.pairs = {{0.0, 0.0, 1.0}};
  c.models.mechanics.impact_speed = 2.0;
  add_particle(c, Vec3(-0.6e-3, 0, 0), Vec3(1, 0, 0));
  add_particle(c, Vec3(0.6e-3, 0, 0), Vec3(-1, 0, 0));
  for (auto& particle : c.particles) particle.species = 1;
  // The impact may fall anywhere in a step: ten starting places.
  for (int k = 0; k < 10; ++k) {
    c.particles[0].position[0] = -0.6e-3 - 2e-6 * k;
    State state = opened(c);
    run(c, state, 100);
    const double apart = (state.particles.velocity[1] - state.particles.velocity[0]).norm();
    CHECK(apart == Approx(2.0).epsilon(5e-3));
    CHECK(state.extremes.overlap_ratio > 0.01);
  }
}

TEST_CASE("An explicit step above 40 % of Rayleigh is a fault unless it is asked for") {
  Case c = automatic();
  const double critical = physics::time_step(c).smallest_rayleigh;
  c.models.mechanics.time_step = 0.39 * critical;
  CHECK(physics::time_step_fault(c).empty());
  c.models.mechanics.time_step = 0.45 * critical;
  CHECK_THAT(physics::time_step_fault(c), Contains("45 % of the Rayleigh step of small"));
  c.models.mechanics.allows_long_step = true;
  CHECK(physics::time_step_fault(c).empty());
}
