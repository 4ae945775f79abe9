#include <algorithm>
#include <cmath>
#include <deque>

#include "report/compare.hpp"
#include "report/figures.hpp"
#include "report/mixing_frames.hpp"
#include "report/picture_html.hpp"
#include "report/picture_section.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

constexpr std::size_t pixels = 440;  // [1] wide

struct Scene {
  const RunData* run;
  BedPictures bed;
  io::Snapshot settled, last;
};

// All pictures get the size of the largest, round the middle of each.
void same_size(std::deque<Scene>& scenes) {
  double width = 0.0, height = 0.0;
  for (const Scene& s : scenes) {
    width = std::max(width, s.bed.view.width);
    height = std::max(height, s.bed.view.height);
  }
  for (Scene& s : scenes) {
    s.bed.view.width = width;
    s.bed.view.height = height;
  }
}

std::string shot(const Scene& scene, const io::Snapshot& snapshot, const Paint& paint) {
  return shot_html({snapshot, scene.run->setup, scene.bed.view, pixels, escape(scene.run->name)},
                   paint);
}

std::string by_species(const std::deque<Scene>& scenes) {
  std::vector<std::string> shots;
  for (const Scene& s : scenes) shots.push_back(shot(s, s.settled, paint_species(s.settled)));
  return strip(shots, species_legend(scenes.front().run->header.species),
               "The settled beds, by species", "");
}

std::string by_temperature(const std::deque<Scene>& scenes, const char* title,
                           io::Snapshot Scene::*moment) {
  std::optional<Limits> range;
  for (const Scene& s : scenes) range = joined(range, temperature_limits(s.*moment));
  if (!range || range->high - range->low < 0.01) return "";
  const Limits limits = celsius_limits(*range);
  std::vector<std::string> shots;
  for (const Scene& s : scenes)
    shots.push_back(shot(s, s.*moment, paint_temperature(s.*moment, kelvin(limits))));
  return strip(shots, colour_bar(ColourMap::inferno, limits, "temperature [°C]"), title,
               "The same colours in all pictures.");
}

// Index of the reactive species of that name; none where the run has none.
std::optional<std::size_t> reactive_called(const RunData& run, const std::string& name) {
  for (const std::size_t s : run.reactive())
    if (run.species[s].name == name) return s;
  return std::nullopt;
}

std::string by_delta(const std::deque<Scene>& scenes, const std::string& name, bool is_only) {
  std::optional<Limits> all;
  for (const Scene& s : scenes)
    if (const auto index = reactive_called(*s.run, name))
      all = joined(all, delta_limits(s.last, *index));
  if (!all) return "";
  const Limits limits = round_limits(all->low, all->high);
  std::vector<std::string> shots;
  for (const Scene& s : scenes)
    if (const auto index = reactive_called(*s.run, name))
      shots.push_back(shot(s, s.last, paint_delta(s.last, limits, *index)));
  return strip(shots, colour_bar(ColourMap::viridis, limits, "oxygen non-stoichiometry δ [1]"),
               "The beds at the end, by δ" + (is_only ? "" : " of " + chemical(name)),
               "The same colours in all pictures.");
}

// A strip for each reactive species of any run.
std::string by_delta(const std::deque<Scene>& scenes) {
  std::vector<std::string> names;
  for (const Scene& scene : scenes)
    for (const std::size_t s : scene.run->reactive())
      if (std::find(names.begin(), names.end(), scene.run->species[s].name) == names.end())
        names.push_back(scene.run->species[s].name);
  std::string html;
  for (const std::string& name : names) html += by_delta(scenes, name, names.size() == 1);
  return html.empty() ? absent("No pictures by δ: no reaction in these cases.") : html;
}

}  // namespace

Section compared_pictures(const std::vector<RunData>& runs) {
  std::deque<Scene> scenes;
  for (const RunData& run : runs) {
    if (run.snapshot_times.empty()) continue;
    const BedPictures bed = bed_pictures(run);
    scenes.push_back(
        {&run, bed, run.snapshot(bed.settled), run.snapshot(run.snapshot_times.size() - 1)});
  }
  if (scenes.empty())
    return {"pictures", "Pictures", absent("No pictures: these runs hold no snapshots.")};
  same_size(scenes);
  std::vector<const RunData*> moving;
  for (const Scene& s : scenes) moving.push_back(s.run);
  const std::string html =
      mixing_strips(moving) + by_species(scenes) +
      by_temperature(scenes, "The beds come to rest, by temperature", &Scene::settled) +
      by_temperature(scenes, "The beds at the end, by temperature", &Scene::last) +
      by_delta(scenes);
  return {"pictures", "Pictures", html};
}

}  // namespace pmr::report
