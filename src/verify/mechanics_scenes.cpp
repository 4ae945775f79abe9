#include "verify/mechanics_scenes.hpp"

#include <algorithm>

#include "physics/insertion.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::verify {
namespace {

Material elastic(const char* name, double young, double poisson, double density) {
  Material m{};
  m.name = name;
  m.young_soft = young;
  m.poisson_soft = poisson;
  m.density = density;
  return m;
}

Species sphere(const char* name, std::uint32_t material, double diameter) {
  Species s{};
  s.name = name;
  s.material = material;
  s.diameter = diameter;
  return s;
}

Case empty_case(double time_step) {
  Case c{};
  c.gravity = Vec3::Zero();
  c.domain_low = Vec3::Constant(-10.0);
  c.domain_high = Vec3::Constant(10.0);
  c.models.mechanics = {time_step, 0.189, 0.5};
  return c;
}

}  // namespace

Case study_case(double time_step) {
  Case c = empty_case(time_step);
  c.materials.list = {elastic("SrFeO3", 5e6, 0.3, 3460.0), elastic("Al2O3", 5e6, 0.3, 3690.0),
                      elastic("wall", 5e6, 0.3, 2000.0)};
  // Rows: SrFeO3, Al2O3, coated wall. Demonstrator study, table 2: mu, mu_r, e.
  const PairContact ss{0.28, 0.38, 0.24}, aa{0.31, 0.10, 0.75}, as{0.30, 0.13, 0.53};
  const PairContact sw{0.39, 0.14, 0.48}, aw{0.36, 0.14, 0.50};
  c.materials.pairs = {ss, as, sw, as, aa, aw, sw, aw, sw};
  c.species = {sphere("granule", 0, 1.47e-3), sphere("bead", 1, 2.99e-3)};
  return c;
}

void add_floor(Case& c) {
  if (c.walls.bodies.empty()) c.walls.bodies.push_back({"rig", Rest{}});
  Surface floor;
  floor.name = "floor";
  floor.shape = Plane{Vec3::Zero(), Vec3::UnitZ()};
  floor.material = static_cast<std::uint32_t>(c.materials.list.size() - 1);
  c.walls.surfaces.push_back(floor);
}

Case one_material_case(const OneMaterial& m, double time_step) {
  Case c = empty_case(time_step);
  c.materials.list = {elastic("sphere", m.young, m.poisson, m.density),
                      elastic("wall", m.wall, m.poisson, m.density)};
  c.materials.pairs.assign(4, m.contact);
  c.species = {sphere("sphere", 0, 2.0 * m.radius)};
  return c;
}

void add_particle(Case& c, SpeciesIndex species, const Vec3& position, const Vec3& velocity,
                  const Vec3& spin) {
  c.particles.push_back({species, position, velocity, spin, {}, {}});
}

Scene::Scene(Case c) : case_(std::move(c)), mechanics_(case_) {
  state.particles = physics::insert(case_);
}

std::size_t Scene::place_of(ParticleId id) const {
  const auto& ids = state.particles.id;
  const auto found = std::find(ids.begin(), ids.end(), id);
  ensure(found != ids.end(), "a scene's particle is there");
  return static_cast<std::size_t>(found - ids.begin());
}

Collision watch_collision(Scene& scene, double time_step, std::uint64_t most_steps) {
  Collision seen;
  std::uint64_t touching = 0;
  for (std::uint64_t k = 0; k < most_steps; ++k) {
    scene.advance(1);
    if (scene.is_touching())
      ++touching;
    else if (touching > 0)
      break;
    seen.peak_force = std::max(seen.peak_force, scene.state.particles.force[0].norm());
  }
  seen.duration = static_cast<double>(touching + 1) * time_step;
  return seen;
}

}  // namespace pmr::verify
