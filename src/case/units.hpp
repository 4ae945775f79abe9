// Quantities with units, by UDUNITS-2.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace pmr::casefile {

enum class Dimension {
  none,  // a bare number
  length,
  mass,
  time,
  speed,
  acceleration,
  angle,
  spin,           // of a particle: with an angle in its unit, since "1/s" is both in the field
  rotation_rate,  // of a machine: turns where its unit has no angle, "20 1/min" is 20 rpm
  frequency,      // of cycles: a turn is one, "3000 rpm" is 50 Hz
  event_rate,     // of things that are counted
  temperature,
  temperature_difference,
  pressure,
  density,
  volume,
  flow,
  mass_rate,
  heat_capacity,
  molar_heat_capacity,
  molar_energy,
  molar_mass,
  conductivity,
  line_conductivity,
  per_temperature,
  film_coefficient,
  leak,
  rate_constant,
  volumetric_rate,
  diffusivity,
};

// "a length such as \"2.99 mm\""
std::string wanted(Dimension dimension);

// One or several numbers with one unit, converted to SI; or what is wrong.
struct Quantities {
  std::vector<double> values;  // [SI]
  std::string problem;         // empty when all is well
};

// SI value = offset + factor times the number; or what is wrong.
struct Scale {
  double offset, factor;
  std::string problem;  // empty when all is well
};

class Units {
 public:
  Units();
  ~Units();
  Units(const Units&) = delete;
  Units& operator=(const Units&) = delete;

  // Reads "2.99 mm" or "0 0 10 mm".
  Quantities parse(const std::string& text, Dimension dimension) const;
  // Reads the "mm" of a column "x [mm]".
  Scale scale(const std::string& unit, Dimension dimension) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace pmr::casefile
