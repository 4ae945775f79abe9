// Collisions against the code of the demonstrator study and against Chung & Ooi's benchmarks.
#pragma once
#include <vector>

#include "verify/check.hpp"

namespace pmr::verify {

void add_liggghts_checks(std::vector<Check>& checks);
void add_rolling_checks(std::vector<Check>& checks);
void add_chung_ooi_checks(std::vector<Check>& checks);

}  // namespace pmr::verify
