// What a unit of work of each stage costs on this machine, measured in about a second on a small
// lattice of the case's own particles.
#pragma once
#include "pmr/state/case.hpp"

namespace pmr::sim {

struct UnitCosts {           // of wall time, on the threads of the moment
  double particle_step = 0;  // [s] pairs and motion of a particle in a sub-step
  double ray = 0;            // [s] from its sphere to where it is absorbed
  double links = 0;          // [s] a particle's gaps and conductances, found and worked out
  double network = 0;        // [s] a particle through an interval of the network
};

UnitCosts measure_costs(const Case& c);

}  // namespace pmr::sim
