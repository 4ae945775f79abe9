// Molar heat of one substance: Cp(T) as a NIST Shomate polynomial inside the range of its fit, and
// outside as the power law Cp = Cp_end (T/T_end)^n that meets the fit with equal value and slope:
// positive, smooth and monotonic, so that an enthalpy can always be turned back into a temperature.
#pragma once
#include <cmath>

namespace pmr::chemistry {

inline constexpr double enthalpy_zero = 298.15;        // [K] here all sensible enthalpies vanish
inline constexpr double lowest_temperature = 150.0;    // [K] of every temperature inverse
inline constexpr double highest_temperature = 3000.0;  // [K]

// An enthalpy and its slope, per mol or per kg as said where it is returned.
struct HeatPoint {
  double enthalpy;       // [J/mol] or [J/kg]
  double heat_capacity;  // [J/mol/K] or [J/kg/K]
};

// Cp = a + b t + c t^2 + d t^3 + e/t^2 [J/mol/K], t = T/1000, for T in [low, high].
struct HeatCurve {
  double a, b, c, d, e;
  double constant;   // [J/mol] added to the integral of Cp, see integral()
  double low, high;  // [K]
};

// 1000 (a t + b t^2/2 + c t^3/3 + d t^4/4 - e/t) [J/mol]: integral of the polynomial over T.
constexpr double integral(const HeatCurve& curve, double T) {
  const double t = 1e-3 * T;
  return 1e3 * (t * (curve.a + t * (curve.b / 2.0 + t * (curve.c / 3.0 + t * curve.d / 4.0))) -
                curve.e / t);
}

// The curve with its constant chosen so that the enthalpy at T [K] is `value` [J/mol].
constexpr HeatCurve anchored(HeatCurve curve, double T, double value) {
  curve.constant = value - integral(curve, T);
  return curve;
}

// Enthalpy [J/mol] and heat capacity [J/mol/K] at T [K], range ends continued as said above.
inline HeatPoint evaluate(const HeatCurve& curve, double T) {
  const double end = T < curve.low ? curve.low : (T > curve.high ? curve.high : T);
  const double t = 1e-3 * end;
  const double heat = curve.a + t * (curve.b + t * (curve.c + t * curve.d)) + curve.e / (t * t);
  const double enthalpy = integral(curve, end) + curve.constant;
  if (end == T) return {enthalpy, heat};
  const double slope =
      curve.b + t * (2.0 * curve.c + 3.0 * t * curve.d) - 2.0 * curve.e / (t * t * t);
  const double n = slope * t / heat;  // [1] exponent of the power law
  const double power = std::pow(T / end, n);
  return {enthalpy + heat / (n + 1.0) * (T * power - end), heat * power};
}

}  // namespace pmr::chemistry
