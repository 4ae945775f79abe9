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

// Largest change of emissivity since the last tracing [1]; infinite before the first.
double emissivity_change(const Case& c, const Nodes& nodes, const State& state);

// Exchange factors of the rig at state.time, `rays` [1] from the smallest emitter.
Exchange retrace(const Case& c, const Nodes& nodes, const State& state, double rays);

}  // namespace pmr::coupling
