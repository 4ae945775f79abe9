// From the state to the ray tracer and back: spheres, walls where they stand now, emissivities.
#pragma once
#include <vector>

#include "coupling/nodes.hpp"
#include "pmr/base/stop.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::coupling {

// Emissivity of every radiating node at its temperature [1]; 0 for adiabatic walls, 1 for the
// surroundings.
std::vector<double> emissivities(const Case& c, const Nodes& nodes, const State& state);

// Mean change of the emissivity [1], each node weighed by what it emits, eps A sigma T^4: how far
// the factors are off. Infinite if there were none then.
double mean_change(const Case& c, const Nodes& nodes, const State& state,
                   const std::vector<double>& now, const std::vector<double>& then);

// Mean way from where the particles were when the factors were traced, in their own diameters [1];
// infinite if there were none then.
double mean_displacement(const State& state);

// Brings the exchange factors to the emissivities of the moment without a new tracing.
void rescale(const Case& c, const Nodes& nodes, State& state);

// Exchange factors of the rig at state.time, `rays` [1] from the smallest emitter. Throws Stopped
// when asked to.
Exchange retrace(const Case& c, const Nodes& nodes, const State& state, double rays,
                 StopToken stop = {});

}  // namespace pmr::coupling
