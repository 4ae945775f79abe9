// Oxygen, nitrogen and their mixtures as ideal gases: heat (NIST Shomate), transport, rarefaction.
// h(298.15 K) = 0 for both. Mixtures: heat exact; viscosity, conductivity and molar mass by mole
// fraction (linear; for air 1.2 % below the measured conductivity). `x` is the mole fraction of
// oxygen [1], the rest is nitrogen.
#pragma once
#include "chemistry/heat_curve.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::chemistry {

inline constexpr double oxygen_molar_mass = 31.998e-3;     // [kg/mol]
inline constexpr double nitrogen_molar_mass = 28.0134e-3;  // [kg/mol]
inline constexpr double gas_prandtl = 0.70;                // [1] of both gases, 300-1300 K

HeatPoint oxygen_heat(double T);    // [J/mol], [J/mol/K] at T [K]
HeatPoint nitrogen_heat(double T);  // likewise
// Enthalpy of a diatomic gas counted from 0 K [J/mol], 7/2 R T: how much gas there is, as heat.
constexpr double enthalpy_from_zero(double T) { return 3.5 * gas_constant * T; }
// S [J/mol/K] of O2 gas at 1 bar and T [K] (NIST Shomate, 100-2000 K; continued as it stands).
double oxygen_entropy(double T);

// A body of gas.
struct GasAmount {
  double oxygen;    // [mol]
  double nitrogen;  // [mol]
};

double total(const GasAmount& gas);                                    // [mol]
double oxygen_fraction(const GasAmount& gas);                          // x [1]; 1 for no gas at all
double enthalpy(const GasAmount& gas, double T);                       // [J]
double internal_energy(const GasAmount& gas, double T);                // [J] enthalpy - n R T
double heat_capacity_constant_volume(const GasAmount& gas, double T);  // [J/K]
// T [K] of gas with internal `energy` [J]; NumericsError outside [150, 3000] K.
double gas_temperature(const GasAmount& gas, double energy, double guess);

double heat_capacity_ratio(double x, double T);              // gamma [1]
double viscosity(double x, double T);                        // [Pa s]
double gas_conductivity(double x, double T);                 // [W/m/K]
double mean_free_path(double x, double T, double pressure);  // [m] (mu/p) sqrt(pi R T/(2 M))

// O2 in N2 [m2/s]: 1.81e-5 (T/273.15)^1.75 (101325 Pa/p) (Marrero & Mason 1972; exponent of
// Fuller et al. 1966).
double binary_diffusivity(double T, double pressure);

// Temperature jump length of one surface [m]:
// (2 - alpha)/alpha * 2 gamma/(gamma + 1) * lambda/Pr, alpha its thermal accommodation [1].
// A gap of width L between two surfaces carries k (T1 - T2)/(L + g1 + g2) per area.
double jump_length(double mean_free_path, double gamma, double accommodation);
double jump_length(double x, double T, double pressure, double accommodation);

}  // namespace pmr::chemistry
