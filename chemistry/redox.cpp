#include "chemistry/redox.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "chemistry/gas.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::chemistry {
namespace {

// u = s (delta - d0 - t)
double reduced_delta(const ArctanEnthalpy& law, double delta) {
  return law.steepness * (delta - law.offset - law.shift);
}

double enthalpy(const ArctanEnthalpy& law, double delta) {
  const double angle = std::atan(reduced_delta(law, delta));
  return law.minimum + (law.maximum - law.minimum) / pi * (angle + 0.5 * pi);
}

double slope(const ArctanEnthalpy& law, double delta) {
  const double u = reduced_delta(law, delta);
  return (law.maximum - law.minimum) * law.steepness / (pi * (1.0 + u * u));
}

// Integral of atan(u) over delta is F(u)/s with F = u atan(u) - ln(1 + u^2)/2.
Bond bond(const ArctanEnthalpy& law, double delta) {
  const double span = law.maximum - law.minimum;
  const double u = reduced_delta(law, delta), angle = std::atan(u);
  const double part = (u * angle - 0.5 * std::log1p(u * u)) / (pi * law.steepness);
  return {law.minimum + span / pi * (angle + 0.5 * pi),
          law.minimum * delta + span * (0.5 * delta + part)};
}

std::pair<double, double> bounds(const ArctanEnthalpy& law, double) {
  return {law.minimum, law.maximum};
}

double enthalpy(const PolynomialEnthalpy& law, double delta) {
  return law.c[0] + delta * (law.c[1] + delta * (law.c[2] + delta * law.c[3]));
}

double slope(const PolynomialEnthalpy& law, double delta) {
  return law.c[1] + delta * (2.0 * law.c[2] + delta * 3.0 * law.c[3]);
}

Bond bond(const PolynomialEnthalpy& law, double delta) {
  const double heat =
      law.c[0] + delta * (law.c[1] / 2.0 + delta * (law.c[2] / 3.0 + delta * law.c[3] / 4.0));
  return {enthalpy(law, delta), heat * delta};
}

// Within which dh lies for 0 < delta < limit: what its coefficients' signs allow.
std::pair<double, double> bounds(const PolynomialEnthalpy& law, double limit) {
  double low = law.c[0], high = law.c[0], power = 1.0;
  for (std::size_t k = 1; k < law.c.size(); ++k) {
    power *= limit;
    low += std::min(0.0, law.c[k] * power);
    high += std::max(0.0, law.c[k] * power);
  }
  return {low, high};
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
  return std::visit([&](const auto& law) { return enthalpy(law, delta); }, eq.enthalpy);
}

double reduction_enthalpy_slope(const RedoxEquilibrium& eq, double delta) {
  return std::visit([&](const auto& law) { return slope(law, delta); }, eq.enthalpy);
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
  // dh lies between its bounds, so x lies between the two linear solutions.
  const auto [least, largest] =
      std::visit([&](const auto& law) { return bounds(law, eq.delta_limit); }, eq.enthalpy);
  double low = equation.linear(largest), high = equation.linear(least);
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
  return std::visit([&](const auto& law) { return bond(law, delta); }, eq.enthalpy);
}

bool is_stable(const RedoxEquilibrium& eq, double T) {
  constexpr int parts = 500;
  for (int k = 1; k < parts; ++k)
    if (!(ln_pressure_delta_slope(eq, T, eq.delta_limit * k / parts) < 0.0)) return false;
  return true;
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
