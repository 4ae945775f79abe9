// How long a case will take on this machine, phase by phase and stage by stage.
#pragma once
#include <array>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"
#include "sim/unit_costs.hpp"

namespace pmr::sim {

struct StageTimes {
  double mechanics = 0.0, tracing = 0.0, links = 0.0, network = 0.0, output = 0.0;  // [s]
  double total() const { return mechanics + tracing + links + network + output; }
};

struct Forecast {
  double steps = 0.0, bytes = 0.0;  // [1] of the mechanics; [B] of output
  StageTimes fill, mix, react;  // of wall time, on as many threads as the costs were measured with
  double moving() const { return fill.total() + mix.total(); }  // [s]
  double mixing_alone() const {                                 // [s] without heat, for many runs
    return fill.total() + mix.mechanics + mix.output;
  }
  double total() const { return moving() + react.total(); }  // [s]
};

// The whole run. How good it was on which cases: docs/benchmarks.md.
Forecast forecast(const Case& c, const UnitCosts& costs);
// What is left of a run from `state` on; a phase that lasts longer than was foreseen is taken to
// need a tenth more.
Forecast forecast_rest(const Case& c, const UnitCosts& costs, const State& state);

}  // namespace pmr::sim
