// The runs that experiments ask for: points that want the same case share one.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "study/folder.hpp"
#include "study/plan.hpp"
#include "validate/experiment.hpp"

namespace pmr::validate {

// Places of runs in the plan: [variant][row][seed].
using RunPlaces = std::vector<std::vector<std::vector<std::size_t>>>;

struct ValidationPlan {
  study::Plan plan;
  std::vector<RunPlaces> places;  // of each experiment
};

// CaseError with what is wrong with any case, or any expression in settings.
ValidationPlan make_plan(std::span<const Experiment> experiments);

// Figures of one run at one point, in the order of the experiment's; NaN where there is none.
struct Reading {
  std::string status, reason;  // as of a study's row
  std::vector<double> figures;
};
// CaseError where an expression has no value, or no completed run knows a figure.
Reading read_run(const Experiment& experiment, std::size_t row, const study::Plan& plan,
                 std::size_t run, const study::Folder& folder);

}  // namespace pmr::validate
