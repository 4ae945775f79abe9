// The effective conductivity of the bed at rest, measured as on a bench: a hot plate and a cold
// one, everything else insulated.
#pragma once
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

struct BedConductivity {
  double temperature;              // [K] mean of the plates
  double pressure;                 // [Pa]
  double contact, gap, radiation;  // [W/m/K] by path; their sum is the conductivity
  double correlation;              // [W/m/K] Zehner, Bauer & Schluender for the same bed
  double total() const { return contact + gap + radiation; }
};

// k [W/m/K] at each temperature and pressure of the case's instrument: Fourier's law over the
// middle half of the bed's height, with the mean flow through its horizontal planes (every plane
// carries the same) and the slope of the particles' temperatures. The plates' own resistance stays
// outside.
std::vector<BedConductivity> measure_conductivity(const Case& c, const State& state);

}  // namespace pmr::sim
