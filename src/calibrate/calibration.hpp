// A whole calibration: its stages in order, what follows from them, and the tests again at the
// parameters found.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/stage.hpp"

namespace pmr::calibrate {

struct DerivedFound {
  double value, deviation;  // in its unit; NaN where a parameter that it rests on was not found
};

// What the tests give at the parameters found, one value a seed [target's unit].
struct Predicted {
  TargetIndex target;
  std::vector<double> values;
  std::string run;  // the first of them that ended
};

struct Calibration {
  std::vector<StageResult> stages;  // those carried out
  Found found;
  study::Values values;               // all by name: found, guessed, derived
  std::vector<DerivedFound> derived;  // as in the lab
  std::vector<Predicted> predicted;
  std::vector<std::string> warnings;  // of stages, runs and predictions
  bool is_refused = false;            // a stage's surrogate does not hold: nothing after it
};

struct Wishes {
  bool is_full = false;             // no small samples
  std::optional<std::string> last;  // stage to end with
  std::function<void(const StageResult&)> on_stage = [](const StageResult&) {};  // when it ended
};

// CaseError where `last` names no stage; Stopped where it was interrupted.
Calibration calibrate(const Lab& lab, const Wishes& wishes, Runs& runs);

// The stages up to the last that is wished for.
std::size_t stages_wanted(const Lab& lab, const Wishes& wishes);

}  // namespace pmr::calibrate
