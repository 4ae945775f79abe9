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
// Written once for a real that is a double (walls, tests) or several contacts side by side
// (lanes.hpp); includes nothing but plain data, for it is compiled for several processors.
#pragma once
#include <cmath>

namespace pmr::physics {

template <class Real>
struct Triple {
  Real x, y, z;

  [[gnu::always_inline]] friend Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend Triple operator-(const Triple& a, const Triple& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] friend Triple operator*(const Real& s, const Triple& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
};

// c + a b and c - a b in one rounding: a tenth less work for the kernel, and said here rather than
// left to the compiler, so that all compilers agree on the bits.
[[gnu::always_inline]] inline double plus(double c, double a, double b) {
  return std::fma(a, b, c);
}
[[gnu::always_inline]] inline double minus(double c, double a, double b) {
  return std::fma(-a, b, c);
}

template <class Real>
[[gnu::always_inline]] inline Triple<Real> plus(const Triple<Real>& c, const Real& a,
                                                const Triple<Real>& b) {
  return {plus(c.x, a, b.x), plus(c.y, a, b.y), plus(c.z, a, b.z)};
}
template <class Real>
[[gnu::always_inline]] inline Triple<Real> minus(const Triple<Real>& c, const Real& a,
                                                 const Triple<Real>& b) {
  return {minus(c.x, a, b.x), minus(c.y, a, b.y), minus(c.z, a, b.z)};
}

template <class Real>
[[gnu::always_inline]] inline Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return plus(plus(a.x * b.x, a.y, b.y), a.z, b.z);
}

template <class Real>
[[gnu::always_inline]] inline Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {minus(a.y * b.z, a.z, b.y), minus(a.z * b.x, a.x, b.z), minus(a.x * b.y, a.y, b.x)};
}

[[gnu::always_inline]] inline bool any(bool condition) { return condition; }
[[gnu::always_inline]] inline double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}

// What of the law depends on the two materials only. With s = sqrt(R* d):
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
  Real elastic;          // [J] energy of the Hertz spring, 2/5 k_n d^2
};

// Moves the springs on by dt [s] and returns the forces.
template <class Real>
[[gnu::always_inline]] inline ContactForce<Real> evaluate(const LawOf<Real>& law,
                                                          const Touch<Real>& t, const Real& dt,
                                                          Springs<Real>& springs) {
  using std::abs, std::sqrt;
  const Real zero{0.0}, one{1.0};
  const Real s = sqrt(t.reduced_radius * t.overlap);  // [m] radius of the contact's area
  const Real root = sqrt(t.reduced_mass * s);         // [kg^1/2 m^1/2]

  const Real v_n = dot(t.velocity, t.n);
  const Real spring = law.normal * s * t.overlap;
  const Real f_n = minus(spring, law.normal_damping * root, v_n);

  const Real k_t = law.tangential * s;
  const Triple<Real> slip = minus(t.velocity, v_n, t.n) - cross(t.surface_spin, t.n);
  Triple<Real> d_t = plus(springs.tangential, dt, slip);
  d_t = minus(d_t, dot(d_t, t.n), t.n);
  const Real spring_squared = k_t * k_t * dot(d_t, d_t);
  const Real limit = law.friction * abs(f_n);
  const auto slides = spring_squared > limit * limit;
  if (any(slides)) d_t = select(slides, limit / sqrt(spring_squared), one) * d_t;
  const Real c_t = select(slides, zero, law.tangential_damping * root);
  const Triple<Real> f_t = minus((zero - k_t) * d_t, c_t, slip);
  springs.tangential = d_t;

  const Real k_r = k_t * t.reduced_radius * t.reduced_radius;
  const Triple<Real> roll = minus(t.relative_spin, dot(t.relative_spin, t.n), t.n);
  Triple<Real> torque = plus(springs.rolling, k_r * dt * t.rolling_gain, roll);
  const Real torque_limit = law.rolling_friction * t.reduced_radius * abs(f_n);
  const Real torque_squared = dot(torque, torque);
  const auto gives_way = torque_squared > torque_limit * torque_limit;
  if (any(gives_way)) torque = select(gives_way, torque_limit / sqrt(torque_squared), one) * torque;
  springs.rolling = torque;

  return {plus(f_t, f_n, t.n), cross(t.n, f_t), torque, Real{0.4} * spring * t.overlap};
}

}  // namespace pmr::physics
