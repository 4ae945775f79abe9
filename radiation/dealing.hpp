// How many rays each emitter sends: in proportion to what it emits, so that all rays carry about
// the same power, within a bound on all of them.
#pragma once
#include <span>

namespace pmr::radiation {

struct Dealing {
  double rays;   // [1] of the emitter that the others are measured by
  double least;  // [m2] its eps A
  double most;   // [1] that one emitter may send

  double wanted(double emission) const;  // [1] for eps A [m2], at least one
  double sent(double emission) const;    // [1] likewise, bounded
};

// For emitters of eps A [m2] each. All together send at most 10 million rays, or 20 times `rays`
// for each where that is more; what is too much is taken from those that would send most. (A 0.1 mm
// grain in a lined box of 0.4 m would ask for 10^10.)
Dealing deal(std::span<const double> emission, double least, double rays);

}  // namespace pmr::radiation
