// Rate of oxygen release per volume of particle, the particle taken as uniform in temperature and
// delta; positive when oxygen leaves.
// PowerRate (K1): r = f A exp(-Ea/(R T)) (p_eq^m - pO2^m); A, Ea: Harrison et al., Energy Fuels 37
// (2023) 9487. With pores, m = 1, times the effectiveness of a sphere whose p_eq is the same all
// through and whose gas comes and goes by Knudsen diffusion.
// RelaxationRate (K2): r = c/2 (delta_eq(T, pO2) - delta)/tau(T), c the formula units per volume.
// VacancyRate (K3): r = c/2 k(T) delta ((p_eq/p0)^n - (pO2/p0)^n); the oxidation is that of Bulfin
// et al., J. Phys. Chem. C 117 (2013) 24129, the reduction follows by detailed balance from the
// material's own equilibrium (theirs, A_red exp(-E_red/(R T)) (limit - delta), for that of ceria).
// A new law is a struct in RateLaw, an overload in kinetics.cpp and a line in the case reader.
#pragma once
#include <limits>

#include "pmr/state/materials.hpp"

namespace pmr::chemistry {

// Where a rate is asked for.
struct RateState {
  double temperature;          // [K]
  double delta;                // [1]
  double oxygen_pressure;      // [Pa] of the gas around
  double concentration = 0.0;  // [mol/m3] formula units per volume of particle; for K2
  double radius = 0.0;         // [m] of the particle; for pores, 0: they count for nothing
  // [J/mol O] dh(delta) where it is known already
  double bond = std::numeric_limits<double>::quiet_NaN();
};

// Rate and slopes, for the preconditioner.
struct RateSlopes {
  double rate;                // [mol O2/s/m3]
  double by_delta;            // [mol O2/s/m3]
  double by_temperature;      // [mol O2/s/m3/K]
  double by_oxygen_pressure;  // [mol O2/s/m3/Pa]
};

double rate_constant(double factor, const Arrhenius& k, double T);  // f k [mol O2/s/m3/Pa^m]

// [mol O2/s/m3]; NaN where delta is outside its domain (redox.hpp). Slopes that are infinite at no
// pressure are cut: below 1e-9 Pa p^m is in proportion to p, and with K2 pressures below 1e-3 Pa
// count as that.
double oxygen_rate(const Redox& redox, const RateState& at);
RateSlopes oxygen_rate_slopes(const Redox& redox, const RateState& at);

// tau [s] of K2 while delta rises (`is_reducing`) or falls, at T [K].
double relaxation_time(const RelaxationRate& law, bool is_reducing, double T);

// Rate of a porous sphere over that without resistance, first order: 3 (phi coth phi - 1)/phi^2,
// phi = R sqrt(k R T/D) [1] (Thiele 1939).
double effectiveness(double thiele);

// d(delta)/dt [1/s] = 2 r / c of a particle without pores.
double delta_rate(const Material& material, const RateState& at);

}  // namespace pmr::chemistry
