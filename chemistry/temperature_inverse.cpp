#include "chemistry/temperature_inverse.hpp"

#include <cstdio>

#include "pmr/base/errors.hpp"

namespace pmr::chemistry {

void throw_out_of_range(const char* what, double energy) {
  char text[160];
  std::snprintf(text, sizeof text,
                "temperature of %s: an energy of %.17g J belongs to none in %g-%g K", what, energy,
                lowest_temperature, highest_temperature);
  throw NumericsError(text);
}

}  // namespace pmr::chemistry
