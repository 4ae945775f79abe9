// What the deviations of the parameters of other stages add to those of a stage's levels.
#pragma once
#include "calibrate/stage_runs.hpp"

namespace pmr::calibrate {

// Runs each test at `at` with the others' parameters moved by a deviation to either side along the
// (at most three) leading components of their correlation (less where a box ends), and adds half
// the differences, less the seeds' noise, to the levels in squares. `which` of the others they are,
// in the names of the runs.
void add_others(const Lab& lab, const Stage& stage, const StageRuns& wanted, const Found& others,
                const std::vector<double>& at, const std::string& which, Runs& runs,
                StageResult& result);

}  // namespace pmr::calibrate
