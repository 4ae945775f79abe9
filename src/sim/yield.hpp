// What a run yields, in the figures that process engineers compare reactors by.
#pragma once
#include <vector>

#include "io/run_file.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

// Of one redox species; everything as in Yield.
struct SpeciesYield {
  std::size_t species;   // index into Case::species
  double oxygen_per_kg;  // [mol O2/kg]
  double peak_per_kg;    // [mol O2/kg] at a peak of its own
  double ideal_per_kg;   // [mol O2/kg] its part in the ideal reactor; NaN where that has no end
  double part_of_ideal;  // [1] its peak over that; NaN where it would only take oxygen up
  double time_to_90;     // [s]
};

struct Yield {
  double oxygen_per_kg;      // [mol O2/kg] net, of redox material as charged
  double peak_per_kg;        // [mol O2/kg] the most that was off at any time
  double ideal_per_kg;       // [mol O2/kg] of the charge in one adiabatic piece, see ideal_end();
                             // NaN where it would only take oxygen up
  double ideal_temperature;  // [K] of that piece
  double part_of_ideal;      // [1] peak over ideal
  double
      reaction_over_heat;  // [1] heat taken up by the reaction over heat that inert material gave
  double time_to_90;       // [s] to nine tenths of the peak
  double mean_pressure;    // [Pa] over time, from the pump's start to the end; NaN without a pump
  double pump_work;        // [J] isothermal compression over the pump's efficiency
  double charge_heat;      // [J] to bring the charge from the air's temperature to its own
  double charge_heat_per_mol;  // [J/mol O2] that, over the peak
  std::vector<SpeciesYield> species;
};

// The charge brought to one temperature without loss, each redox species reduced to its own
// equilibrium with pure oxygen of the pump's set-point, or of the air's oxygen without a pump;
// oxygen leaves at that temperature. Pressures below 1e-7 Pa count as that: with none at all there
// would be no equilibrium.
struct IdealEnd {
  double temperature;              // [K]
  double oxygen;                   // [mol O2] given off
  std::vector<double> by_species;  // [mol O2] by species
};
IdealEnd ideal_end(const Case& c, const State& state);

Yield measure_yield(const Case& c, const State& state, const io::Series& series);

}  // namespace pmr::sim
