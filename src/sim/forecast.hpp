// How long a case will take, to a factor of two.
#pragma once
#include "pmr/state/case.hpp"

namespace pmr::sim {

struct Forecast {
  double steps;     // [1] of the mechanics, at most
  double moving;    // [s] of one core for them, at most
  double reacting;  // [s] of one core from the bed at rest on
  double bytes;     // [B] of output
};

// From the particles the case counts and its clocks; speeds as measured (docs/benchmarks.md).
Forecast forecast(const Case& c);

}  // namespace pmr::sim
