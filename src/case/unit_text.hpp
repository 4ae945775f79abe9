// How a quantity is written: numbers, then a unit.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pmr::casefile {

struct NumbersAndUnit {
  std::vector<double> numbers;
  std::string unit;  // all that is left
};

// Splits "0 0 10 mm" or "2.99mm". "1/K" is a unit, not a number.
NumbersAndUnit split(std::string_view text);

// Whether each number in a unit is a whole exponent ("m2", "s-1", "m^3", "K**-1"), but for a 1 in
// front ("1/K"). UDUNITS takes any other for a factor: "Pa^0.5" would be Pa^0 times 5.
bool has_whole_exponents(std::string_view unit);

}  // namespace pmr::casefile
