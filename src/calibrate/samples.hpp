// What the runs of a stage say of one response, and the surrogate made of it.
#pragma once
#include <string>
#include <vector>

#include "calibrate/lab.hpp"
#include "statistics/surrogate.hpp"

namespace pmr::calibrate {

// One run at a point of a stage: the value of one target.
struct Sample {
  std::vector<double> point;  // of the stage's parameters, in their units
  double value;               // in the target's unit, NaN: none
  bool is_completed;          // a run that ended without the figure, where it may, is censored
};

// As the surrogate has it: the logarithm of a target that is looked at so.
double transformed(const Target& target, double value);
double restored(const Target& target, double transformed);
// The measured value so, with its error of measurement, floor and discrepancy.
statistics::Measured measured(const Target& target);

struct Fit {
  statistics::Surrogate surrogate;  // of the transformed value
  statistics::Validation validation;
  std::size_t lost;      // [1] runs that failed
  std::size_t censored;  // [1] runs that ended without the figure
  double low, high;      // of the runs' values [target's unit]; infinite where any is censored
  std::string refusal;   // why the surrogate does not hold, empty where it does
};

// The surrogate of a target. A censored run enters where the surrogate of the others expects it,
// given that it is above the limit (the expectation step of Dempster, Laird & Rubin, J. R. Stat.
// Soc. B 39 (1977) 1, three times).
Fit fit(const Target& target, const std::vector<Parameter>& parameters,
        const std::vector<Sample>& samples);

// Whether a level [target's unit] lies within what the runs reached.
bool is_within_reach(double level, const Fit& fit);

}  // namespace pmr::calibrate
