// Who gave heat to whom, and by which path.
#pragma once
#include <string>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

// Heat that the givers among the particles gave to the receivers, by path: inert species to redox
// species; where a case has but one of these kinds, of each pair the species that began hotter to
// the other (the one named first, where they began alike).
struct HeatPaths {
  double contact = 0.0, gap = 0.0, radiation = 0.0;  // [J]
  double to_walls = 0.0;                             // [J] all species to walls, all paths
};
HeatPaths heat_paths(const Case& c, const State& state);

// All pairs of groups that heat is booked between.
struct HeatPair {
  std::string from, to;            // names of species, or "walls", "surroundings", "gas"
  double contact, gap, radiation;  // [J] films of gas count as gaps
};
std::vector<HeatPair> heat_pairs(const Case& c, const State& state);

}  // namespace pmr::sim
