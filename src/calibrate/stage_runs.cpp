#include "calibrate/stage_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pmr::calibrate {
namespace {

std::vector<statistics::Span> spans_of(const Stage& stage) {
  std::vector<statistics::Span> spans;
  for (const Parameter& p : stage.parameters) spans.push_back(p.box);
  return spans;
}

}  // namespace

double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

std::vector<TargetIndex> targets_of(const Stage& stage) {
  std::vector<TargetIndex> targets = stage.use;
  targets.insert(targets.end(), stage.decide.begin(), stage.decide.end());
  return targets;
}

StageRuns::StageRuns(const Lab& lab, std::size_t stage, study::Values values, bool is_full)
    : lab_(lab), stage_(lab.stages[stage]), values_(std::move(values)), is_full_(is_full) {
  for (const TargetIndex target : targets_of(stage_))
    if (std::find(tests_.begin(), tests_.end(), target.test) == tests_.end())
      tests_.push_back(target.test);
}

std::vector<DesignPoint> StageRuns::first_points() const {
  const Sampling& s = stage_.sampling;
  std::vector<DesignPoint> points;
  std::size_t seed = 1;
  for (const auto& point : statistics::sample(statistics::Sequence::latin_hypercube,
                                              spans_of(stage_), s.points, s.seed)) {
    DesignPoint one{{}, seed, points.size() < s.replicated ? s.replicates : 1};
    seed += one.seeds;
    for (const double x : point) one.at.push_back(rounded(x));
    points.push_back(std::move(one));
  }
  return points;
}

Wanted StageRuns::changed(std::size_t test, const study::Values& changes, const std::string& label,
                          bool is_small, std::size_t seed) const {
  study::Values values = values_;
  for (const auto& [name, value] : changes) values[name] = value;
  return {test, is_small, completed(lab_, std::move(values)), stage_.name + "_" + label, seed};
}

std::vector<Wanted> StageRuns::wanted(const std::vector<DesignPoint>& points,
                                      bool are_first) const {
  std::vector<Wanted> all;
  for (std::size_t k = 0; k < points.size(); ++k) {
    study::Values changes;
    std::string label;
    for (std::size_t v = 0; v < points[k].at.size(); ++v) {
      const std::string& name = stage_.parameters[v].name;
      changes[name] = points[k].at[v];
      label += (v == 0 ? "" : "_") + fmt::format("{}={:.6g}", name, points[k].at[v]);
    }
    for (const std::size_t test : tests_) {
      for (std::size_t seed = 0; seed < points[k].seeds; ++seed)
        all.push_back(changed(test, changes, label, is_small(test), points[k].first_seed + seed));
      if (are_first && is_small(test) && k < lab_.tests[test].pairs)
        all.push_back(changed(test, changes, label, false, points[k].first_seed));
    }
  }
  return all;
}

std::vector<Wanted> first_runs(const Lab& lab, std::size_t stage, const study::Values& values,
                               bool is_full) {
  const StageRuns runs(lab, stage, values, is_full);
  return runs.wanted(runs.first_points(), true);
}

}  // namespace pmr::calibrate
