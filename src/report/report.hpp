// The report of a run, the comparison of several, and single pictures: what users see of a run.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace pmr::report {

// What a reader may want of the page beyond what the runs say.
struct ReportWishes {
  std::filesystem::path reference;  // CSV of mass ratios in place of the cases' own; empty: theirs
  std::vector<double> frame_times;  // [s] of the frames of the mixing; empty: six until rest
};

// Writes one self-contained HTML page: the report of one run, or several runs side by side.
void write_report(const std::vector<std::filesystem::path>& runs, const std::filesystem::path& html,
                  const ReportWishes& wishes = {});

// The same page from data already read.
std::string report_page(const RunData& run);
std::string comparison_page(const std::vector<RunData>& runs);  // at least two

enum class Colour { temperature, delta, species };

// Draws the bed cut open at the snapshot nearest to `time` [s] (none: the last), with a colour bar.
void render_picture(const std::filesystem::path& run, std::optional<double> time, Colour colour,
                    const std::filesystem::path& png);

}  // namespace pmr::report
