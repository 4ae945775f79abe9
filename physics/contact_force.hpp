// Forces between two touching spheres, or a sphere and a wall. A run has one force law and one
// rolling law (pmr/state/contact_laws.hpp), each a type with an overload here; `evaluate` joins
// them and is instantiated once for each pair. What they are now, term by term as LIGGGHTS 3.8.0
// executes them (the contact parameters of the demonstrator study were calibrated with that code,
// so its order of operations is the model), with R*, m* reduced radius and mass, lever arms
// R - d/2. Written once for a real that is a double (walls, tests) or several contacts side by
// side; nothing here may have code that processors would share.
#pragma once
#include <cmath>

#include "physics/triple.hpp"
#include "pmr/state/contact_laws.hpp"

namespace pmr::physics {

// What of the laws depends on the two materials only. With s = sqrt(R* d):
template <class Real>
struct LawOf {
  Real normal;              // [Pa] k_n = normal s, normal = 4/3 Y*
  Real tangential;          // [Pa] k_t = tangential s, tangential = 8 G*
  Real normal_damping;      // [Pa^1/2] c_n = normal_damping sqrt(m* s)
  Real tangential_damping;  // [Pa^1/2] c_t likewise
  Real friction;            // mu [1]
  Real rolling_friction;    // mu_r [1]
};
using ContactLaw = LawOf<double>;

// Relative state of a contact of i with j; j may be a wall.
template <class Real>
struct Touch {
  Triple<Real> n;              // [1] unit, from j to i
  Real overlap;                // [m]
  Triple<Real> velocity;       // [m/s] of i relative to j, at the centres (a wall: at the contact)
  Triple<Real> surface_spin;   // [m/s] arm_i w_i + arm_j w_j
  Triple<Real> relative_spin;  // [rad/s] w_i - w_j
  Real rolling_gain;           // [1] of the spin that winds the rolling spring
  Real reduced_radius;         // R* [m]
  Real reduced_mass;           // m* [kg]
};

// What a contact remembers.
template <class Real>
struct Springs {
  Triple<Real> tangential;  // [m] displacement
  Triple<Real> rolling;     // [N m] torque
};

template <class Real>
struct ContactForce {
  Triple<Real> force;  // [N] on i, -force on j
  Triple<Real>
      twist;  // [N] n x F_t: torque on i -arm_i twist - rolling, on j -arm_j twist + rolling
  Triple<Real> rolling;  // [N m]
  Real elastic;          // [J] energy of the normal spring
};

// What a force law gives, and rolling laws build on.
template <class Real>
struct SurfaceForce {
  Real spring;                // [N] k_n d
  Real normal;                // [N] F_n, damping included
  Real tangential_stiffness;  // [N/m] k_t
  Triple<Real> force;         // [N] on i
  Triple<Real> twist;         // [N] n x F_t
  Real energy;                // [J] of the normal spring; Hertz: 2/5 k_n d^2
};

// Normal: F_n = k_n d - c_n v_n, may attract at the end of a contact. Tangential: the spring takes
// the slip of this step, then is projected into the contact plane; the Coulomb cap mu |F_n| tests
// the spring alone; damping is added while it sticks and dropped while it slides.
template <class Real>
[[gnu::always_inline]] inline SurfaceForce<Real> surface_force(HertzCoulomb, const LawOf<Real>& law,
                                                               const Touch<Real>& t, const Real& dt,
                                                               Triple<Real>& history) {
  using std::abs, std::sqrt;
  const Real zero{0.0}, one{1.0};
  const Real s = sqrt(t.reduced_radius * t.overlap);  // [m] radius of the contact's area
  const Real root = sqrt(t.reduced_mass * s);         // [kg^1/2 m^1/2]

  const Real v_n = dot(t.velocity, t.n);
  const Real spring = law.normal * s * t.overlap;
  const Real f_n = minus(spring, law.normal_damping * root, v_n);

  const Real k_t = law.tangential * s;
  const Triple<Real> slip = minus(t.velocity, v_n, t.n) - cross(t.surface_spin, t.n);
  Triple<Real> d_t = plus(history, dt, slip);
  d_t = minus(d_t, dot(d_t, t.n), t.n);
  const Real spring_squared = k_t * k_t * dot(d_t, d_t);
  const Real limit = law.friction * abs(f_n);
  const auto slides = spring_squared > limit * limit;
  if (any(slides)) d_t = select(slides, limit / sqrt(spring_squared), one) * d_t;
  const Real c_t = select(slides, zero, law.tangential_damping * root);
  const Triple<Real> f_t = minus((zero - k_t) * d_t, c_t, slip);
  history = d_t;
  return {spring, f_n, k_t, plus(f_t, f_n, t.n), cross(t.n, f_t), Real{0.4} * spring * t.overlap};
}

// Torque spring k_r = k_t R*^2 on the relative spin without its normal part, capped and stored at
// mu_r R* |F_n|, neither projected nor rescaled; at a wall the spin counts (R - d/2)/(R - d) times.
template <class Real>
[[gnu::always_inline]] inline Triple<Real> rolling_torque(Epsd2, const LawOf<Real>& law,
                                                          const Touch<Real>& t,
                                                          const SurfaceForce<Real>& f,
                                                          const Real& dt, Triple<Real>& history) {
  using std::abs, std::sqrt;
  const Real k_r = f.tangential_stiffness * t.reduced_radius * t.reduced_radius;
  const Triple<Real> roll = minus(t.relative_spin, dot(t.relative_spin, t.n), t.n);
  Triple<Real> torque = plus(history, k_r * dt * t.rolling_gain, roll);
  const Real limit = law.rolling_friction * t.reduced_radius * abs(f.normal);
  const Real squared = dot(torque, torque);
  const auto gives_way = squared > limit * limit;
  if (any(gives_way)) torque = select(gives_way, limit / sqrt(squared), Real{1.0}) * torque;
  history = torque;
  return torque;
}

// mu_r R* k_n d against the relative spin, whose normal part is left out after its length was
// taken: a sphere that also spins about n is braked less. Remembers nothing.
template <class Real>
[[gnu::always_inline]] inline Triple<Real> rolling_torque(Cdt, const LawOf<Real>& law,
                                                          const Touch<Real>& t,
                                                          const SurfaceForce<Real>& f, const Real&,
                                                          Triple<Real>& history) {
  using std::sqrt;
  const Real zero{0.0};
  history = {zero, zero, zero};
  const Real squared = dot(t.relative_spin, t.relative_spin);
  const Triple<Real> roll = minus(t.relative_spin, dot(t.relative_spin, t.n), t.n);
  const Real torque = law.rolling_friction * f.spring * t.reduced_radius;
  return select(squared > zero, torque / sqrt(squared), zero) * roll;
}

// Moves the springs on by dt [s] and returns the forces.
template <class Force, class Rolling, class Real>
[[gnu::always_inline]] inline ContactForce<Real> evaluate(const LawOf<Real>& law,
                                                          const Touch<Real>& t, const Real& dt,
                                                          Springs<Real>& springs) {
  const SurfaceForce<Real> f = surface_force(Force{}, law, t, dt, springs.tangential);
  return {f.force, f.twist, rolling_torque(Rolling{}, law, t, f, dt, springs.rolling), f.energy};
}

}  // namespace pmr::physics
