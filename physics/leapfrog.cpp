#include "physics/leapfrog.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>

namespace pmr::physics {
namespace {

// Three numbers of a vector and a fourth that stands behind it in its record.
using Quad = __m256d;

Quad quad(const double* p) { return _mm256_loadu_pd(p); }
Quad all(double x) { return _mm256_set1_pd(x); }
Quad without_fourth(Quad a) { return _mm256_blend_pd(a, _mm256_setzero_pd(), 8); }
double sum_of_three(Quad a) { return a[0] + a[1] + a[2]; }
Vec3 to_vec3(Quad a) { return {a[0], a[1], a[2]}; }
Eigen::Array4d array(Quad a) { return {a[0], a[1], a[2], 0.0}; }

// One particle's motion and what its load makes of it in half a sub-step.
struct OwnMotion {
  Quad velocity, spin;        // fourth: as it stands in Kinetics
  Quad force, torque;         // fourth: 0
  Quad half_kick, half_turn;  // fourth: 0
};

OwnMotion motion_of(const Kinetics& k, const Load& load, double half, Quad gravity) {
  OwnMotion m{quad(k.velocity.data()),
              quad(k.spin.data()),
              quad(load.force.data()),
              quad(load.torque.data()),
              {},
              {}};
  m.half_kick = all(half) * (all(k.inverse_mass) * m.force + gravity);
  m.half_turn = all(half * k.inverse_inertia) * m.torque;
  return m;
}

void kick(OwnMotion& m) {
  m.velocity += m.half_kick;
  m.spin += m.half_turn;
}

Quad power(const OwnMotion& m) { return m.force * m.velocity + m.torque * m.spin; }

void put(const OwnMotion& m, Kinetics& k) {
  _mm256_storeu_pd(k.velocity.data(), m.velocity);
  _mm256_storeu_pd(k.spin.data(), m.spin);
}

Quad gravity_of(const Leapfrog& l) {
  return _mm256_setr_pd(l.gravity[0], l.gravity[1], l.gravity[2], 0.0);
}

}  // namespace

Passage kick_and_drift(const Spheres& spheres, std::span<const Load> loads, const Block& block,
                       const Leapfrog& leapfrog, bool ends_step, Places& after) {
  const double half = 0.5 * leapfrog.dt;
  const Quad gravity = gravity_of(leapfrog), dt = without_fourth(all(leapfrog.dt));
  const Quad none_low = all(1e300), none_high = all(-1e300);
  Quad block_low = none_low, block_high = none_high;
  Quad work = all(0.0), broken = all(0.0);
  double speed_squared = 0.0;
  VelocityRange of_block;
  for (std::uint32_t first = block.first; first < block.last; first += run_length) {
    const std::uint32_t last = std::min<std::uint32_t>(block.last, first + run_length);
    Quad low = none_low, high = none_high, slowest = none_low, fastest = none_high;
    for (std::uint32_t i = first; i < last; ++i) {
      OwnMotion m = motion_of(spheres.kinetics[i], loads[i - block.first], half, gravity);
      if (ends_step) kick(m);
      work += power(m);
      kick(m);
      put(m, after.kinetics[i]);
      const Quad x = quad(spheres.sphere[i].position.data()) + dt * m.velocity;
      _mm256_storeu_pd(after.sphere[i].position.data(), x);
      slowest = _mm256_min_pd(slowest, m.velocity);
      fastest = _mm256_max_pd(fastest, m.velocity);
      low = _mm256_min_pd(low, x);
      high = _mm256_max_pd(high, x);
      broken = _mm256_or_pd(broken, _mm256_cmp_pd(x, x, _CMP_UNORD_Q));
      speed_squared = std::max(speed_squared, sum_of_three(m.velocity * m.velocity));
    }
    after.run_box[first / run_length] = {to_vec3(low), to_vec3(high)};
    after.run_velocity[first / run_length] = {array(slowest), array(fastest)};
    of_block.include(after.run_velocity[first / run_length]);
    block_low = _mm256_min_pd(block_low, low);
    block_high = _mm256_max_pd(block_high, high);
  }
  after.block_box[block.number] = {to_vec3(block_low), to_vec3(block_high)};
  after.block_velocity[block.number] = of_block;
  return {.fastest = std::sqrt(speed_squared),
          .is_finite = _mm256_movemask_pd(broken) == 0,
          .contact_work = (ends_step ? leapfrog.dt : half) * sum_of_three(work)};
}

Passage kick(const Spheres& spheres, std::span<const Load> loads, const Block& block,
             const Leapfrog& leapfrog, Places& after) {
  const double half = 0.5 * leapfrog.dt;
  const Quad gravity = gravity_of(leapfrog);
  Quad work = all(0.0);
  for (std::uint32_t i = block.first; i < block.last; ++i) {
    OwnMotion m = motion_of(spheres.kinetics[i], loads[i - block.first], half, gravity);
    kick(m);
    work += power(m);
    put(m, after.kinetics[i]);
    after.sphere[i] = spheres.sphere[i];
  }
  after.block_box[block.number] = spheres.block_box[block.number];
  Passage passage;
  passage.contact_work = half * sum_of_three(work);
  return passage;
}

}  // namespace pmr::physics
