// Heat content of solids. Inert materials count per kg; redox materials per mol of formula units
// (Fe in SrFeO3, Ce in CeO2), by
//   h(T, delta) = h_2.5(T) + (0.5 - delta)/2 h_O2(T) + H(delta)                        [J/mol Fe]
// from which everything else follows: with oxygen leaving as gas of h_O2(T), the heat of reaction
// is dh(delta) at every T, and the books can close. Zero: 298.15 K for h_2.5, h_O2, inert solids
// (Shomate: as the published F and H have it, which is within some 10 J/mol).
// Laws: OxideHeat for redox materials, the others for inert ones, no other pairing. Shomate and
// oxide polynomials are continued beyond their range as heat_curve.hpp says.
#pragma once
#include "chemistry/heat_curve.hpp"
#include "pmr/state/materials.hpp"

namespace pmr::chemistry {

// Inert material: specific heat capacity [J/kg/K] and enthalpy [J/kg] at T [K].
double specific_heat(const Material& material, double T);
double specific_enthalpy(const Material& material, double T);

// Redox material: [J/mol Fe/K] at constant delta, and [J/mol Fe], at T [K] and delta [1].
double molar_heat_capacity(const Material& material, double T, double delta);
double molar_enthalpy(const Material& material, double T, double delta);

// True when material and heat law fit together (the case reader asks; solids.cpp ensures).
bool heat_law_fits(const Material& material);

// One particle's solid. `amount` is its mass [kg] if inert, its formula units [mol] if redox.
struct Solid {
  const Material* material;
  double amount;  // [kg] or [mol Fe]
};

double enthalpy(const Solid& solid, double T, double delta);              // [J]
double heat_capacity(const Solid& solid, double T, double delta);         // [J/K] at constant delta
double enthalpy_delta_slope(const Solid& solid, double T, double delta);  // [J] dE/d(delta) at T
double enthalpy_bond_slope(const Solid& solid, double T,
                           double dh);  // the same, dh [J/mol O] known
// T [K] of a solid that holds `energy` [J]; `guess` [K] saves iterations and does not change the
// result beyond rounding. NumericsError outside [150, 3000] K.
double temperature(const Solid& solid, double energy, double delta, double guess);
// The same of a redox solid whose H(delta) [J/mol Fe] is known.
double redox_temperature(const Solid& solid, double energy, double delta, double bond_heat,
                         double guess);

// The solid of a particle: mass [kg] counts if inert, formula units [mol] if redox.
inline Solid solid_of(const Material& material, double mass, double formula_units) {
  return {&material, material.redox ? formula_units : mass};
}

}  // namespace pmr::chemistry
