// Computed against measured, and the verdict.
#pragma once
#include <string>
#include <vector>

#include "pmr/base/constants.hpp"
#include "validate/runs.hpp"

namespace pmr::validate {

struct ComparedPoint {
  std::size_t row;
  double x;                    // on the experiment's axis
  double measured, deviation;  // [unit of the quantity]
  double computed, error;      // mean over seeds and its standard error, 0 of one seed
  bool is_judged;              // within the bar's part of the axis

  double miss() const { return computed - measured; }
  double miss_in_deviations() const;  // of measurement and seeds together
};

enum class Verdict { held, missed, shown, not_run };  // shown: there is no bar

// A quantity of an experiment in one variant.
struct Comparison {
  std::size_t experiment = 0, quantity = 0, variant = 0;
  std::vector<ComparedPoint> points;
  double zero = 0.0;  // taken off the computed ones, where zero is free
  // Over the points that are judged.
  std::size_t judged = 0;
  double mean = 0.0, rms = 0.0, largest = 0.0;  // misses, largest by size
  double relative = 0.0;                        // [1] largest, of the measured value
  double rms_in_deviations = 0.0;               // [1]
  Verdict verdict = Verdict::not_run;
};

struct SlopeFound {
  std::size_t experiment = 0, slope = 0, variant = 0;
  double value = nan, error = nan;  // of the straight line through the computed points
  Verdict verdict = Verdict::not_run;
};

struct Findings {
  std::vector<Comparison> comparisons;  // by experiment, quantity, variant
  std::vector<SlopeFound> slopes;
  std::vector<std::string> failures;  // of runs, each once
};

// Readings of every point of an experiment in one variant, a point's by seed.
using Readings = std::vector<std::vector<Reading>>;

// CaseError where an expression has no value.
Comparison held_against(const Experiment& experiment, const Quantity& quantity,
                        const Readings& readings);
// Least squares; its error is from what the points scatter by.
SlopeFound slope_through(const Experiment& experiment, const Slope& slope,
                         const Readings& readings);

// From what the runs left. CaseError where an expression has no value in a completed run.
Findings compare(std::span<const Experiment> experiments, const ValidationPlan& plan,
                 const study::Folder& folder);

const char* word_of(Verdict verdict);
// Of differences: kelvins of a temperature in degC.
std::string unit_of_miss(const Quantity& quantity);
// "largest 10 K from 90 to 340"; "" without one.
std::string bar_text(const Quantity& quantity);

// validation.csv: a line for each point of each comparison.
void write_table(std::span<const Experiment> experiments, const Findings& findings,
                 const std::filesystem::path& file);

}  // namespace pmr::validate
