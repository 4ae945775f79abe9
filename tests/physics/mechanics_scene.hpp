// Cases for the tests of the mechanics, built in code.
#pragma once
#include <limits>

#include "physics/insertion.hpp"
#include "physics/mechanics.hpp"
#include "pmr/base/hash.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::test {

inline constexpr double radius = 1e-3;  // [m] of the large species; the small one has half

inline Species species(const char* name, double r) {
  Species s{};
  s.name = name;
  s.diameter = 2.0 * r;
  s.initial_temperature = 300.0;
  return s;
}

// Two sizes of one soft material under gravity, no walls, no particles.
inline Case bare_case() {
  Case c{};
  Material m{};
  m.density = 3500.0;
  m.young_soft = 5e6;
  m.poisson_soft = 0.3;
  c.materials.list = {m};
  c.materials.pairs = {{0.3, 0.1, 0.5}};
  c.species = {species("large", radius), species("small", 0.5 * radius)};
  c.seed = 1;
  c.gravity = Vec3(0, 0, -9.81);
  c.domain_low = Vec3::Constant(-0.1);
  c.domain_high = Vec3::Constant(0.1);
  c.models.mechanics = {1e-5, 0.2, 0.4};
  return c;
}

inline std::uint32_t add_body(Case& c, const Motion& motion = Rest{}) {
  c.walls.bodies.push_back({"body", motion});
  return static_cast<std::uint32_t>(c.walls.bodies.size() - 1);
}

inline void add_surface(Case& c, const Shape& shape, std::uint32_t body) {
  Surface s;
  s.name = "surface " + std::to_string(c.walls.surfaces.size());
  s.shape = shape;
  s.body = body;
  c.walls.surfaces.push_back(s);
}

inline void add_particle(Case& c, const Vec3& position, const Vec3& velocity,
                         const Vec3& spin = Vec3::Zero()) {
  c.particles.push_back({0, position, velocity, spin, {}, {}});
}

// Rectangle corner, corner + a, corner + a + b, corner + b of two triangles.
inline Facet rectangle(const Vec3& corner, const Vec3& a, const Vec3& b) {
  return {{{corner, corner + a, corner + a + b}, {corner, corner + a + b, corner + b}},
          a.cross(b).normalized()};
}

// An upright can of radius r [m] with its floor at z = 0.
inline void add_can(Case& c, double r, const Motion& floor_motion = Rest{}) {
  add_surface(c, Revolved{Vec3::Zero(), Vec3::UnitZ(), r, -0.05, r, 0.09, -1.0}, add_body(c));
  add_surface(c, Revolved{Vec3::Zero(), Vec3::UnitZ(), 0.0, 0.0, r, 0.0, -1.0},
              add_body(c, floor_motion));
}

inline void fill(Case& c, std::size_t large, std::size_t small, double r, double base) {
  c.species[0].count = large;
  c.species[1].count = small;
  c.species[0].region = c.species[1].region = CylinderRegion{Vec3(0, 0, base), r, 0.0, 0.09 - base};
}

inline State opened(const Case& c) {
  State state;
  state.particles = physics::insert(c);
  return state;
}

inline void run(const Case& c, State& state, std::uint64_t steps) {
  Timings timings;
  physics::Mechanics(c).advance(state, steps, timings);
}

inline std::uint64_t hash(const State& state) {
  Hash h;
  const auto add = [&](const auto& list) { h.bytes(list.data(), list.size() * sizeof(list[0])); };
  for_each_field(state.particles, [&](const char*, const char*, const auto& f) { add(f); });
  for (const ContactHistory* contacts : {&state.pair_contacts, &state.wall_contacts}) {
    add(contacts->start);
    add(contacts->partner);
    add(contacts->tangential);
    add(contacts->rolling);
  }
  h.add(state.fluxes.dissipated);
  h.add(state.time);
  return h.value();
}

}  // namespace pmr::test
