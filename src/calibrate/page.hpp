// The report of a calibration.
#pragma once
#include <filesystem>

#include "calibrate/calibration.hpp"

namespace pmr::calibrate {

// FOLDER/report.html.
void write_page(const Lab& lab, const Calibration& c, const Runs& runs,
                const std::filesystem::path& folder);

}  // namespace pmr::calibrate
