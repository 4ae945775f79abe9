// Section 3, of one run or of several: how well the two species are mixed, and where.
#pragma once
#include <vector>

#include "report/page.hpp"

namespace pmr::report {

Section mixture_section(const std::vector<const RunData*>& runs, Charts& charts);

}  // namespace pmr::report
