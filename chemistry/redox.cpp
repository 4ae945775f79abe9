#include "chemistry/redox.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chemistry/gas.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::chemistry {
namespace {

double enthalpy_span(const RedoxEquilibrium& eq) {
  return eq.enthalpy_maximum - eq.enthalpy_minimum;
}

// u = s (delta - d0 - t)
double reduced_delta(const RedoxEquilibrium& eq, double delta) {
  return eq.steepness * (delta - eq.offset - eq.shift);
}

// ds without its configurational part.
double thermal_entropy(const RedoxEquilibrium& eq, double T) {
  return (eq.oxygen_entropy ? *eq.oxygen_entropy : 0.5 * oxygen_entropy(T)) + eq.vibration_entropy;
}

// The equilibrium in x = ln(delta/(limit - delta)), where ln p = c - 4 a x - 2 dh/(R T).
struct LogitEquation {
  const RedoxEquilibrium& eq;
  double T;     // [K]
  double ln_p;  // [1] asked for

  double delta(double x) const { return eq.delta_limit / (1.0 + std::exp(-x)); }
  double excess(double x) const { return linear(reduction_enthalpy(eq, delta(x))) - x; }
  double slope(double x) const {
    const double d = delta(x);
    const double by_x = d * (eq.delta_limit - d) / eq.delta_limit;
    return -1.0 -
           reduction_enthalpy_slope(eq, d) * by_x / (2.0 * eq.configuration * gas_constant * T);
  }
  // x of a dh [J/mol O] that did not depend on delta.
  double linear(double heat) const {
    return ((2.0 / gas_constant) * (thermal_entropy(eq, T) - heat / T) - ln_p) /
           (4.0 * eq.configuration);
  }
};

}  // namespace

double reduction_enthalpy(const RedoxEquilibrium& eq, double delta) {
  const double u = reduced_delta(eq, delta);
  return eq.enthalpy_minimum + enthalpy_span(eq) / pi * (std::atan(u) + 0.5 * pi);
}

double reduction_enthalpy_slope(const RedoxEquilibrium& eq, double delta) {
  const double u = reduced_delta(eq, delta);
  return enthalpy_span(eq) * eq.steepness / (pi * (1.0 + u * u));
}

double reduction_entropy(const RedoxEquilibrium& eq, double T, double delta) {
  if (!(delta > 0.0 && delta < eq.delta_limit)) return std::numeric_limits<double>::quiet_NaN();
  return thermal_entropy(eq, T) +
         2.0 * eq.configuration * gas_constant * std::log((eq.delta_limit - delta) / delta);
}

double ln_equilibrium_pressure(const RedoxEquilibrium& eq, double T, double delta) {
  return (2.0 / gas_constant) *
         (reduction_entropy(eq, T, delta) - reduction_enthalpy(eq, delta) / T);
}

double equilibrium_pressure(const RedoxEquilibrium& eq, double T, double delta, double dh) {
  return bar * std::exp((2.0 / gas_constant) * (reduction_entropy(eq, T, delta) - dh / T));
}

double ln_pressure_delta_slope(const RedoxEquilibrium& eq, double T, double delta) {
  const double entropy_slope =
      -2.0 * eq.configuration * gas_constant * eq.delta_limit / (delta * (eq.delta_limit - delta));
  return (2.0 / gas_constant) * (entropy_slope - reduction_enthalpy_slope(eq, delta) / T);
}

double ln_pressure_temperature_slope(const RedoxEquilibrium& eq, double T, double delta) {
  return ln_pressure_temperature_slope_with(eq, T, reduction_enthalpy(eq, delta));
}

double ln_pressure_temperature_slope_with(const RedoxEquilibrium& eq, double T, double dh) {
  const double entropy_slope = eq.oxygen_entropy ? 0.0 : 0.5 * oxygen_heat(T).heat_capacity / T;
  return (2.0 / gas_constant) * (dh / (T * T) + entropy_slope);
}

double equilibrium_pressure(const RedoxEquilibrium& eq, double T, double delta) {
  return bar * std::exp(ln_equilibrium_pressure(eq, T, delta));
}

double equilibrium_delta(const RedoxEquilibrium& eq, double T, double pressure) {
  ensure(T > 0.0 && pressure >= 0.0, "equilibrium asks for a temperature and a pressure");
  const double most = std::nextafter(eq.delta_limit, 0.0);
  if (pressure == 0.0) return most;  // what ever lower pressures tend to
  const LogitEquation equation{eq, T, std::log(pressure / bar)};
  // dh lies between its limits, so x lies between the two linear solutions.
  double low = equation.linear(eq.enthalpy_maximum), high = equation.linear(eq.enthalpy_minimum);
  double x = 0.5 * (low + high);
  while (high - low > 1e-15 * (1.0 + std::abs(x))) {
    const double excess = equation.excess(x);
    (excess > 0.0 ? low : high) = x;
    const double step = -excess / equation.slope(x);
    if (std::abs(step) <= 1e-9) {  // quadratic convergence: the next would be rounding
      x += step;
      break;
    }
    x = x + step > low && x + step < high ? x + step : 0.5 * (low + high);
  }
  return std::clamp(equation.delta(x), std::numeric_limits<double>::min(), most);
}

double reduction_heat(const RedoxEquilibrium& eq, double delta) { return bond_at(eq, delta).heat; }

Bond bond_at(const RedoxEquilibrium& eq, double delta) {
  // Integral of atan(u) over delta is F(u)/s with F = u atan(u) - ln(1 + u^2)/2.
  const double u = reduced_delta(eq, delta), angle = std::atan(u);
  const double part = (u * angle - 0.5 * std::log1p(u * u)) / (pi * eq.steepness);
  return {eq.enthalpy_minimum + enthalpy_span(eq) / pi * (angle + 0.5 * pi),
          eq.enthalpy_minimum * delta + enthalpy_span(eq) * (0.5 * delta + part)};
}

double molar_mass(const Redox& redox, double delta) {
  return redox.molar_mass - redox.atomic_oxygen * delta;
}

double formula_unit_concentration(const Material& material) {
  ensure(material.redox.has_value(), "only a redox material has an formula_units concentration");
  return material.density / molar_mass(*material.redox, material.redox->density_delta);
}

bool is_within_fit(const RedoxEquilibrium& eq, double T, double delta, double pressure) {
  return delta >= eq.fit_delta_minimum && delta <= eq.fit_delta_maximum &&
         T >= eq.fit_temperature_minimum && T <= eq.fit_temperature_maximum &&
         pressure >= eq.fit_pressure_minimum && pressure <= eq.fit_pressure_maximum;
}

}  // namespace pmr::chemistry
