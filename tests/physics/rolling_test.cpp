// Rolling laws: the constant directional torque against its formula.
#include <catch2/catch.hpp>

#include "mechanics_scene.hpp"
#include "physics/contact_law.hpp"

using namespace pmr;
using namespace pmr::physics;
using namespace pmr::test;

namespace {

constexpr ContactModel directional{HertzCoulomb{}, Cdt{}};
constexpr ContactLaw law{4e6, 1e7, 900.0, 1300.0, 0.3, 0.13};

// A contact under z that spins by w [rad/s]: the normal spring holds 4e6 sqrt(R* d) d [N].
Touch<double> spinning(const Triple<double>& w) {
  return {{0, 0, 1}, 1e-6, {0, 0, -0.2}, {0, 0, 0}, w, 1.0, 0.5e-3, 1e-5};
}
constexpr double spring = 4e6 * 2.23606797749979e-5 * 1e-6;  // [N], sqrt(0.5e-3 * 1e-6)

}  // namespace

TEST_CASE("The directional torque is mu_r R* k_n d, whatever the spin and the damping") {
  const double torque = 0.13 * spring * 0.5e-3;
  for (const double w : {1e-3, 40.0}) {
    Springs<double> springs{};
    const auto f =
        single_contact(directional)(law, spinning({0.6 * w, -0.8 * w, 0}), 1e-5, springs);
    CHECK(f.rolling.x == Approx(0.6 * torque).epsilon(1e-12));
    CHECK(f.rolling.y == Approx(-0.8 * torque).epsilon(1e-12));
    CHECK(f.rolling.z == 0.0);
  }
}

TEST_CASE("Spin about the normal takes its share of the directional torque, and is not braked") {
  Springs<double> springs{};
  const auto f = single_contact(directional)(law, spinning({3.0, 0.0, 4.0}), 1e-5, springs);
  CHECK(f.rolling.x == Approx(0.6 * 0.13 * spring * 0.5e-3).epsilon(1e-12));
  CHECK(f.rolling.z == 0.0);
}

TEST_CASE("The directional torque remembers nothing and does not act at rest") {
  Springs<double> springs{{0, 0, 0}, {1e-7, 2e-7, 3e-7}};  // of a bed that another law has left
  const auto f = single_contact(directional)(law, spinning({0, 0, 0}), 1e-5, springs);
  for (const double m : {f.rolling.x, f.rolling.y, f.rolling.z}) CHECK(m == 0.0);
  for (const double m : {springs.rolling.x, springs.rolling.y, springs.rolling.z}) CHECK(m == 0.0);
}

TEST_CASE("The rolling law leaves forces and slip alone") {
  Springs<double> with{{1e-7, 0, 0}, {}}, without = with;
  const Touch<double> touch = spinning({20.0, 5.0, 1.0});
  const auto a = single_contact(directional)(law, touch, 1e-5, with);
  const auto b = single_contact({HertzCoulomb{}, Epsd2{}})(law, touch, 1e-5, without);
  CHECK(a.force.x == b.force.x);
  CHECK(a.force.z == b.force.z);
  CHECK(a.twist.y == b.twist.y);
  CHECK(a.elastic == b.elastic);
  CHECK(with.tangential.x == without.tangential.x);
}

// Both at the wall and between spheres: the case's law reaches both.
TEST_CASE("A case's rolling law brakes a sphere on a wall and one on another sphere") {
  for (const bool on_wall : {true, false}) {
    Case c = bare_case();
    c.models.mechanics.contact.rolling = Cdt{};
    c.gravity = Vec3::Zero();
    if (on_wall)
      add_surface(c, Plane{Vec3::Zero(), Vec3::UnitZ()}, add_body(c));
    else
      add_particle(c, Vec3(0, 0, -radius), Vec3::Zero());
    const double overlap = 1e-5;
    add_particle(c, Vec3(0, 0, radius - overlap), Vec3::Zero(), Vec3(0, 50.0, 0));
    State state = opened(c);
    run(c, state, 1);
    const ContactHistory& contacts = on_wall ? state.wall_contacts : state.pair_contacts;
    REQUIRE(contacts.rolling.size() == 1);
    CHECK(contacts.rolling[0] == Vec3::Zero());
  }
}

TEST_CASE("The directional torque brakes a rolling sphere at 5/7 mu_r g and leaves it creeping") {
  // v^2/(2 5/7 mu_r g); lever arms cost d/R = 0.1 %. At the end its spin turns about in each step.
  Case c = bare_case();
  c.models.mechanics.contact.rolling = Cdt{};
  add_surface(c, Plane{Vec3::Zero(), Vec3::UnitZ()}, add_body(c));
  const double overlap = 1.155e-6, v = 0.1;  // [m] that carries the weight, [m/s]
  add_particle(c, Vec3(0, 0, radius - overlap), Vec3(v, 0, 0), Vec3(0, v / radius, 0));
  State state = opened(c);
  run(c, state, 30000);
  const double brake = 5.0 / 7.0 * 0.1 * 9.81;
  CHECK(state.particles.position[0][0] == Approx(v * v / (2.0 * brake)).epsilon(5e-3));
  CHECK(std::abs(state.particles.velocity[0][0]) < 2.5 * 0.1 * 9.81 * 1e-5);
}
