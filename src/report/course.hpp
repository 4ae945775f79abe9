// Charts over time, for one run or several: one run's lines are told apart by colour, several
// runs' by dashes.
#pragma once
#include <string>
#include <vector>

#include "report/page.hpp"

namespace pmr::report {

inline constexpr std::size_t most_rows = 1200;  // [1] a plot shows; more are thinned evenly

// Every so many-th of the values, and the last, so that they are at most about `most_rows`.
std::vector<double> thinned(const std::vector<double>& values);

// HTML of all course charts that the runs' series can fill, with one line for each that they can't.
std::string course_charts(const std::vector<const RunData*>& runs, Charts& charts);

}  // namespace pmr::report
