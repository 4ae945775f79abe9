// What a calibration leaves besides its report.
#pragma once
#include <filesystem>
#include <string>

#include "calibrate/calibration.hpp"

namespace pmr::calibrate {

// contacts.toml: the parameters found under their keys, ready for `extends` in a case, and, in
// [calibration], their deviations and correlation, and what they were found with.
// `version` is that of pmr.
void write_parameters(const Lab& lab, const Calibration& c, const std::string& version,
                      const std::filesystem::path& file);

// calibration.json: all that was found, with modes, misses and predictions.
void write_json(const Lab& lab, const Calibration& c, const std::string& version,
                const std::filesystem::path& file);

}  // namespace pmr::calibrate
