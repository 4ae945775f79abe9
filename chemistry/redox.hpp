// Equilibrium of A B O(3-delta) with oxygen gas, per mol O taken out:
//   ln(p_eq / 1 bar) = (2/R) (ds(delta) - dh(delta)/T)
//   dh by one of the laws of EnthalpyLaw
//   ds = S_th + s_v + 2 a R (ln(limit - delta) - ln(delta))
// Vieten et al., Energy Environ. Sci. 12 (2019) 1369, with a constant thermal entropy of oxygen so
// that Gibbs-Helmholtz holds; or, for comparison, with half of the entropy of O2 gas at T, as the
// data set's plotting code has it. Outside 0 < delta < limit, ds and all that rests on it are NaN:
// the integrator's signal to try a smaller step.
#pragma once
#include "pmr/state/materials.hpp"

namespace pmr::chemistry {

double reduction_enthalpy(const RedoxEquilibrium& eq, double delta);           // dh [J/mol O]
double reduction_enthalpy_slope(const RedoxEquilibrium& eq, double delta);     // d(dh)/d(delta)
double reduction_entropy(const RedoxEquilibrium& eq, double T, double delta);  // ds [J/mol O/K]

// ln(p_eq / 1 bar) [1] at T [K], and its slopes.
double ln_equilibrium_pressure(const RedoxEquilibrium& eq, double T, double delta);
double ln_pressure_delta_slope(const RedoxEquilibrium& eq, double T, double delta);  // [1] < 0
double ln_pressure_temperature_slope(const RedoxEquilibrium& eq, double T, double delta);  // [1/K]

double equilibrium_pressure(const RedoxEquilibrium& eq, double T, double delta);  // [Pa]

// delta [1] in equilibrium with oxygen of `pressure` [Pa] at T [K]. Newton's method on
// x = ln(delta/(limit - delta)), in which the equation is nearly linear, inside a bracket. Within
// (0, limit), also without any oxygen, where it is as close to the limit as a number can be.
double equilibrium_delta(const RedoxEquilibrium& eq, double T, double pressure);

// The above where dh(delta) [J/mol O] is known already.
double equilibrium_pressure(const RedoxEquilibrium& eq, double T, double delta, double dh);
double ln_pressure_temperature_slope_with(const RedoxEquilibrium& eq, double T, double dh);

// H(delta) [J/mol Fe]: exact integral of dh, up to a constant; H(d2) - H(d1) is the heat taken up.
double reduction_heat(const RedoxEquilibrium& eq, double delta);

// What the bond's strength makes of delta.
struct Bond {
  double enthalpy;  // dh [J/mol O]
  double heat;      // H [J/mol Fe]
};
Bond bond_at(const RedoxEquilibrium& eq, double delta);

// Whether delta in equilibrium with any pressure is unique at T [K]: p_eq falls as delta rises.
bool is_stable(const RedoxEquilibrium& eq, double T);

double molar_mass(const Redox& redox, double delta);  // [kg/mol Fe]
// Formula units per volume of particle [mol/m3]; constant, since volume and formula units are.
double formula_unit_concentration(const Material& material);

// True when the fit was made for this state; T [K], pressure [Pa] of oxygen.
bool is_within_fit(const RedoxEquilibrium& eq, double T, double delta, double pressure);

}  // namespace pmr::chemistry
