// Advances the heat and reaction network over one interval: T, delta, wall profiles, gas, in one
// implicit system (CVODES), with every flux of the books integrated beside it.
#pragma once
#include <limits>

#include "coupling/heat_links.hpp"
#include "coupling/nodes.hpp"
#include "pmr/base/stop.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::coupling {

// What one advance cost, and what it met.
struct NetworkWork {
  long steps = 0, rate_calls = 0, newton = 0, krylov = 0;         // [1]
  double set_point_at = std::numeric_limits<double>::infinity();  // [s] pressure came to the pump's
                                                                  // set-point, within its band
};

// From state.time to `until` [s]: temperatures, delta, walls, gas and fluxes change; state.time
// stays (the caller owns the clock). NumericsError when CVODES cannot go on, Stopped when asked to;
// state untouched then.
NetworkWork advance_network(const Case& c, const Nodes& nodes, const Outlook& outlook,
                            std::vector<HeatLink> links, const PoreSpace& pores, double from,
                            double until, State& state, StopToken stop = {});

}  // namespace pmr::coupling
