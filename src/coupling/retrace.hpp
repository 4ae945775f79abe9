// From the state to the ray tracer and back: spheres, walls where they stand now, emissivities.
#pragma once
#include <vector>

#include "coupling/nodes.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::coupling {

// Emissivity of every radiating node at its temperature [1]; 0 for adiabatic walls, 1 for the
// surroundings.
std::vector<double> emissivities(const Case& c, const Nodes& nodes, const State& state);

// Largest change of any emissivity [1]; infinite if there was nothing then.
double largest_change(const std::vector<double>& now, const std::vector<double>& then);

// Brings the exchange factors to the emissivities of the moment without a new tracing.
void rescale(const Case& c, const Nodes& nodes, State& state);

// Exchange factors of the rig at state.time, `rays` [1] from the smallest emitter.
Exchange retrace(const Case& c, const Nodes& nodes, const State& state, double rays);

}  // namespace pmr::coupling
