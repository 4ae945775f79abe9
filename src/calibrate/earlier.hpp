// What the deviations of the parameters of earlier stages add to those of a stage's levels.
#pragma once
#include "calibrate/stage_runs.hpp"

namespace pmr::calibrate {

// Runs each test at `at` with the earlier parameters moved by a deviation to either side along the
// (at most three) leading components of their correlation, and adds half the differences, less the
// seeds' noise, to the levels in squares.
void add_earlier(const Lab& lab, const Stage& stage, const StageRuns& wanted, const Found& earlier,
                 const std::vector<double>& at, Runs& runs, StageResult& result);

}  // namespace pmr::calibrate
