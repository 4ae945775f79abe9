#include "chemistry/kinetics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::chemistry {
namespace {

constexpr double lowest_pressure = 1e-3;  // [Pa] of K2

// p^m and its slope m p^(m-1); below a pressure that no vacuum has in proportion to p, so that no
// slope is endless.
struct Power {
  double value;  // [Pa^m]
  double slope;  // [Pa^(m-1)]
};

Power power(double pressure, double m) {
  constexpr double lowest = 1e-9;  // [Pa]
  const double used = std::max(pressure, lowest);
  const double by_pressure = std::pow(used, m - 1.0);
  if (pressure < lowest) return {by_pressure * pressure, by_pressure};
  return {by_pressure * pressure, m * by_pressure};
}

// A rate constant and its slope, pores included.
struct Constant {
  double value;  // [mol O2/s/m3/Pa^m]
  double by_T;   // [mol O2/s/m3/Pa^m/K]
};

// phi eta'(phi) [1]
double effectiveness_slope(double phi) {
  if (phi < 0.1) return -2.0 * phi * phi / 15.0;
  const double sinh = std::sinh(std::min(phi, 300.0));
  return 3.0 * (2.0 - phi / std::tanh(phi) - phi * phi / (sinh * sinh)) / (phi * phi);
}

Constant constant_of(const PowerRate& law, const Redox& redox, bool reduces, const RateState& at) {
  const double T = at.temperature;
  const Arrhenius& k = reduces || !law.oxidation ? law.reduction : *law.oxidation;
  const double value = rate_constant(law.factor, k, T);
  const double by_T = value * k.activation_energy / (gas_constant * T * T);
  if (!redox.pores || at.radius == 0.0) return {value, by_T};
  const PoreDiffusion& pores = *redox.pores;
  const double diffusivity = pores.diffusivity * std::sqrt(T / pores.reference_temperature);
  const double phi = at.radius * std::sqrt(value * gas_constant * T / diffusivity);
  // d ln phi / dT, of sqrt(k T / sqrt(T))
  const double stretch = 0.5 * (k.activation_energy / (gas_constant * T * T) + 0.5 / T);
  const double part = effectiveness(phi);
  return {part * value, part * by_T + value * effectiveness_slope(phi) * stretch};
}

double bond_of(const RedoxEquilibrium& eq, const RateState& at) {
  return std::isnan(at.bond) ? reduction_enthalpy(eq, at.delta) : at.bond;
}

double rate(const PowerRate& law, const Redox& redox, const RateState& at) {
  const RedoxEquilibrium& eq = redox.equilibrium;
  const double p_eq = equilibrium_pressure(eq, at.temperature, at.delta, bond_of(eq, at));
  const double drive =
      power(p_eq, law.exponent).value - power(at.oxygen_pressure, law.exponent).value;
  return constant_of(law, redox, !(drive < 0.0), at).value * drive;
}

RateSlopes slopes(const PowerRate& law, const Redox& redox, const RateState& at) {
  const RedoxEquilibrium& eq = redox.equilibrium;
  const double T = at.temperature;
  const double bond = bond_of(eq, at);
  const double p_eq = equilibrium_pressure(eq, T, at.delta, bond);
  const Power inside = power(p_eq, law.exponent), outside = power(at.oxygen_pressure, law.exponent);
  const double drive = inside.value - outside.value;
  const Constant k = constant_of(law, redox, !(drive < 0.0), at);
  const double by_ln_p = k.value * inside.slope * p_eq;  // d r / d ln p_eq
  return {k.value * drive, by_ln_p * ln_pressure_delta_slope(eq, T, at.delta),
          k.by_T * drive + by_ln_p * ln_pressure_temperature_slope_with(eq, T, bond),
          -k.value * outside.slope};
}

double rate(const RelaxationRate& law, const Redox& redox, const RateState& at) {
  const RedoxEquilibrium& eq = redox.equilibrium;
  if (!(at.delta > 0.0 && at.delta < eq.delta_limit))
    return std::numeric_limits<double>::quiet_NaN();
  const double end =
      equilibrium_delta(eq, at.temperature, std::max(at.oxygen_pressure, lowest_pressure));
  return 0.5 * at.concentration * (end - at.delta) /
         relaxation_time(law, end >= at.delta, at.temperature);
}

// c/2 k/p0^n [mol O2/s/m3/Pa^n] of one vacancy a formula unit.
double constant_of(const VacancyRate& law, const RateState& at) {
  const Arrhenius k{law.pre_exponential, law.activation_energy};
  return 0.5 * at.concentration * rate_constant(1.0, k, at.temperature) /
         std::pow(law.reference_pressure, law.exponent);
}

double rate(const VacancyRate& law, const Redox& redox, const RateState& at) {
  const RedoxEquilibrium& eq = redox.equilibrium;
  const double p_eq = equilibrium_pressure(eq, at.temperature, at.delta, bond_of(eq, at));
  const double drive =
      power(p_eq, law.exponent).value - power(at.oxygen_pressure, law.exponent).value;
  return constant_of(law, at) * at.delta * drive;
}

RateSlopes slopes(const VacancyRate& law, const Redox& redox, const RateState& at) {
  const RedoxEquilibrium& eq = redox.equilibrium;
  const double T = at.temperature, bond = bond_of(eq, at), k = constant_of(law, at);
  const double p_eq = equilibrium_pressure(eq, T, at.delta, bond);
  const Power inside = power(p_eq, law.exponent), outside = power(at.oxygen_pressure, law.exponent);
  const double drive = inside.value - outside.value;
  const double by_ln_p = k * at.delta * inside.slope * p_eq;  // d r / d ln p_eq
  return {k * at.delta * drive, k * drive + by_ln_p * ln_pressure_delta_slope(eq, T, at.delta),
          k * at.delta * drive * law.activation_energy / (gas_constant * T * T) +
              by_ln_p * ln_pressure_temperature_slope_with(eq, T, bond),
          -k * at.delta * outside.slope};
}

RateSlopes slopes(const RelaxationRate& law, const Redox& redox, const RateState& at) {
  const RedoxEquilibrium& eq = redox.equilibrium;
  const double T = at.temperature, p = std::max(at.oxygen_pressure, lowest_pressure);
  const double end = equilibrium_delta(eq, T, p);
  const bool reduces = end >= at.delta;
  const double tau = relaxation_time(law, reduces, T);
  const double energy = reduces ? law.reduction_energy : law.oxidation_energy;
  const double by_end = 0.5 * at.concentration / tau;                // [mol O2/s/m3]
  const double by_ln_p = 1.0 / ln_pressure_delta_slope(eq, T, end);  // d(delta_eq)/d(ln p)
  const double rate = 0.5 * at.concentration * (end - at.delta) / tau;
  const double quickening =
      tau > law.shortest ? energy / (gas_constant * T * T) : 0.0;  // -d ln tau/dT
  return {rate, -by_end,
          rate * quickening - by_end * by_ln_p * ln_pressure_temperature_slope(eq, T, end),
          at.oxygen_pressure > lowest_pressure ? by_end * by_ln_p / p : 0.0};
}

}  // namespace

double rate_constant(double factor, const Arrhenius& k, double T) {
  return factor * k.pre_exponential * std::exp(-k.activation_energy / (gas_constant * T));
}

double relaxation_time(const RelaxationRate& law, bool is_reducing, double T) {
  const double energy = is_reducing ? law.reduction_energy : law.oxidation_energy;
  const double tau =
      law.time * std::exp(energy / gas_constant * (1.0 / T - 1.0 / law.reference_temperature));
  return std::max(tau, law.shortest);
}

double effectiveness(double thiele) {
  if (thiele < 0.1) return 1.0 - thiele * thiele / 15.0;
  return 3.0 * (thiele / std::tanh(thiele) - 1.0) / (thiele * thiele);
}

double oxygen_rate(const Redox& redox, const RateState& at) {
  return std::visit([&](const auto& law) { return rate(law, redox, at); }, redox.rate);
}

RateSlopes oxygen_rate_slopes(const Redox& redox, const RateState& at) {
  return std::visit([&](const auto& law) { return slopes(law, redox, at); }, redox.rate);
}

double delta_rate(const Material& material, const RateState& at) {
  RateState here = at;
  here.concentration = formula_unit_concentration(material);
  return 2.0 * oxygen_rate(*material.redox, here) / here.concentration;
}

}  // namespace pmr::chemistry
