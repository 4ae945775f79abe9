// Grains that adhere to walls: what a sphere feels that meets one, and what the wall then bears.
#include "physics/adhered.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mechanics_scene.hpp"
#include "physics/grain_layer.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

using namespace pmr;
using namespace pmr::test;
using physics::first_adhered_id;

namespace {

Case weightless() {
  Case c = bare_case();
  c.gravity = Vec3::Zero();
  return c;
}

void adhere(Case& c, const Vec3& centre, double r, std::uint32_t body) {
  c.walls.grains.push_back({body, 0, r, centre});
}

double mass_of(const State& state) { return state.particles.mass[0]; }

// A plate of grains that stand in a square lattice, and a can round it.
Case rough_can(const Motion& motion = Rest{}) {
  Case c = bare_case();
  add_can(c, 10e-3, motion);
  const std::uint32_t floor = 1;
  for (int i = -5; i <= 5; ++i)
    for (int j = -5; j <= 5; ++j)
      if (i * i + j * j <= 20)
        adhere(c, Vec3(1.9e-3 * i, 1.9e-3 * j, 0.05e-3 * ((7 * i + 3 * j) % 3)), 0.9e-3, floor);
  fill(c, 150, 400, 10e-3, 1.5e-3);
  return c;
}

}  // namespace

// Energy: m v^2 / 2 = 8/15 Y* sqrt(R*) d^(5/2) at the deepest point, without damping; m* = m of the
// sphere, R* = R r / (R + r).
TEST_CASE("A sphere meets an adhered grain with its own mass and the radius of both") {
  Case c = weightless();
  c.materials.pairs = {{0.3, 0.1, 1.0}};
  c.models.mechanics.time_step = 2e-7;
  const double r = 0.5 * radius, speed = 0.3;
  adhere(c, Vec3::Zero(), r, add_body(c));
  add_particle(c, Vec3(0, 0, 1.001 * (radius + r)), Vec3(0, 0, -speed));
  State state = opened(c);
  run(c, state, 12000);
  const double young = 0.5 * 5e6 / (1.0 - 0.09);  // [Pa] Y*
  const double reduced = radius * r / (radius + r);
  const double energy = 0.5 * mass_of(state) * speed * speed;
  const double deepest = std::pow(energy / (8.0 / 15.0 * young * std::sqrt(reduced)), 0.4);
  CHECK(state.extremes.overlap_ratio * r == Approx(deepest).epsilon(1e-4));
  CHECK(state.particles.velocity[0].z() == Approx(speed).epsilon(1e-4));
}

// In the frame of the body the sphere comes in with -v and leaves with e v.
TEST_CASE("A grain that its body moves throws a sphere off at (1 + e) v, and the loss is booked") {
  for (const bool is_grain : {true, false}) {
    Case c = weightless();
    c.models.mechanics.time_step = 1e-6;
    const double speed = 0.2, e = 0.5;
    const auto body = add_body(c, Translate{Vec3(0, 0, speed), 0.0, 1.0});
    if (is_grain)
      adhere(c, Vec3(0, 0, -radius), radius, body);
    else
      add_surface(c, rectangle(Vec3(-0.01, -0.01, 0), Vec3(0.02, 0, 0), Vec3(0, 0.02, 0)), body);
    add_particle(c, Vec3(0, 0, 1.02 * radius), Vec3::Zero());
    State state = opened(c);
    for (int k = 0; k < 8; ++k) run(c, state, 500);
    CHECK(state.particles.velocity[0].z() == Approx((1.0 + e) * speed).epsilon(0.02));
    const double relative = state.particles.velocity[0].z() - speed;
    const double lost = 0.5 * mass_of(state) * (speed * speed - relative * relative);
    CHECK(state.fluxes.dissipated == Approx(lost).epsilon(2e-3));
  }
}

// A sphere in the pit between three grains of a tilted plate is held by their springs alone; they
// stand in the history and go over from call to call.
TEST_CASE("Contacts with adhered grains are remembered over calls and particles' new order") {
  Case c = rough_can();
  State whole = opened(c), pieces = opened(c);
  run(c, whole, 6000);
  for (int k = 0; k < 60; ++k) run(c, pieces, 100);
  std::size_t with_grains = 0;
  for (const std::uint32_t partner : pieces.pair_contacts.partner)
    with_grains += partner >= first_adhered_id ? 1 : 0;
  CHECK(with_grains > 50);
  CHECK(pieces.pair_contacts.start.size() == pieces.particles.size() + 1);
  CHECK(physics::rms_speed(pieces.particles) < 0.02);
  // springs that were dropped at each call would give way to the load again and again
  double stored = 0.0, stored_whole = 0.0;
  for (const Vec3& d : pieces.pair_contacts.tangential) stored += d.norm();
  for (const Vec3& d : whole.pair_contacts.tangential) stored_whole += d.norm();
  CHECK(stored == Approx(stored_whole).epsilon(0.2));
}

TEST_CASE("Adhered grains and their wall bear the weight of the bed where it lies") {
  Case c = rough_can();
  c.wall_forces = {{"body", 1, Vec3::Zero()}};
  State state = opened(c);
  Timings timings;
  physics::Mechanics mechanics(c);
  mechanics.advance(state, 20000, timings);
  mechanics.advance(state, 2000, timings);
  double weight = 0.0;
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    const Vec3 own = state.particles.mass[i] * c.gravity;
    weight += own.norm();
    moment += state.particles.position[i].cross(own);
  }
  const auto& loads = mechanics.mean_wall_loads();
  REQUIRE(loads.size() == 2);
  const Vec3 force = loads[0].force + loads[1].force, torque = loads[0].torque + loads[1].torque;
  CHECK(-force.z() == Approx(weight).epsilon(0.01));
  CHECK(force.head<2>().norm() < 0.01 * weight);
  CHECK((torque - moment).norm() < 0.01 * weight * 10e-3);
  CHECK(-loads[1].force.z() > 0.5 * weight);  // the floor, not the side
}

TEST_CASE("A bed on a rough floor that shakes has the same bits on any number of threads") {
  const auto hash_with = [](int threads) {
    const ThreadLimit only(threads);
    Case c = rough_can(Oscillate{Vec3(1e-3, 0, 0), 50.0, 0.0});
    for (Species& one : c.species)
      one.region = CylinderRegion{Vec3(0, 0, 1.5e-3), 8e-3, 0.0, 85e-3};
    c.domain_high = Vec3(0.1, 7.6e-3, 0.1);  // some that spread are lost on the way
    State state = opened(c);
    for (int k = 0; k < 4; ++k) run(c, state, 1500);
    CHECK(state.lost.size() > 0);
    return hash(state);
  };
  CHECK(hash_with(1) == hash_with(2));
}

TEST_CASE("A layer covers its share of the face, within it, and nothing overlaps much") {
  const double d = 1.47e-3;
  for (const physics::Face& face :
       {physics::Face{{60e-3, 30e-3}}, physics::Face{{0, 0}, 30e-3, 0.0},
        physics::Face{{0, 0}, 30e-3, 12e-3}})
    for (const double part : {0.75, physics::densest_layer})
      for (const std::uint64_t seed : {1, 2, 3}) {  // some shut grains in at first
        const auto places = *physics::grain_layer(face, d, part, seed, 0);
        const double covered = static_cast<double>(places.size()) * pi / 4.0 * d * d;
        CHECK(covered == Approx(part * face.area()).epsilon(1e-3));
        double closest = 1.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j)
            closest = std::min(closest, (places[i] - places[j]).norm());
          if (face.radius > 0.0) {
            CHECK(places[i].norm() <= face.radius - 0.4999 * d);
            CHECK(places[i].norm() >= face.inner + (face.inner > 0.0 ? 0.4999 * d : 0.0));
          } else {
            CHECK((places[i].minCoeff() >= 0.4999 * d && places[i][0] <= 60e-3 - 0.4999 * d));
          }
        }
        CHECK(closest >= 0.98 * d);
        const auto others = *physics::grain_layer(face, d, part, seed + 1, 0);
        CHECK(others.front() != places.front());
      }
}

TEST_CASE("A face that so many grains do not fit on has no layer") {
  // Seven spheres of 2.99 mm stand side by side on 20.5 mm at the least (a fiftieth overlapping).
  CHECK_FALSE(physics::grain_layer({{20e-3, 3.1e-3}}, 2.99e-3, 0.78, 1, 0));
  CHECK(physics::grain_layer({{21e-3, 3.1e-3}}, 2.99e-3, 0.75, 1, 0));
}
