#include "chemistry/gas.hpp"

#include <cmath>

#include "chemistry/temperature_inverse.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::chemistry {
namespace {

// Two Shomate fits that share one temperature; the upper is shifted (1 J/mol) to meet the lower.
struct TwoRanges {
  HeatCurve lower, upper;
};

constexpr TwoRanges joined(const HeatCurve& lower, const HeatCurve& upper) {
  const HeatCurve zeroed = anchored(lower, enthalpy_zero, 0.0);
  return {zeroed, anchored(upper, zeroed.high, integral(zeroed, zeroed.high) + zeroed.constant)};
}

HeatPoint evaluate(const TwoRanges& gas, double T) {
  return evaluate(T < gas.lower.high ? gas.lower : gas.upper, T);
}

// NIST Chemistry WebBook, SRD 69 (Chase, NIST-JANAF 1998), mark P. The published constant F is
// replaced by the zero at 298.15 K, from which it differs by rounding.
constexpr TwoRanges oxygen =
    joined({31.32234, -20.23531, 57.86644, -36.50624, -0.007374, 0.0, 100.0, 700.0},
           {30.03235, 8.772972, -3.988133, 0.788313, -0.741599, 0.0, 700.0, 2000.0});
constexpr TwoRanges nitrogen =
    joined({28.98641, 1.853978, -9.647459, 16.63537, 0.000117, 0.0, 100.0, 500.0},
           {19.50583, 19.88705, -8.598535, 1.369784, 0.527601, 0.0, 500.0, 2000.0});

double mix(double x, double of_oxygen, double of_nitrogen) {
  return x * of_oxygen + (1.0 - x) * of_nitrogen;
}

}  // namespace

HeatPoint oxygen_heat(double T) { return evaluate(oxygen, T); }
HeatPoint nitrogen_heat(double T) { return evaluate(nitrogen, T); }

double oxygen_entropy(double T) {
  const bool low = T < oxygen.lower.high;
  const HeatCurve& curve = low ? oxygen.lower : oxygen.upper;
  const double constant = low ? 246.7945 : 236.1663;  // Shomate's G [J/mol/K]
  const double t = 1e-3 * T;
  return curve.a * std::log(t) + t * (curve.b + t * (0.5 * curve.c + t * curve.d / 3.0)) -
         0.5 * curve.e / (t * t) + constant;
}

double total(const GasAmount& gas) { return gas.oxygen + gas.nitrogen; }

double oxygen_fraction(const GasAmount& gas) {
  const double amount = total(gas);
  return amount > 0.0 ? gas.oxygen / amount : 1.0;
}

double enthalpy(const GasAmount& gas, double T) {
  return gas.oxygen * oxygen_heat(T).enthalpy + gas.nitrogen * nitrogen_heat(T).enthalpy;
}

double internal_energy(const GasAmount& gas, double T) {
  return enthalpy(gas, T) - total(gas) * gas_constant * T;
}

double heat_capacity_constant_volume(const GasAmount& gas, double T) {
  return gas.oxygen * oxygen_heat(T).heat_capacity + gas.nitrogen * nitrogen_heat(T).heat_capacity -
         total(gas) * gas_constant;
}

double gas_temperature(const GasAmount& gas, double energy, double guess) {
  const auto energy_at = [&](double T) {
    return HeatPoint{internal_energy(gas, T), heat_capacity_constant_volume(gas, T)};
  };
  return solve_temperature(energy, guess, energy_at, "gas");
}

double heat_capacity_ratio(double x, double T) {
  const double cp = mix(x, oxygen_heat(T).heat_capacity, nitrogen_heat(T).heat_capacity);
  return cp / (cp - gas_constant);
}

// Power laws of the Chapman-Enskog values (Lennard-Jones) at 300-1300 K, mark D.
double viscosity(double x, double T) {
  return mix(x, 4.792e-5 * std::pow(1e-3 * T, 0.6843), 4.150e-5 * std::pow(1e-3 * T, 0.6768));
}

// Power laws through handbook values at 300-1300 K, mark L, checked against kinetic theory.
double gas_conductivity(double x, double T) {
  return mix(x, 0.07066 * std::pow(1e-3 * T, 0.8066), 0.06545 * std::pow(1e-3 * T, 0.7640));
}

double mean_free_path(double x, double T, double pressure) {
  const double mass = mix(x, oxygen_molar_mass, nitrogen_molar_mass);
  return viscosity(x, T) / pressure * std::sqrt(pi * gas_constant * T / (2.0 * mass));
}

double binary_diffusivity(double T, double pressure) {
  return 1.81e-5 * std::pow(T / zero_celsius, 1.75) * standard_atmosphere / pressure;
}

double jump_length(double mean_free_path, double gamma, double accommodation) {
  return (2.0 - accommodation) / accommodation * 2.0 * gamma / (gamma + 1.0) * mean_free_path /
         gas_prandtl;
}

double jump_length(double x, double T, double pressure, double accommodation) {
  return jump_length(mean_free_path(x, T, pressure), heat_capacity_ratio(x, T), accommodation);
}

}  // namespace pmr::chemistry
