// Temperature from energy: Newton's method on a rising function, kept inside a bracket.
#pragma once
#include <cmath>

#include "chemistry/heat_curve.hpp"

namespace pmr::chemistry {

// Throws NumericsError: `energy` [J] belongs to no temperature in the allowed range.
[[noreturn]] void throw_out_of_range(const char* what, double energy);

// T [K] with energy_at(T).enthalpy = energy. Stops after a step below 1e-9 T: convergence is
// quadratic, so what is left is rounding (about 1e-15 T), whatever the first guess [K].
template <class EnergyAt>
double solve_temperature(double energy, double guess, const EnergyAt& energy_at, const char* what) {
  double low = lowest_temperature, high = highest_temperature;
  double T = guess >= low && guess <= high ? guess : enthalpy_zero;
  while (high - low > 1e-9 * high) {
    const HeatPoint at = energy_at(T);
    const double step = (energy - at.enthalpy) / at.heat_capacity;
    if (std::isnan(step)) break;
    if (std::abs(step) <= 1e-9 * T) return T + step;
    (step < 0.0 ? high : low) = T;
    const double newton = T + step;
    T = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  throw_out_of_range(what, energy);
}

}  // namespace pmr::chemistry
