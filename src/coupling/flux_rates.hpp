// Rates of every flux of the books at one evaluation: sums of their own over links, factors and
// boundaries, never differences of what is stored.
#pragma once
#include "coupling/system.hpp"

namespace pmr::coupling {

struct FluxRates {
  Fluxes sums;   // [W], [mol/s]
  Breakdown by;  // likewise
};
FluxRates flux_rates(const System& system, const Evaluation& at);

}  // namespace pmr::coupling
