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

struct BedConductivities {
  double solid_fraction;  // [1] where they were measured
  std::vector<BedConductivity> points;
};

// k [W/m/K] at each temperature and pressure of the case's instrument: mean flux density over slope
// of the particles' temperatures, in the middle half of the bed's height and away from its side
// walls. The plates' own resistance stays outside.
BedConductivities measure_conductivity(const Case& c, const State& state);

}  // namespace pmr::sim
