#include "chemistry/kinetics.hpp"

#include <algorithm>
#include <cmath>

#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::chemistry {
namespace {

// p^m and its slope m p^(m-1).
struct Power {
  double value;  // [Pa^m]
  double slope;  // [Pa^(m-1)]
};

Power power(double pressure, double m) {
  if (m == 1.0) return {pressure, 1.0};  // exact, and defined below zero too
  constexpr double floor = 1e-3;         // [Pa]
  if (pressure <= floor) return {std::pow(floor, m), 0.0};
  const double value = std::pow(pressure, m);
  return {value, m * value / pressure};
}

double power_rate(const PowerRate& law, double p_eq, const RateState& at) {
  const double drive =
      power(p_eq, law.exponent).value - power(at.oxygen_pressure, law.exponent).value;
  return rate_constant(law, at.temperature) * drive;
}

RateSlopes power_slopes(const PowerRate& law, const RedoxEquilibrium& eq, const RateState& at) {
  const double T = at.temperature;
  const double p_eq = equilibrium_pressure(eq, T, at.delta);
  const double k = rate_constant(law, T);
  const Power inside = power(p_eq, law.exponent), outside = power(at.oxygen_pressure, law.exponent);
  const double rate = k * (inside.value - outside.value);
  const double by_ln_p = k * inside.slope * p_eq;  // d r / d ln p_eq
  return {rate, by_ln_p * ln_pressure_delta_slope(eq, T, at.delta),
          rate * law.activation_energy / (gas_constant * T * T) +
              by_ln_p * ln_pressure_temperature_slope(eq, T, at.delta),
          -k * outside.slope};
}

}  // namespace

double rate_constant(const PowerRate& law, double T) {
  return law.factor * law.pre_exponential * std::exp(-law.activation_energy / (gas_constant * T));
}

double oxygen_rate(const Redox& redox, const RateState& at) {
  const double p_eq = equilibrium_pressure(redox.equilibrium, at.temperature, at.delta);
  return std::visit([&](const PowerRate& law) { return power_rate(law, p_eq, at); }, redox.rate);
}

RateSlopes oxygen_rate_slopes(const Redox& redox, const RateState& at) {
  return std::visit([&](const PowerRate& law) { return power_slopes(law, redox.equilibrium, at); },
                    redox.rate);
}

double delta_rate(const Material& material, const RateState& at) {
  return 2.0 * oxygen_rate(*material.redox, at) / iron_concentration(material);
}

}  // namespace pmr::chemistry
