// The pictures of a comparison: all runs side by side, on the same scales.
#pragma once
#include <vector>

#include "report/page.hpp"

namespace pmr::report {

Section compared_pictures(const std::vector<RunData>& runs);

}  // namespace pmr::report
