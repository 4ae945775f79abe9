#include <cmath>

#include "physics/insertion.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"
#include "verify/check.hpp"
#include "verify/mechanics_collisions.hpp"
#include "verify/mechanics_scenes.hpp"

namespace pmr::verify {
namespace {

void check_time_step(std::vector<Check>& checks) {
  const physics::TimeStepReport report = physics::time_step(study_case(2e-5));
  checks.push_back({"mechanics.rayleigh", "Smallest critical step of the study's particles",
                    report.smallest_rayleigh, 1.058e-4, 5e-8, "s",
                    "closed form, by hand for the SrFeO3 granule; last digit"});
  checks.push_back({"mechanics.rayleigh.fraction", "The study's step over the critical step",
                    report.fraction, 0.189, 5e-4, "1", "demonstrator study; last digit"});
  const double e =
      physics::composite_restitution({0.75, 1.495e-3, 5e6, 0.3}, {0.24, 0.735e-3, 5e6, 0.3});
  checks.push_back({"mechanics.composite_restitution", "Restitution of a bead with a granule", e,
                    0.529, 5e-4, "1", "demonstrator study, eq. 10 (it rounds to 0.53)"});
}

// Heights of a bead that bounces on the coated wall, e = 0.5: h_k = (h0 - r) e^(2k) + r. A hundred
// times the study's modulus shortens the contacts, in which the weight takes g t_contact of speed.
void check_bounces(std::vector<Check>& checks) {
  constexpr double r = 1.495e-3, h0 = 0.05, e = 0.5;
  Case c = study_case(4e-7);
  for (Material& m : c.materials.list) m.young_soft = 5e8;
  add_floor(c);
  c.gravity = Vec3(0, 0, -9.81);
  add_particle(c, bead, Vec3(0, 0, h0), Vec3::Zero());
  Scene scene(c);
  double height = 0.0;
  bool has_risen = false;
  for (int k = 1; k <= 3;) {
    scene.advance(50);
    const Particles& p = scene.state.particles;
    const bool rises = p.velocity[0][2] > 0.0;
    if (rises) has_risen = true;
    height = std::max(has_risen ? height : 0.0, p.position[0][2]);
    if (rises || !has_risen) continue;
    const double expected = (h0 - r) * std::pow(e, 2 * k) + r;
    checks.push_back({"mechanics.bounce." + std::to_string(k), "Height of a bounce, e = 0.5",
                      height, expected, 5e-3 * expected, "m",
                      "closed form; the weight in the contacts, 2 g t_contact / v = 0.5 %"});
    has_risen = false;
    height = 0.0;
    ++k;
  }
}

// Overlap of an undamped Hertz collision at a fixed time, in n steps.
double overlap_after(int n) {
  const double time = 3e-4, r = 1.495e-3;
  Case c = study_case(time / n);
  for (PairContact& pair : c.materials.pairs) pair.restitution = 1.0;
  add_particle(c, bead, Vec3(-r, 0, 0), Vec3(0.5, 0, 0));
  add_particle(c, bead, Vec3(r, 0, 0), Vec3(-0.5, 0, 0));
  Scene scene(c);
  scene.advance(static_cast<std::uint64_t>(n));
  return 2.0 * r - (scene.state.particles.position[0] - scene.state.particles.position[1]).norm();
}

void check_order(std::vector<Check>& checks) {
  const double exact = overlap_after(51200);
  const double order =
      std::log2(std::abs(overlap_after(800) - exact) / std::abs(overlap_after(1600) - exact));
  checks.push_back({"mechanics.order", "Observed order of the integrator, Hertz without damping",
                    order, 2.0, 0.1, "1", "velocity Verlet; next term of the error"});
}

// Kinetic energy before = after + dissipated, for an oblique impact with spin on the wall: what the
// leapfrog does, so to rounding. And what a head-on collision takes is 1 - e^2 of its energy.
void check_energy_book(std::vector<Check>& checks) {
  constexpr double dt = 1e-6;
  Case c = study_case(dt);
  add_floor(c);
  add_particle(c, granule, Vec3(0, 0, 0.735e-3 + 1e-9), Vec3(0.6, 0.2, -0.8), Vec3(100, -300, 50));
  Scene scene(c);
  const double before = physics::kinetic_energy(scene.state.particles);
  watch_collision(scene, dt, 5000);
  const double after = physics::kinetic_energy(scene.state.particles);
  checks.push_back({"mechanics.energy", "Share of a collision's energy that the books miss",
                    (before - after - scene.state.fluxes.dissipated) / before, 0.0, 1e-12, "1",
                    "conservation, exact for the leapfrog"});

  Case pair = study_case(dt);
  add_particle(pair, bead, Vec3(-1.5e-3, 0, 0), Vec3(0.5, 0, 0));
  add_particle(pair, bead, Vec3(1.5e-3, 0, 0), Vec3(-0.5, 0, 0));
  Scene collision(pair);
  const double whole = physics::kinetic_energy(collision.state.particles);
  watch_collision(collision, dt, 5000);
  checks.push_back({"mechanics.dissipated", "Share of its energy that a head-on collision takes",
                    collision.state.fluxes.dissipated / whole, 1.0 - 0.75 * 0.75, 1e-3, "1",
                    "closed form, 1 - e^2"});
}

struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // [kg m/s], [kg m2/s]
  double linear_scale = 0.0, angular_scale = 0.0;      // sums of magnitudes
};

Momenta momenta(const Particles& p) {
  Momenta sum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 linear = p.mass[i] * p.velocity[i];
    const Vec3 spin = 0.4 * p.mass[i] * p.radius[i] * p.radius[i] * p.spin[i];
    sum.linear += linear;
    sum.angular += p.position[i].cross(linear) + spin;
    sum.linear_scale += linear.norm();
    sum.angular_scale += p.position[i].norm() * linear.norm() + spin.norm();
  }
  return sum;
}

// A cloud of both species without walls and weight, thrown at its middle.
void check_momenta(std::vector<Check>& checks) {
  Case c = study_case(2e-5);
  c.species[granule].count = 800;
  c.species[bead].count = 100;
  const Vec3 half(0.012, 0.012, 0.012);
  c.species[granule].region = c.species[bead].region = BoxRegion{-half, half};
  Scene scene(c);
  Particles& p = scene.state.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Random random(7, Purpose::test, p.id[i]);
    const Vec3 noise(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    p.velocity[i] = -50.0 * p.position[i] + noise;
    p.spin[i] = 500.0 * noise;
  }
  const Momenta before = momenta(p);
  scene.advance(500);
  const Momenta after = momenta(scene.state.particles);
  const char* source = "action and reaction; rounding of 500 steps";
  checks.push_back({"mechanics.momentum", "Change of momentum of a colliding cloud",
                    (after.linear - before.linear).norm() / before.linear_scale, 0.0, 1e-13, "1",
                    source});
  checks.push_back({"mechanics.angular_momentum", "Change of its angular momentum",
                    (after.angular - before.angular).norm() / before.angular_scale, 0.0, 1e-13, "1",
                    source});
}

}  // namespace

std::vector<Check> mechanics_checks() {
  std::vector<Check> checks;
  check_time_step(checks);
  add_liggghts_checks(checks);
  add_rolling_checks(checks);
  add_chung_ooi_checks(checks);
  check_bounces(checks);
  check_order(checks);
  check_energy_book(checks);
  check_momenta(checks);
  return checks;
}

}  // namespace pmr::verify
