// The runs of one stage: which there are, and what each says of its levels.
#pragma once
#include <string>
#include <vector>

#include "calibrate/stage.hpp"

namespace pmr::calibrate {

// A point of a stage's design, and the seeds it is run with: no two points of a stage share one,
// for what a seed does (a glued grain in the way) is much the same at all points and would not
// average.
struct DesignPoint {
  std::vector<double> at;
  std::size_t first_seed, seeds;
};

// Targets of a stage: those used, then those that decide.
std::vector<TargetIndex> targets_of(const Stage& stage);

// All that the runs of a stage are made from.
class StageRuns {
 public:
  StageRuns(const Lab& lab, std::size_t stage, study::Values values, bool is_full);

  std::vector<DesignPoint> first_points() const;
  // Runs of these points; those that are paired in full with small ones are the first of the stage.
  std::vector<Wanted> wanted(const std::vector<DesignPoint>& points, bool are_first) const;
  // A run of a test with some parameters changed.
  Wanted changed(std::size_t test, const study::Values& changes, const std::string& label,
                 bool is_small, std::size_t seed) const;
  bool is_small(std::size_t test) const { return !is_full_ && !lab_.tests[test].small.empty(); }

 private:
  const Lab& lab_;
  const Stage& stage_;
  study::Values values_;
  bool is_full_;
  std::vector<std::size_t> tests_;
};

// A number of at most four digits, so that a point reads as it is run.
double rounded(double value);

}  // namespace pmr::calibrate
