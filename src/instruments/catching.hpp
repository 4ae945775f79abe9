// Openings that catch: which particles crossed them, and what has been caught.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::instruments {

// The particles of `after` whose centres crossed an opening on the straight way from `before`, in
// the order of crossing; one that crosses several is caught by the first. Places are matched by id;
// times lie between the two states'.
std::vector<CaughtParticle> crossings(const Case& c, const State& before, const State& after);

struct Caught {
  std::string name;
  double mass;                              // [kg]
  std::vector<double> by_species;           // [kg]
  std::optional<double> threshold;          // [kg]
  std::optional<double> time_to_threshold;  // [s] on the run's clock, linear between two arrivals;
                                            // the first one's own
};
std::vector<Caught> caught_so_far(const Case& c, const State& state);

// True when an opening that ends the motion has caught its threshold.
bool ends_motion(const Case& c, const State& state);

}  // namespace pmr::instruments
