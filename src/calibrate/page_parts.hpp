// The sections of a calibration's page.
#pragma once
#include "calibrate/calibration.hpp"
#include "report/page.hpp"

namespace pmr::calibrate {

// All that the sections draw from.
struct Findings {
  const Lab& lab;
  const Calibration& found;
  const Runs& runs;
  std::filesystem::path folder;
};

report::Section answer_part(const Findings& f);  // what was found, and what to beware of
report::Section stage_part(const Findings& f, const StageResult& result, report::Charts& charts);
report::Section predicted_part(const Findings& f);  // the tests at the parameters found
report::Section trust_part(const Findings& f, report::Charts& charts);  // of the surrogates
report::Section picture_part(const Findings& f);  // of the tests at the parameters found
report::Section runs_part(const Findings& f);
report::Section reproduction_part(const Findings& f);

std::string shown(double value, int digits = 4);  // "–" where there is none
std::string with_error(double value, double error, const std::string& unit);  // "0.31 ± 0.02 deg"
// "stage-NAME", an anchor.
std::string anchor(const Stage& stage);

}  // namespace pmr::calibrate
