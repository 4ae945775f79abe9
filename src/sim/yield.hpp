// What a run yields, in the figures that process engineers compare reactors by.
#pragma once
#include "io/run_file.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

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
};

// The charge brought to one temperature without loss and reduced to equilibrium with pure oxygen of
// the pump's set-point, or of the air's oxygen without a pump; oxygen leaves at that temperature.
struct IdealEnd {
  double temperature;  // [K]
  double oxygen;       // [mol O2] given off
};
IdealEnd ideal_end(const Case& c, const State& state);

Yield measure_yield(const Case& c, const State& state, const io::Series& series);

}  // namespace pmr::sim
