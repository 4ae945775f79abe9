// One stage: runs over its parameters until the measured levels tell as much of them as they can.
#pragma once
#include <string>
#include <vector>

#include "calibrate/runs.hpp"
#include "calibrate/samples.hpp"
#include "statistics/posterior.hpp"

namespace pmr::calibrate {

// Parameters as they were found, with the covariance of each stage's.
struct Found {
  std::vector<const Parameter*> parameters;
  std::vector<double> values;
  std::vector<std::vector<double>> covariance;  // 0 between stages
};

// What is added to a surrogate, and how well that is known [transformed].
struct Shift {
  double value = 0.0, error = 0.0;
};

// A target within a stage.
struct Level {
  TargetIndex target;
  Fit fit;
  Shift small;          // from small samples to full ones, of pairs of runs; 0 where all are full
  Shift guesses;        // from guesses of other stages' parameters to what was found for them
  double others = 0.0;  // what the deviations of other stages' parameters come to [transformed]
  statistics::Measured measured;  // with all of it, for the surrogate without the shifts

  double shift() const { return small.value + guesses.value; }
  // Adds to the shifts: the measured level moves against it, its deviation holds the error.
  void add(Shift& shift, double value, double error);
};

struct ModeFound {
  statistics::Mode mode;
  std::vector<double> at;  // the crossing in it, or its densest point
  bool is_crossing;
  double weight;  // of its mass after what decides [1]
};

struct StageResult {
  std::size_t stage;  // of the lab
  std::vector<std::vector<double>> points;
  std::vector<std::vector<Sample>> samples;  // of each level, in the order of the runs
  std::vector<Level> levels;                 // those used, then those that decide
  std::vector<ModeFound> modes;              // heaviest first; none where a surrogate is refused
  bool is_closest = false;                   // the levels do not cross: the closest point is given
  double mass_on_edge = 0.0;
  std::string ended, decided;         // why no more points were run; what chose the mode
  std::vector<std::string> warnings;  // of the runs and surrogates, refusals first
  std::vector<std::string> doubts;    // of the choice

  const ModeFound& best() const { return modes.front(); }
};

// Of the levels that are used, as `statistics` has it.
statistics::Problem problem_of(const Stage& stage, const std::vector<Level>& levels);
// The response of a level, transformed, as in full samples.
statistics::Prediction foretold(const Level& level, const std::vector<double>& point);
// Points along each variable of a stage's grid, for what is reported.
std::size_t fine_steps(const Stage& stage);

// Carries out a stage at `values` of all other parameters. Stopped where it was interrupted.
StageResult solve(const Lab& lab, std::size_t stage, const study::Values& values,
                  const Found& earlier, bool is_full, Runs& runs);

// The first runs of a stage, before anything is known of it.
std::vector<Wanted> first_runs(const Lab& lab, std::size_t stage, const study::Values& values,
                               bool is_full);

}  // namespace pmr::calibrate
