#include "report/mixing_frames.hpp"

#include <algorithm>
#include <cmath>

#include "report/page.hpp"
#include "report/picture_html.hpp"
#include "report/picture_section.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

constexpr std::size_t frame_pixels = 300;  // [1] wide
constexpr std::size_t default_frames = 6;

double rest_time(const RunData& run) {
  const double settled = run.settled_time();
  return std::isfinite(settled) ? settled : run.snapshot_times.back();
}

std::string strip_title(const RunData& run, std::size_t runs) {
  return runs == 1 ? "Frames of the mixing" : "Frames of the mixing, " + escape(run.name);
}

}  // namespace

std::vector<double> frame_times(const std::vector<const RunData*>& runs) {
  double rest = 0.0;  // [s]
  for (const RunData* run : runs) {
    if (!run->frame_times.empty()) return run->frame_times;
    if (!run->snapshot_times.empty()) rest = std::max(rest, rest_time(*run));
  }
  std::vector<double> times;
  for (std::size_t k = 0; k < default_frames; ++k)
    times.push_back(rest * static_cast<double>(k) / (default_frames - 1));
  return times;
}

std::vector<std::size_t> mixing_frames(const RunData& run, const std::vector<double>& times) {
  const auto& stored = run.snapshot_times;
  if (stored.empty() || stored.front() > rest_time(run)) return {};
  std::vector<std::size_t> frames;
  for (const double time : times) {
    const std::size_t frame = nearest(stored, time);
    if (std::find(frames.begin(), frames.end(), frame) == frames.end()) frames.push_back(frame);
  }
  return frames;
}

std::string mixing_strips(const std::vector<const RunData*>& runs) {
  const std::vector<double> times = frame_times(runs);
  View view = look_at_cut(runs.front()->setup);
  Extent extent;
  std::vector<std::vector<std::size_t>> frames;
  for (const RunData* run : runs) {
    frames.push_back(mixing_frames(*run, times));
    for (const std::size_t index : frames.back()) extent.add(view, run->snapshot(index));
  }
  frame(view, extent, 0.03);
  std::string html;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (frames[r].size() < 2) continue;
    std::vector<std::string> shots;
    for (const std::size_t index : frames[r]) {
      const io::Snapshot snapshot = runs[r]->snapshot(index);
      shots.push_back(
          shot_html({snapshot, runs[r]->setup, view, frame_pixels, ""}, paint_species(snapshot)));
    }
    html += strip(shots, species_legend(runs[r]->header.species),
                  strip_title(*runs[r], runs.size()), "");
  }
  if (html.empty()) return absent("No frames of the mixing: the bed did not move in this run.");
  return html + element("p",
                        "Cut at the plane of symmetry: what lies before it is taken away. Times "
                        "since the first valve's release; one scale in all frames.",
                        "class=\"caption\"");
}

}  // namespace pmr::report
