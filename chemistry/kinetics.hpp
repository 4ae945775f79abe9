// Rate of oxygen release per volume of particle, the particle taken as uniform.
// PowerRate (K1): r = f A exp(-Ea/(R T)) (p_eq^m - pO2^m), positive when oxygen leaves.
// A, Ea: Harrison et al., Energy Fuels 37 (2023) 9487. A new law is a struct in RateLaw, an
// overload in kinetics.cpp and a line in the case reader.
#pragma once
#include "pmr/state/materials.hpp"

namespace pmr::chemistry {

// Where a rate is asked for.
struct RateState {
  double temperature;      // [K]
  double delta;            // [1]
  double oxygen_pressure;  // [Pa] of the gas around
};

// Rate and slopes, for the preconditioner.
struct RateSlopes {
  double rate;                // [mol O2/s/m3]
  double by_delta;            // [mol O2/s/m3]
  double by_temperature;      // [mol O2/s/m3/K]
  double by_oxygen_pressure;  // [mol O2/s/m3/Pa]
};

double rate_constant(const PowerRate& law, double T);  // f A exp(-Ea/(R T)) [mol O2/s/m3/Pa^m]

// [mol O2/s/m3]; NaN where delta is outside its domain (redox.hpp). With m != 1 pressures below
// 1e-3 Pa count as that (the power's slope is infinite at zero).
double oxygen_rate(const Redox& redox, const RateState& at);
RateSlopes oxygen_rate_slopes(const Redox& redox, const RateState& at);

// d(delta)/dt [1/s] = 2 r / c_Fe.
double delta_rate(const Material& material, const RateState& at);

}  // namespace pmr::chemistry
