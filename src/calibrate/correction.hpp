// Stages held against runs at the parameters found: what they foretold was of guesses of the
// others.
#pragma once
#include "calibrate/calibration.hpp"

namespace pmr::calibrate {

// Runs the tests of all stages at the parameters found, each with its seeds for predictions: each
// stage's surrogate was made with guesses of later stages' parameters. Where a response is not what
// was foretold, by more than can be told from noise, the difference is added to its surrogate and
// the stages choose anew; at most `lab.rounds` times. Then what the errors of later stages'
// parameters add to the levels. Stopped where it was interrupted.
void correct(const Lab& lab, const Wishes& wishes, Runs& runs, Calibration& c);

// Where a stage still foretells otherwise than the tests give: warnings.
void check_guesses(const Lab& lab, Calibration& c);

// Puts together what the stages found, with no covariance between them.
void gather(const Lab& lab, Calibration& c);

}  // namespace pmr::calibrate
