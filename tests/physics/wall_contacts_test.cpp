// Edges, corners, seams and moving walls.
#include "physics/wall_contacts.hpp"

#include <catch2/catch.hpp>

#include "mechanics_scene.hpp"

using namespace pmr;
using namespace pmr::test;

namespace {

// Contacts of one sphere at x with the case's walls.
std::size_t contacts_at(Case c, const Vec3& x) {
  c.gravity = Vec3::Zero();
  add_particle(c, x, Vec3::Zero());
  State state = opened(c);
  run(c, state, 1);
  return state.wall_contacts.partner.size();
}

constexpr double deep = 0.98 * radius;  // [m] height of a centre that overlaps by 2 %

State rolled(Case c, const Shape& floor_left, const Shape* floor_right) {
  const auto body = add_body(c);
  add_surface(c, floor_left, body);
  if (floor_right != nullptr) add_surface(c, *floor_right, body);
  add_particle(c, Vec3(-5e-3, 1e-3, 0.999 * radius), Vec3(0.2, 0, 0), Vec3(0, 100, 20));
  State state = opened(c);
  run(c, state, 6000);
  return state;
}

}  // namespace

TEST_CASE("A sphere over the shared edge of two coplanar facets feels one contact") {
  Case c = bare_case();
  const auto body = add_body(c);
  add_surface(c, rectangle(Vec3(-0.01, -0.01, 0), Vec3(0.01, 0, 0), Vec3(0, 0.02, 0)), body);
  add_surface(c, rectangle(Vec3(0, -0.01, 0), Vec3(0.01, 0, 0), Vec3(0, 0.02, 0)), body);
  CHECK(contacts_at(c, Vec3(0, 0, deep)) == 1);
  CHECK(contacts_at(c, Vec3(1e-5, 0, deep)) == 1);
  CHECK(contacts_at(c, Vec3(-1e-4, 0.003, deep)) == 1);
}

TEST_CASE("A sphere over a convex edge feels one contact, in a concave corner one a side") {
  Case convex = bare_case();
  auto body = add_body(convex);
  add_surface(convex, rectangle(Vec3(-0.01, -0.01, 0), Vec3(0.01, 0, 0), Vec3(0, 0.02, 0)), body);
  add_surface(convex, rectangle(Vec3(0, -0.01, -0.01), Vec3(0, 0.02, 0), Vec3(0, 0, 0.01)), body);
  CHECK(contacts_at(convex, Vec3(0.5e-3, 0, 0.6e-3)) == 1);
  CHECK(contacts_at(convex, Vec3(0, 0, deep)) == 1);

  Case corner = bare_case();
  body = add_body(corner);
  const Vec3 x(0.02, 0, 0), y(0, 0.02, 0), z(0, 0, 0.02);
  add_surface(corner, rectangle(Vec3::Zero(), x, y), body);
  add_surface(corner, rectangle(Vec3::Zero(), y, z), body);
  add_surface(corner, rectangle(Vec3::Zero(), z, x), body);
  CHECK(contacts_at(corner, Vec3::Constant(deep)) == 3);
  CHECK(contacts_at(corner, Vec3(deep, deep, 0.01)) == 2);
  CHECK(contacts_at(corner, Vec3(0.01, 0.01, deep)) == 1);
}

TEST_CASE("A sphere that rolls over a seam feels neither a bump nor a loss of its springs") {
  const Case c = bare_case();
  const Plane plane{Vec3::Zero(), Vec3::UnitZ()};
  const Facet one = rectangle(Vec3(-0.04, -0.04, 0), Vec3(0.08, 0, 0), Vec3(0, 0.08, 0));
  const Facet left = rectangle(Vec3(-0.04, -0.04, 0), Vec3(0.04, 0, 0), Vec3(0, 0.08, 0));
  const Facet right = rectangle(Vec3(0, -0.04, 0), Vec3(0.04, 0, 0), Vec3(0, 0.08, 0));
  const Shape other = right;
  const State smooth = rolled(c, plane, nullptr);
  REQUIRE(smooth.particles.position[0][0] > 1e-3);  // it went across
  for (const State& seamed : {rolled(c, one, nullptr), rolled(c, left, &other)}) {
    const auto &p = smooth.particles, &q = seamed.particles;
    CHECK((p.position[0] - q.position[0]).norm() < 1e-12);  // rounding, in m
    CHECK((p.velocity[0] - q.velocity[0]).norm() < 1e-9);
    CHECK((p.spin[0] - q.spin[0]).norm() < 1e-6);
  }
}

TEST_CASE("Springs follow a contact across the sides of a polygonal pipe") {
  // Rolls down the inside of a 48-sided pipe and over its lowest edge; the springs carry on.
  Case c = bare_case();
  const auto body = add_body(c);
  const double r = 0.01, step = 2.0 * 3.14159265358979 / 48.0;
  for (int k = 0; k < 48; ++k) {
    const Vec3 a(r * std::cos(k * step), -0.02, r * std::sin(k * step));
    const Vec3 b(r * std::cos((k + 1) * step), -0.02, r * std::sin((k + 1) * step));
    add_surface(c, rectangle(a, b - a, Vec3(0, 0.04, 0)), body);
  }
  add_particle(c, Vec3(0.005, 0, -0.0074), Vec3::Zero());
  State state = opened(c);
  int breaks = 0, steps_in_contact = 0;
  Timings timings;
  physics::Mechanics mechanics(c);
  double before = 0.0;
  std::vector<std::uint32_t> sides;
  for (int k = 0; k < 4000; ++k) {
    mechanics.advance(state, 1, timings);
    if (state.wall_contacts.partner.empty()) continue;
    ++steps_in_contact;
    const double now = state.wall_contacts.rolling[0].norm();
    if (state.wall_contacts.partner != sides) {
      if (!sides.empty() && before > 1e-12 && now == 0.0) ++breaks;
      sides = state.wall_contacts.partner;
    }
    before = now;
  }
  CHECK(steps_in_contact > 3000);
  CHECK(breaks == 0);
}

TEST_CASE("A translating plate drags a sphere along until both go at one speed") {
  Case c = bare_case();
  add_surface(c, Plane{Vec3::Zero(), Vec3::UnitZ()},
              add_body(c, Translate{Vec3(0.1, 0, 0), 0.0, 10.0}));
  add_particle(c, Vec3(0, 0, radius), Vec3::Zero());
  State state = opened(c);
  run(c, state, 40000);
  CHECK(state.particles.velocity[0][0] == Approx(0.1).epsilon(1e-3));
  CHECK(state.particles.spin[0].norm() * radius < 1e-4);
}

TEST_CASE("A sphere follows a vibrating plate that accelerates less than gravity") {
  Case c = bare_case();
  const double amplitude = 1e-3, frequency = 10.0;  // 3.9 m/s2 at most
  const Motion motion = Oscillate{Vec3(0, 0, amplitude), frequency, 0.1};
  add_surface(c, Plane{Vec3::Zero(), Vec3::UnitZ()}, add_body(c, motion));
  add_particle(c, Vec3(0, 0, radius), Vec3::Zero());
  State state = opened(c);
  run(c, state, 30000);
  for (int k = 0; k < 100; ++k) {
    run(c, state, 100);
    const double plate = physics::pose(motion, state.time).translation[2];
    const double height = state.particles.position[0][2] - plate;
    CHECK(height == Approx(radius).margin(0.005 * radius));  // twice the static overlap
  }
}

TEST_CASE("Surfaces that are absent or hold no particles let them pass") {
  Case c = bare_case();
  add_surface(c, Plane{Vec3::Zero(), Vec3::UnitZ()}, add_body(c));
  c.walls.surfaces[0].holds_particles = false;
  CHECK(contacts_at(c, Vec3(0, 0, deep)) == 0);
  c.walls.surfaces[0].holds_particles = true;
  c.walls.surfaces[0].from = 1.0;
  CHECK(contacts_at(c, Vec3(0, 0, deep)) == 0);
  c.walls.surfaces[0].from = 0.0;
  CHECK(contacts_at(c, Vec3(0, 0, deep)) == 1);
}
