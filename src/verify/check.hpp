// One line of the verification table: what was computed against what must be true.
#pragma once
#include <cmath>
#include <string>
#include <vector>

namespace pmr::verify {

struct Check {
  std::string id;      // "chemistry.d_eq.air.700C", unique, dotted: area first
  std::string what;    // one sentence
  double measured;     // [unit]
  double expected;     // [unit]
  double tolerance;    // [unit], absolute: |measured - expected| <= tolerance passes
  std::string unit;    // "1" when dimensionless
  std::string source;  // closed form, publication or independent code, and why this tolerance
  bool passes() const { return std::abs(measured - expected) <= tolerance; }
};

// Each area's checks, computed now (some take seconds).
std::vector<Check> mechanics_checks();
std::vector<Check> conduction_checks();
std::vector<Check> radiation_checks();
std::vector<Check> bulk_checks();
std::vector<Check> chemistry_checks();
std::vector<Check> coupling_checks();
std::vector<Check> bed_gas_checks();
std::vector<Check> granule_checks();

// All of them, in this order.
std::vector<Check> all_checks();

}  // namespace pmr::verify
