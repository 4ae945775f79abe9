// Vectors of three reals for the contact laws. A real is a double or several side by side
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

}  // namespace pmr::physics
