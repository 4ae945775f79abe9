// A thermocouple in the bed reads the particles round its tip: their mean temperature, or what a
// plane through their temperatures has at the tip (with at least eight of them), which does not
// mind where in a steep gradient they happen to lie.
#pragma once
#include <cstddef>

#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::instruments {

struct ThermocoupleReading {
  double temperature;     // [K] NaN only if there is no particle at all
  std::size_t particles;  // [1] centres within the radius; 0: the nearest particle's temperature
  double nearest;         // [m] distance of the nearest centre, infinite without particles
};
ThermocoupleReading read_thermocouple(const Thermocouple& probe, const Particles& particles);

}  // namespace pmr::instruments
