// Materials as data: every figure with its source and a mark of confidence.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pmr/base/table.hpp"

namespace pmr {

// Where a figure comes from: P published and read, L literature not re-read, D derived here from
// others, A assumed.
struct Provenance {
  std::string key;     // "conductivity"
  std::string value;   // as written in the file, with its unit
  char mark;           // 'P', 'L', 'D' or 'A'
  std::string source;  // citation
  std::string range;   // uncertainty, may be empty
};

// --- Heat capacity laws. c in J/kg/K or J/mol/K as said; chemistry/solids.hpp evaluates them.
struct ConstantHeat {
  double heat_capacity;  // [J/kg/K]
};
// NIST Shomate equation, t = T/1000: Cp = A + B t + C t2 + D t3 + E/t2 [J/mol/K],
// h = A t + B t2/2 + C t3/3 + D t4/4 - E/t + F - H [kJ/mol], H chosen so that h(298.15 K) = 0.
struct Shomate {
  double a, b, c, d, e, f, h;
  double molar_mass;                                // [kg/mol]
  double minimum_temperature, maximum_temperature;  // [K] range of the fit
};
// Solid part of a ferrite: Cp(ABO2.5) = a + b t + c t2 + d/t2 [J/mol Fe/K]; the oxygen above 2.5
// carries the heat capacity of O2 gas (chemistry/redox.hpp).
struct FerriteHeat {
  double a, b, c, d;
};
using HeatLaw = std::variant<ConstantHeat, Shomate, FerriteHeat>;

// --- Conductivity laws, k in W/m/K.
// factor (c0 + c1 exp(-c2 T)/(T + c3)), T in degC: Munro (1997) for dense alumina.
struct AluminaConductivity {
  double factor;          // [1]
  double c0, c1, c2, c3;  // [W/m/K], [W/m], [1/degC], [degC]
};
// Table over T [K] at 1 atm; in rarefied gas multiplied by 1 - gas_share (1 - 1/(1 + p_half/p)).
struct TabulatedConductivity {
  Table table;                 // [K] -> [W/m/K]
  double gas_share = 0.0;      // [1] part of k carried by gas in the pores
  double half_pressure = 1.0;  // [Pa] where that part has halved
};
using Conductivity = std::variant<AluminaConductivity, TabulatedConductivity>;

// --- Redox chemistry of A B O(3-delta), see chemistry/redox.hpp.
struct RedoxEquilibrium {
  double enthalpy_minimum, enthalpy_maximum;                // dHmin, dHmax [J/mol O]
  double shift, steepness, offset;                          // t, s, d0 [1]
  double vibration_entropy, oxygen_entropy;                 // s_v, S_th [J/mol O/K]
  double configuration;                                     // a [1]
  double delta_limit = 0.5;                                 // delta stays in (0, limit)
  double fit_delta_minimum, fit_delta_maximum;              // [1] range of the fit
  double fit_temperature_minimum, fit_temperature_maximum;  // [K]
  double fit_pressure_minimum, fit_pressure_maximum;        // [Pa]
};
// K1: r = factor k (p_eq^m - pO2^m) [mol O2/s/m3], k = A exp(-Ea/(R T)).
struct PowerRate {
  double factor;             // [1]
  double pre_exponential;    // [mol O2/s/m3/Pa^m]
  double activation_energy;  // [J/mol]
  double exponent;           // m [1]
};
using RateLaw = std::variant<PowerRate>;
struct Redox {
  RedoxEquilibrium equilibrium;
  RateLaw rate;
  double molar_mass;     // [kg/mol Fe] at delta = 0
  double atomic_oxygen;  // [kg/mol O]
  double density_delta;  // [1] delta at which the material's density is stated
};

// eps(T, delta) = table(T) + per_delta * delta, kept within (0, 1].
struct Emissivity {
  Table table;             // [K] -> [1] at delta = 0
  double per_delta = 0.0;  // [1]

  double operator()(double T, double delta) const {
    return std::clamp(table(T) + per_delta * delta, 1e-3, 1.0);
  }
};

struct Material {
  std::string name;
  double density;                   // [kg/m3] of a particle, at Redox::density_delta
  double young_soft, poisson_soft;  // [Pa], [1] of the contact model
  double young_real, poisson_real;  // [Pa], [1] of the real solid, for contact conduction
  HeatLaw heat;
  Conductivity conductivity;
  Emissivity emissivity;
  double accommodation;  // [1] thermal accommodation of gas on its surface
  std::optional<Redox> redox;
  std::vector<Provenance> provenance;
};

// Contact parameters of a pair of materials.
struct PairContact {
  double friction;          // mu [1]
  double rolling_friction;  // mu_r [1]
  double restitution;       // e [1]
};

struct Materials {
  std::vector<Material> list;
  std::vector<PairContact> pairs;  // [n * n], symmetric
  const PairContact& pair(std::size_t i, std::size_t j) const { return pairs[i * list.size() + j]; }
};

}  // namespace pmr
