// Section 2: the mixing as a strip of frames, the settled bed cut open.
#include "report/picture_section.hpp"

#include <algorithm>
#include <cmath>

#include "report/figures.hpp"
#include "report/mixing_frames.hpp"
#include "report/page.hpp"
#include "report/picture_html.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

constexpr std::size_t bed_pixels = 420;  // [1] wide

void make_unique(std::vector<std::size_t>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

std::string settled_strip(const RunData& run, const BedPictures& bed) {
  const io::Snapshot settled = run.snapshot(bed.settled);
  return strip({shot_html({settled, run.setup, bed.view, 560, ""}, paint_species(settled))},
               species_legend(run.header.species), "The settled bed, by species",
               "Cut open at the plane of symmetry; walls in section.");
}

// One picture for each reactive species, since their deltas may be of different size.
std::string delta_strip(const RunData& run, const BedPictures& bed) {
  const auto reactive = run.reactive();
  if (reactive.empty()) return absent("No picture by δ: no reaction in this case.");
  const io::Snapshot last = run.snapshot(run.snapshot_times.size() - 1);
  std::string html;
  for (const std::size_t s : reactive) {
    const auto range = delta_limits(last, s);
    if (!range) continue;
    const Limits limits = round_limits(range->low, range->high);
    const bool is_one = reactive.size() == 1;
    const std::string of = is_one ? "" : " of " + chemical(run.species[s].name);
    html += strip({shot_html({last, run.setup, bed.view, 560, ""}, paint_delta(last, limits, s))},
                  colour_bar(ColourMap::viridis, limits, "oxygen non-stoichiometry δ [1]"),
                  "The bed at the end, by δ" + of,
                  is_one ? "Inert beads are grey." : "All others are grey.");
  }
  return html.empty() ? absent("No picture by δ: no reactive particles.") : html;
}

// One snapshot at a time: a bed of full size takes 50 MB.
std::string temperature_strip(const RunData& run, const BedPictures& bed) {
  std::optional<Limits> range;
  for (const std::size_t index : bed.temperature_times)
    range = joined(range, temperature_limits(run.snapshot(index)));
  if (!range || range->high - range->low < 0.01)
    return absent("No pictures by temperature: every particle has the same.");
  const Limits limits = celsius_limits(*range);
  std::vector<std::string> shots;
  for (const std::size_t index : bed.temperature_times) {
    const io::Snapshot snapshot = run.snapshot(index);
    shots.push_back(shot_html({snapshot, run.setup, bed.view, bed_pixels, ""},
                              paint_temperature(snapshot, kelvin(limits))));
  }
  return strip(shots, colour_bar(ColourMap::inferno, limits, "temperature [°C]"),
               "The bed by temperature", "The same colours in all pictures.");
}

std::string end_temperature_strip(const RunData& run, const BedPictures& bed) {
  const io::Snapshot last = run.snapshot(run.snapshot_times.size() - 1);
  const auto range = temperature_limits(last);
  if (!range || range->high - range->low < 0.01) return "";
  const Limits limits = celsius_limits(*range);
  return strip(
      {shot_html({last, run.setup, bed.view, 560, ""}, paint_temperature(last, kelvin(limits)))},
      colour_bar(ColourMap::inferno, limits, "temperature [°C]"),
      "The bed at the end, by temperature", "On its own scale, to show the pattern.");
}

}  // namespace

Limits celsius_limits(Limits kelvin_range) {
  return round_limits(kelvin_range.low - 273.15, kelvin_range.high - 273.15);
}

Limits kelvin(Limits celsius) { return {celsius.low + 273.15, celsius.high + 273.15}; }

std::size_t nearest(const std::vector<double>& times, double t) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (std::abs(times[k] - t) < std::abs(times[best] - t)) best = k;
  return best;
}

BedPictures bed_pictures(const RunData& run) {
  BedPictures bed;
  const auto& times = run.snapshot_times;
  const double settled = run.settled_time();
  bed.settled = std::isfinite(settled) ? nearest(times, settled) : times.size() - 1;
  while (bed.settled > 0 && run.snapshot(bed.settled).particles.size() == 0) --bed.settled;
  const double first = std::max(times[bed.settled], 1e-3), last = std::max(times.back(), first);
  for (int k = 0; k < 4; ++k)
    bed.temperature_times.push_back(nearest(times, first * std::pow(last / first, k / 3.0)));
  make_unique(bed.temperature_times);
  const io::Snapshot snapshot = run.snapshot(bed.settled);
  bed.view = look_at_cut(run.setup);
  frame(bed.view, snapshot, 0.06);
  return bed;
}

Section picture_section(const RunData& run) {
  Section section{"pictures", "Pictures", ""};
  if (run.snapshot_times.empty()) {
    section.html = absent("No pictures: this run holds no snapshots.");
    return section;
  }
  const BedPictures bed = bed_pictures(run);
  section.html = mixing_strips({&run}) + temperature_strip(run, bed);
  section.html += element(
      "div", settled_strip(run, bed) + end_temperature_strip(run, bed) + delta_strip(run, bed),
      "class=\"beds\"");
  return section;
}

}  // namespace pmr::report
