#include "verify/check.hpp"

namespace pmr::verify {

std::vector<Check> all_checks() {
  std::vector<Check> all;
  for (const auto& area :
       {mechanics_checks(), conduction_checks(), radiation_checks(), bulk_checks(),
        chemistry_checks(), coupling_checks(), bed_gas_checks(), granule_checks()})
    all.insert(all.end(), area.begin(), area.end());
  return all;
}

}  // namespace pmr::verify
