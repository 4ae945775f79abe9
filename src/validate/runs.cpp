#include "validate/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "case/nearest.hpp"
#include "io/series.hpp"
#include "pmr/base/constants.hpp"
#include "study/results.hpp"

namespace pmr::validate {
namespace {

std::vector<std::string> settings_of(const Experiment& e, const Variant& variant, std::size_t row,
                                     std::size_t seed) {
  const study::Values known = known_at(e, row);
  std::vector<std::string> settings;
  try {
    for (const study::Setting& setting : e.settings)
      settings.push_back(study::filled(setting, known));
    for (const study::Setting& setting : variant.settings)
      settings.push_back(study::filled(setting, known));
    for (const std::string& set : e.sets) settings.push_back(study::filled(set, known));
  } catch (const std::invalid_argument& error) {
    throw CaseError({{e.file.string(), "settings", error.what()}});
  }
  if (e.replicates > 1) settings.push_back(fmt::format("seed={}", seed));
  return settings;
}

// "pebbles", "pebbles_black", "voidage_row=3_seed=2".
std::string run_name(const Experiment& e, const Variant& variant, std::size_t row, bool is_one,
                     std::size_t seed) {
  std::string name = e.name;
  if (!variant.name.empty()) name += "_" + study::safe_name(variant.name);
  if (!is_one) name += fmt::format("_row={}", row + 1);
  if (e.replicates > 1) name += fmt::format("_seed={}", seed);
  return name;
}

// Adds the runs of one variant; those of equal settings are one run.
std::vector<std::vector<std::size_t>> places_of(const Experiment& e, const Variant& variant,
                                                study::Planner& planner, study::Plan& plan,
                                                std::vector<Fault>& faults) {
  std::map<std::vector<std::string>, std::size_t> made;
  const auto is_same = [&](std::size_t row) {
    return settings_of(e, variant, row, 1) == settings_of(e, variant, 0, 1);
  };
  bool is_one = true;
  for (std::size_t row = 1; row < e.points.rows; ++row) is_one = is_one && is_same(row);
  std::vector<std::vector<std::size_t>> places(e.points.rows);
  for (std::size_t row = 0; row < e.points.rows; ++row)
    for (std::size_t seed = 1; seed <= e.replicates; ++seed) {
      const auto settings = settings_of(e, variant, row, seed);
      const auto [found, is_new] = made.emplace(settings, plan.runs.size());
      places[row].push_back(found->second);
      if (!is_new) continue;
      study::PlannedRun run;
      run.name = run_name(e, variant, row, is_one, seed);
      for (Fault& fault : planner.add(plan, std::move(run), e.case_file, settings))
        faults.push_back(std::move(fault));
    }
  return places;
}

double from_series(const Experiment& e, const Figure& figure, std::size_t row,
                   const std::filesystem::path& run) {
  const io::Series series = io::read_series(run);
  const std::string name = study::filled(figure.column, known_at(e, row));
  if (!series.has(name)) {
    std::vector<std::string> names;
    for (const io::Column& column : series.columns) names.push_back(column.name);
    throw CaseError({{e.file.string(), "figures." + figure.name,
                      casefile::unknown_word("column of the series", name, names)}});
  }
  if (figure.at.empty()) return series.values(name).back();
  return io::at_time(series, name, study::evaluated(figure.at, known_at(e, row)));
}

}  // namespace

ValidationPlan make_plan(std::span<const Experiment> experiments) {
  ValidationPlan made;
  std::vector<Fault> faults;
  std::map<std::string, std::size_t> names;
  for (const Experiment& e : experiments) {
    if (names[e.name]++ > 0)
      faults.push_back({e.file.string(), "", "two experiments go by the name " + e.name});
    study::Planner planner;
    RunPlaces places;
    for (const Variant& variant : e.variants)
      places.push_back(places_of(e, variant, planner, made.plan, faults));
    made.places.push_back(std::move(places));
  }
  if (!faults.empty()) throw CaseError(std::move(faults));
  return made;
}

Reading read_run(const Experiment& experiment, std::size_t row, const study::Plan& plan,
                 std::size_t run, const study::Folder& folder) {
  const study::PlannedRun& planned = plan.runs[run];
  std::vector<study::Response> responses;
  for (const Figure& figure : experiment.figures)
    if (figure.column.empty())
      responses.push_back(
          {figure.name, "", "", study::filled(figure.key, known_at(experiment, row)), 1.0, 0.0});
  const study::Row found = study::row_of(responses, plan, planned, folder);
  Reading reading{found.status, found.reason, std::vector<double>(experiment.figures.size(), nan)};
  if (found.status != "completed") return reading;
  const auto keys = study::keys_of_summary(folder.run(planned));
  std::size_t next = 0;
  for (std::size_t f = 0; f < experiment.figures.size(); ++f) {
    const Figure& figure = experiment.figures[f];
    double value = nan;
    if (figure.column.empty()) {
      if (std::find(keys.begin(), keys.end(), responses[next].key) == keys.end())
        throw CaseError(
            {{experiment.file.string(), "figures." + figure.name + ".key",
              casefile::unknown_word("key of the summaries", responses[next].key, keys)}});
      value = found.responses[next++];
    } else {
      value = from_series(experiment, figure, row, folder.run(planned));
    }
    reading.figures[f] = figure.factor * value + figure.offset;
  }
  return reading;
}

}  // namespace pmr::validate
