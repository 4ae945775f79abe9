// The report of a run, the comparison of several, and single pictures: what users see of a run.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace pmr::report {

// Writes one self-contained HTML page: the report of one run, or several runs side by side.
void write_report(const std::vector<std::filesystem::path>& runs,
                  const std::filesystem::path& html);

// The same page from data already read.
std::string report_page(const RunData& run);
std::string comparison_page(const std::vector<RunData>& runs);  // at least two

enum class Colour { temperature, delta, species };

// Draws the bed cut open at the snapshot nearest to `time` [s] (none: the last), with a colour bar.
void render_picture(const std::filesystem::path& run, std::optional<double> time, Colour colour,
                    const std::filesystem::path& png);

}  // namespace pmr::report
