// Forces between two touching spheres, or a sphere and a wall: Hertz with damping, tangential
// spring with history, Coulomb friction, EPSD2 rolling resistance (Ai et al., Powder Technol. 206
// (2011) 269), term by term as LIGGGHTS 3.8.0 executes them (the contact parameters of the
// demonstrator study were calibrated with that code, so its order of operations is the model):
//   normal        F_n = k_n d - c_n v_n, may attract at the end of a contact;
//   tangential    the spring takes the slip of this step, then is projected into the contact plane;
//                 the Coulomb cap mu |F_n| tests the spring alone; damping is added while it
//                 sticks and dropped while it slides;
//   rolling       torque spring k_r = k_t R*^2 on the relative spin without its normal part,
//                 capped and stored at mu_r R* |F_n|, neither projected nor rescaled; at a wall
//                 the spin counts (R - d/2)/(R - d) times;
//   lever arms    R - d/2.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "pmr/base/vec3.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/materials.hpp"

namespace pmr::physics {

// What of the law depends on the two materials only. With s = sqrt(R* d):
struct ContactLaw {
  double normal;              // [Pa] k_n = normal s, normal = 4/3 Y*
  double tangential;          // [Pa] k_t = tangential s, tangential = 8 G*
  double normal_damping;      // [Pa^1/2] c_n = normal_damping sqrt(m* s)
  double tangential_damping;  // [Pa^1/2] c_t likewise
  double friction;            // mu [1]
  double rolling_friction;    // mu_r [1]
};

ContactLaw contact_law(const Material& a, const Material& b, const PairContact& pair);

// 1/Y* = (1 - nu_a^2)/Y_a + (1 - nu_b^2)/Y_b [Pa], softened moduli.
double effective_young(const Material& a, const Material& b);

// Laws of all pairs of species and of all species with all wall materials.
class ContactLaws {
 public:
  explicit ContactLaws(const Case& c);
  const ContactLaw& between(std::uint32_t species_i, std::uint32_t species_j) const {
    return pairs_[species_i * species_ + species_j];
  }
  const ContactLaw& with_wall(std::uint32_t species, std::uint32_t material) const {
    return walls_[species * materials_ + material];
  }

 private:
  std::size_t species_, materials_;
  std::vector<ContactLaw> pairs_, walls_;
};

// Relative state of a contact of i with j; j may be a wall.
struct Touch {
  Vec3 n;                 // [1] unit, from j to i
  double overlap;         // [m]
  Vec3 velocity;          // [m/s] of i relative to j, at the centres (a wall: at the contact)
  Vec3 surface_spin;      // [m/s] arm_i w_i + arm_j w_j
  Vec3 relative_spin;     // [rad/s] w_i - w_j
  double rolling_gain;    // [1] of the spin that winds the rolling spring
  double reduced_radius;  // R* [m]
  double inverse_mass;    // 1/m* [1/kg]
};

// What a contact remembers.
struct Springs {
  Vec3 tangential;  // [m] displacement
  Vec3 rolling;     // [N m] torque
};

struct ContactForce {
  Vec3 force;    // [N] on i, -force on j
  Vec3 twist;    // [N] n x F_t: torque on i -arm_i twist - rolling, on j -arm_j twist + rolling
  Vec3 rolling;  // [N m]
  double dissipated;  // [J] in this step, see below
};

// `dissipated` is the work taken by normal damping and by all tangential and rolling resistance
// (what their springs hold is counted until they give it back), so that kinetic + potential +
// Hertz energy + dissipated is constant between resting walls. Work is force times the velocity in
// the middle of both half kicks, to which this contact's own kick is counted (exact for a lone
// contact, 7/2 = 1 + m R^2/I for the slip).
[[gnu::always_inline]] inline ContactForce evaluate(const ContactLaw& law, const Touch& t,
                                                    double dt, Springs& springs) {
  const double s = std::sqrt(t.reduced_radius * t.overlap);  // [m] radius of the contact's area
  const double root = std::sqrt(s / t.inverse_mass);         // [kg^1/2 m^1/2]
  const double half_kick = 0.5 * dt * t.inverse_mass;        // [s/kg]

  const double v_n = t.velocity.dot(t.n);
  const double damping = -law.normal_damping * root * v_n;
  const double f_n = law.normal * s * t.overlap + damping;
  double dissipated = -damping * (v_n + half_kick * f_n);

  const double k_t = law.tangential * s;
  const Vec3 slip = t.velocity - v_n * t.n - t.surface_spin.cross(t.n);
  Vec3 d_t = springs.tangential + dt * slip;
  d_t -= d_t.dot(t.n) * t.n;
  const double spring_squared = k_t * k_t * d_t.squaredNorm();
  const double limit = law.friction * std::abs(f_n);
  Vec3 f_t;
  if (spring_squared > limit * limit) {
    d_t *= limit / std::sqrt(spring_squared);
    f_t = -k_t * d_t;
  } else {
    f_t = -k_t * d_t - law.tangential_damping * root * slip;
  }
  springs.tangential = d_t;
  dissipated -= f_t.dot(slip + 3.5 * half_kick * f_t);

  const double k_r = k_t * t.reduced_radius * t.reduced_radius;
  const Vec3 roll = t.relative_spin - t.relative_spin.dot(t.n) * t.n;
  Vec3 torque = springs.rolling + (k_r * dt * t.rolling_gain) * roll;
  const double torque_limit = law.rolling_friction * t.reduced_radius * std::abs(f_n);
  const double torque_squared = torque.squaredNorm();
  if (torque_squared > torque_limit * torque_limit)
    torque *= torque_limit / std::sqrt(torque_squared);
  springs.rolling = torque;
  dissipated += torque.dot(roll);

  return {f_n * t.n + f_t, t.n.cross(f_t), torque, dissipated * dt};
}

// Potential energy of the Hertz spring, 2/5 k_n d^2 [J]; overlap and R* in [m].
inline double hertz_energy(const ContactLaw& law, double reduced_radius, double overlap) {
  return 0.4 * law.normal * std::sqrt(reduced_radius * overlap) * overlap * overlap;
}

// Restitution of a contact between unlike materials from those of like pairs: the mean of the
// squares, weighed crosswise with (Y/(1-nu^2) sqrt(R))^(2/3), the share of a body's deformation
// being the larger the softer it is (demonstrator study, eq. 9; with equal moduli eq. 10).
struct RestitutionSide {
  double restitution;  // [1] of the like pair
  double radius;       // [m]
  double young;        // [Pa]
  double poisson;      // [1]
};
double composite_restitution(const RestitutionSide& a, const RestitutionSide& b);

}  // namespace pmr::physics
