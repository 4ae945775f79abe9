// Materials as data: every figure with its source and a mark of confidence.
#pragma once
#include <algorithm>
#include <array>
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

// A law is a small value in a closed set, named as cases name it.

// --- Heat capacity laws. c in J/kg/K or J/mol/K as said; chemistry/solids.hpp evaluates them.
struct ConstantHeat {
  static constexpr const char* name = "constant";
  double heat_capacity;  // [J/kg/K]
};
// NIST Shomate equation, t = T/1000: Cp = A + B t + C t2 + D t3 + E/t2 [J/mol/K],
// h = A t + B t2/2 + C t3/3 + D t4/4 - E/t + F - H [kJ/mol], H chosen so that h(298.15 K) = 0.
struct Shomate {
  static constexpr const char* name = "shomate";
  double a, b, c, d, e, f, h;
  double molar_mass;                                // [kg/mol]
  double minimum_temperature, maximum_temperature;  // [K] range of the fit
};
// A reducible oxide: its solid at delta = 0.5 has Cp = a + b t + c t2 + d/t2 [J/mol/K], t = T/1000;
// the oxygen beyond that carries the heat capacity of O2 gas (chemistry/redox.hpp). Per mol of
// formula units.
struct OxideHeat {
  static constexpr const char* name = "oxide";
  double a, b, c, d;
  double minimum_temperature, maximum_temperature;  // [K] range in which it is used as it stands
};
// Table over T, linear between rows, constant beyond; of an inert material.
struct TabulatedHeat {
  static constexpr const char* name = "table";
  IntegratedTable rows;  // [K] -> [J/kg/K]
};
using HeatLaw = std::variant<ConstantHeat, Shomate, OxideHeat, TabulatedHeat>;

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

// --- Redox chemistry of an oxide with oxygen sites that empty, A B O(3-delta) or M O(2-delta), per
// formula unit; see chemistry/redox.hpp.
// dh = dHmin + (dHmax - dHmin)/pi (atan(u) + pi/2), u = s (delta - d0 - t): two plateaus.
struct ArctanEnthalpy {
  static constexpr const char* name = "arctan";
  double minimum, maximum;          // dHmin, dHmax [J/mol O]
  double shift, steepness, offset;  // t, s, d0 [1]
};
// dh = c0 + c1 delta + c2 delta^2 + c3 delta^3.
struct PolynomialEnthalpy {
  static constexpr const char* name = "polynomial";
  std::array<double, 4> c;  // [J/mol O]
};
using EnthalpyLaw = std::variant<ArctanEnthalpy, PolynomialEnthalpy>;
struct RedoxEquilibrium {
  EnthalpyLaw enthalpy;
  double vibration_entropy;              // s_v [J/mol O/K]
  std::optional<double> oxygen_entropy;  // S_th [J/mol O/K]; none: half of that of O2 gas at T
  double configuration;                  // a [1]
  double delta_limit = 0.5;              // delta stays in (0, limit)
  double fit_delta_minimum, fit_delta_maximum;              // [1] range of the fit
  double fit_temperature_minimum, fit_temperature_maximum;  // [K]
  double fit_pressure_minimum, fit_pressure_maximum;        // [Pa]
};
struct Arrhenius {
  double pre_exponential;    // [mol O2/s/m3/Pa^m]
  double activation_energy;  // [J/mol]
};
// K1: r = factor k (p_eq^m - pO2^m) [mol O2/s/m3], k = A exp(-Ea/(R T)).
struct PowerRate {
  static constexpr const char* name = "power";
  double factor;                       // [1]
  Arrhenius reduction;                 // k where oxygen leaves
  double exponent;                     // m [1]
  std::optional<Arrhenius> oxidation;  // k where it is taken up; none: the same
};
// K2: d(delta)/dt = (delta_eq(T, pO2) - delta)/tau, tau = time exp(Ea/R (1/T - 1/reference)).
struct RelaxationRate {
  static constexpr const char* name = "relaxation";
  double time;                   // [s] tau at the reference temperature
  double reference_temperature;  // [K]
  double reduction_energy;       // Ea [J/mol] while delta rises ...
  double oxidation_energy;       // [J/mol] ... and while it falls
  double shortest;               // [s] tau is never below this
};
// K3: d(delta)/dt = k delta ((p_eq/p0)^n - (pO2/p0)^n), k = A exp(-Ea/(R T)): oxygen fills
// vacancies in proportion to their number, and leaves as fast as that where the two balance.
struct VacancyRate {
  static constexpr const char* name = "vacancies";
  double pre_exponential;     // A [1/s] at the reference pressure
  double activation_energy;   // Ea [J/mol] of the oxidation
  double exponent;            // n [1]
  double reference_pressure;  // p0 [Pa]
};
using RateLaw = std::variant<PowerRate, RelaxationRate, VacancyRate>;
// Pores that oxygen has to pass by Knudsen diffusion: D = diffusivity sqrt(T/reference).
struct PoreDiffusion {
  double diffusivity;            // [m2/s] effective, at the reference temperature
  double reference_temperature;  // [K]
};
struct Redox {
  RedoxEquilibrium equilibrium;
  RateLaw rate;
  double rate_temperature_minimum, rate_temperature_maximum;  // [K] range of the rate's fit
  std::optional<PoreDiffusion> pores;                         // none: oxygen passes freely
  double oxygen_atoms;                                        // [1] per formula unit at delta = 0
  double molar_mass;     // [kg/mol] of formula units (of Fe, in a ferrite) at delta = 0
  double atomic_oxygen;  // [kg/mol O]
  double density_delta;  // [1] delta at which the material's density is stated
};

// Below, rays per particle would grow without bound; no solid is so bright.
inline constexpr double lowest_emissivity = 1e-3;  // [1]

// eps(T, delta) = table(T) + per_delta * delta, kept within [lowest_emissivity, 1].
struct Emissivity {
  Table table;             // [K] -> [1] at delta = 0
  double per_delta = 0.0;  // [1]

  double operator()(double T, double delta) const {
    return std::clamp(table(T) + per_delta * delta, lowest_emissivity, 1.0);
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
