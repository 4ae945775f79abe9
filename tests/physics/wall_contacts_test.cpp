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

enum class Parts { of_one_body, of_two_bodies };

State rolled(Case c, const Shape& floor_left, const Shape* floor_right = nullptr,
             Parts parts = Parts::of_one_body) {
  const auto body = add_body(c);
  add_surface(c, floor_left, body);
  if (floor_right != nullptr)
    add_surface(c, *floor_right, parts == Parts::of_one_body ? body : add_body(c));
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
  CHECK(contacts_at(convex, Vec3(0.5e-3, 0, 0.8e-3)) == 1);
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
  const State smooth = rolled(c, plane);
  REQUIRE(smooth.particles.position[0][0] > 1e-3);  // it went across
  for (const State& seamed :
       {rolled(c, one), rolled(c, left, &other), rolled(c, left, &other, Parts::of_two_bodies)}) {
    const auto &p = smooth.particles, &q = seamed.particles;
    CHECK((p.position[0] - q.position[0]).norm() < 1e-12);  // rounding, in m
    CHECK((p.velocity[0] - q.velocity[0]).norm() < 1e-9);
    CHECK((p.spin[0] - q.spin[0]).norm() < 1e-6);
  }
}

namespace {

// Speed after and before of a sphere that hits the walls downwards at x, without gravity.
double rebound(Case c, const Vec3& x) {
  c.gravity = Vec3::Zero();
  c.materials.pairs = {{.friction = 0.3, .rolling_friction = 0.0, .restitution = 0.5}};
  c.models.mechanics.time_step = 2e-6;
  const double speed = 0.3;  // [m/s] overlap of 3 % of the radius
  add_particle(c, x, Vec3(0, 0, -speed));
  State state = opened(c);
  run(c, state, 1500);
  REQUIRE(state.wall_contacts.partner.empty());  // it is off again
  return state.particles.velocity[0].norm() / speed;
}

constexpr double above = 1.05 * radius;          // [m] height of a centre that is about to touch
constexpr double trough_radius = 16.7 * radius;  // [m] axis along y, lowest line at z = 0

// The trough, 3 radii to both sides of its lowest line, as strips `width` [m] wide that
// circumscribe it; an edge of them is the lowest line. Each is cut into triangles that are surfaces
// of their own.
void add_strips(Case& c, double width) {
  const double step = width / trough_radius;  // [rad]
  const double stretched = trough_radius / std::cos(0.5 * step);
  const auto corner = [&](int k, double y) {
    return Vec3(stretched * std::sin(k * step), y, trough_radius - stretched * std::cos(k * step));
  };
  const int reach = static_cast<int>(std::ceil(3.0 * radius / width));
  const auto body = add_body(c);
  for (int k = -reach; k < reach; ++k) {
    const Vec3 a = corner(k, -0.005), b = corner(k + 1, -0.005);
    const Vec3 a2 = corner(k, 0.005), b2 = corner(k + 1, 0.005);
    const Vec3 normal = (b - a).cross(a2 - a).normalized();
    add_surface(c, Facet{{{a, b, b2}}, normal}, body);
    add_surface(c, Facet{{{a, b2, a2}}, normal}, body);
  }
}

}  // namespace

TEST_CASE("A sphere rebounds from a meshed trough as from the round one, however fine the mesh") {
  Case round = bare_case();
  add_surface(round,
              Revolved{Vec3(0, -0.005, trough_radius), Vec3::UnitY(), trough_radius, 0.0,
                       trough_radius, 0.01, -1.0},
              add_body(round));
  const double smooth = rebound(round, Vec3(1e-6, 0, above));
  CHECK(smooth == Approx(0.5).margin(0.01));  // the restitution that was asked for
  // 3.3 to 0.04 mm for a sphere of 6 mm in a trough of 50 mm; the sphere over an edge, over a
  // facet.
  for (const double width : {1.1e-3, 0.3e-3, 0.06e-3, 0.0133e-3})
    for (const double aside : {1e-6, 0.3 * width}) {
      Case meshed = bare_case();
      add_strips(meshed, width);
      CAPTURE(width, aside);
      CHECK(rebound(meshed, Vec3(aside, 0, above)) == Approx(smooth).epsilon(0.02));
      add_surface(meshed, round.walls.surfaces[0].shape, add_body(meshed));  // both on each other
      CHECK(rebound(meshed, Vec3(aside, 0, above)) == Approx(smooth).epsilon(0.02));
    }
}

TEST_CASE("Seams up to a micrometre, steps and surfaces on each other count once") {
  const Vec3 x(1e-7, 2e-4, above);
  const Vec3 across(0.02, 0, 0), along(0, 0.02, 0), corner(0, -0.01, 0);
  const auto rebound_from = [&](const std::vector<Shape>& shapes) {
    Case c = bare_case();
    for (const Shape& shape : shapes) add_surface(c, shape, add_body(c));
    return rebound(c, x);
  };
  const Facet left = rectangle(corner - across, across, along);
  const double smooth = rebound_from({Plane{Vec3::Zero(), Vec3::UnitZ()}});
  CHECK(smooth == Approx(0.5).margin(0.01));
  for (const double gap : {0.0, 1e-9, 1e-8, 1e-6}) {
    CAPTURE(gap);
    const Vec3 apart(gap, 0, 0), below(0, 0, -gap);
    const Facet beside = rectangle(corner + apart, across, along);
    const Facet lower = rectangle(corner + below, across, along);
    // Two facets where the left one has one: their common corner lies within its edge (a T).
    const Facet near = rectangle(corner + apart, across, 0.5 * along);
    const Facet far = rectangle(corner + apart + 0.5 * along, across, 0.5 * along);
    CHECK(rebound_from({left, beside}) == Approx(smooth).margin(0.01));
    CHECK(rebound_from({left, lower}) == Approx(smooth).margin(0.01));
    CHECK(rebound_from({left, near, far}) == Approx(smooth).margin(0.01));
    const Revolved disc{Vec3(-0.01, 0, 0), Vec3::UnitZ(), 0.0, 0.0, 0.01, 0.0, -1.0};
    const Revolved ring{Vec3(-0.01, 0, -gap), Vec3::UnitZ(), 0.01, 0.0, 0.03, 0.0, -1.0};
    CHECK(rebound_from({disc, ring}) == Approx(smooth).margin(0.01));
    CHECK(rebound_from({disc, ring, Plane{below, Vec3::UnitZ()}}) == Approx(smooth).margin(0.01));
  }
}

TEST_CASE(
    "Two walls that meet under less than 15 degrees are one surface, from 25 degrees on two") {
  // Force upwards [1] of that on a plane, of a sphere in a groove whose sides rise by half the
  // angle to both sides: one contact gives cos(angle/2), two give 2 cos(angle/2).
  const auto force = [](double degrees) {
    Case c = bare_case();
    c.gravity = Vec3::Zero();
    const double half = 0.5 * degrees / 57.29577951308232, s = std::sin(half), t = std::cos(half);
    const auto body = add_body(c);
    add_surface(c, rectangle(Vec3(0, -0.01, 0), Vec3(0.02 * t, 0, 0.02 * s), Vec3(0, 0.02, 0)),
                body);
    add_surface(c, rectangle(Vec3(0, -0.01, 0), Vec3(0, 0.02, 0), Vec3(-0.02 * t, 0, 0.02 * s)),
                body);
    add_particle(c, Vec3(0, 0, deep / t), Vec3::Zero());
    State state = opened(c);
    run(c, state, 0);
    physics::WallContacts walls(c);
    const physics::Spheres spheres = physics::gather_spheres(state.particles);
    walls.place(0.0);
    walls.open(spheres, physics::cut(1), 1e-4, state.wall_contacts);
    physics::Load load[1] = {};
    walls.add_forces(0, spheres, 0.0, load);
    const double k_n =
        physics::contact_law(c.materials.list[0], c.materials.list[0], c.materials.pairs[0]).normal;
    const double overlap = radius - deep;
    return load[0].force.z() / (k_n * std::sqrt(radius * overlap) * overlap) / t;
  };
  CHECK(force(4.0) == Approx(1.0).epsilon(1e-6));
  CHECK(force(14.9) == Approx(1.0).epsilon(1e-6));
  for (const double degrees : {25.1, 45.0, 90.0, 120.0})
    CHECK(force(degrees) == Approx(2.0).epsilon(1e-6));
  double before = 1.0;
  for (double degrees = 1.0; degrees < 60.0; degrees += 0.5) {
    const double now = force(degrees);
    CHECK(now >= before - 1e-9);
    CHECK(now - before < 0.07);  // no jump: half a degree of ten
    before = now;
  }
}

TEST_CASE("No contact is lost however many facets a sphere overlaps") {
  Case c = bare_case();
  add_strips(c, 0.01e-3);
  add_surface(c, Plane{Vec3(0, 1e-3 - 0.995 * radius, 0), Vec3::UnitY()}, add_body(c));
  c.gravity = Vec3::Zero();
  add_particle(c, Vec3(0, 1e-3, 0.95 * radius), Vec3::Zero());  // overlaps 120 facets deeper
  State state = opened(c);
  run(c, state, 1);
  REQUIRE(state.wall_contacts.partner.size() == 2);
  CHECK(state.wall_contacts.partner[1] == c.walls.surfaces.size() - 1);
}

TEST_CASE("At a wall the rolling spring winds by the lever arm over the centre's distance") {
  Case c = bare_case();
  c.gravity = Vec3::Zero();
  c.materials.pairs = {{.friction = 0.0, .rolling_friction = 1e6, .restitution = 1.0}};
  add_surface(c, Plane{Vec3::Zero(), Vec3::UnitZ()}, add_body(c));
  const Vec3 spin(3.0, 4.0, 0.0);  // [rad/s]
  add_particle(c, Vec3(0, 0, 0.92 * radius), Vec3::Zero(), spin);
  State state = opened(c);
  run(c, state, 1);
  const Material& m = c.materials.list[0];
  const double distance = state.particles.position[0].z(), overlap = radius - distance;
  const double shear = m.young_soft / (4.0 * (2.0 - m.poisson_soft) * (1.0 + m.poisson_soft));
  const double k_t = 8.0 * shear * std::sqrt(radius * overlap);
  const double gain = (radius - 0.5 * overlap) / distance;  // 1.04 here
  REQUIRE(state.wall_contacts.rolling.size() == 1);
  const Vec3 expected = k_t * radius * radius * 1e-5 * gain * spin;  // a step of 10 us
  CHECK((state.wall_contacts.rolling[0] - expected).norm() < 1e-9 * expected.norm());
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
