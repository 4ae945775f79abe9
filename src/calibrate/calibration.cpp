#include "calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/stage_runs.hpp"
#include "case/nearest.hpp"
#include "statistics/band.hpp"

namespace pmr::calibrate {
namespace {

// Adds what a stage found, with no covariance to those before.
void add_found(const Stage& stage, const StageResult& result, Calibration& c) {
  const std::size_t before = c.found.parameters.size(), more = stage.parameters.size();
  for (std::size_t v = 0; v < more; ++v) {
    c.found.parameters.push_back(&stage.parameters[v]);
    c.found.values.push_back(rounded(result.best().at[v]));
    c.values[stage.parameters[v].name] = c.found.values.back();
  }
  for (auto& row : c.found.covariance) row.resize(before + more, 0.0);
  c.found.covariance.resize(before + more, std::vector<double>(before + more, 0.0));
  for (std::size_t v = 0; v < more; ++v)
    for (std::size_t w = 0; w < more; ++w)
      c.found.covariance[before + v][before + w] = result.best().mode.covariance[v][w];
}

// By the slopes of its formula at the parameters found.
DerivedFound derived_found(const Lab& lab, const Derived& d, const Calibration& c) {
  constexpr double part = 0.05;  // [1] of a deviation
  const std::size_t n = c.found.parameters.size();
  std::vector<double> slopes(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const double step = part * std::sqrt(c.found.covariance[k][k]);
    if (!(step > 0.0)) continue;
    study::Values up = c.values, down = c.values;
    up[c.found.parameters[k]->name] += step;
    down[c.found.parameters[k]->name] -= step;
    slopes[k] = (completed(lab, up).at(d.name) - completed(lab, down).at(d.name)) / (2.0 * step);
  }
  double variance = 0.0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t l = 0; l < n; ++l)
      variance += slopes[k] * c.found.covariance[k][l] * slopes[l];
  return {c.values.at(d.name), std::sqrt(variance)};
}

// All tests at the parameters found, in full.
void predict(const Lab& lab, Runs& runs, Calibration& c) {
  std::vector<Wanted> wanted;
  for (std::size_t t = 0; t < lab.tests.size(); ++t)
    for (std::size_t seed = 1; seed <= lab.predictions; ++seed)
      wanted.push_back({t, false, c.values, "found", seed});
  const auto outcomes = runs.get(wanted);
  for (std::size_t t = 0; t < lab.tests.size(); ++t)
    for (std::size_t r = 0; r < lab.tests[t].targets.size(); ++r) {
      Predicted p{{t, r}, {}};
      for (const Outcome& o : outcomes)
        if (o.test == t && std::isfinite(o.responses[r])) p.values.push_back(o.responses[r]);
      c.predicted.push_back(std::move(p));
    }
}

// Where a stage's surrogate, made with guesses of later stages' parameters, foretold otherwise.
void check_guesses(const Lab& lab, Calibration& c) {
  for (const StageResult& result : c.stages)
    for (std::size_t l = 0; l < lab.stages[result.stage].use.size(); ++l) {
      const Level& level = result.levels[l];
      const Target& target = lab.target(level.target);
      for (const Predicted& p : c.predicted) {
        if (p.target.test != level.target.test || p.target.target != level.target.target ||
            p.values.empty())
          continue;
        const auto there = foretold(level, result.best().at);
        const double mean = statistics::band(p.values).mean;
        const double noise =
            level.fit.surrogate.basis().noise / std::sqrt(static_cast<double>(p.values.size()));
        const double sure =
            std::max(level.measured.deviation, 2.0 * std::hypot(there.deviation, noise));
        if (std::abs(transformed(target, mean) - there.mean) > sure)
          c.warnings.push_back(fmt::format(
              "{}: stage {} foretold {:.4g} {}, with all parameters found it is {:.4g}; set their "
              "guesses to what was found and calibrate again",
              lab.target_name(level.target), lab.stages[result.stage].name,
              restored(target, there.mean), target.response.unit, mean));
      }
    }
}

}  // namespace

std::size_t stages_wanted(const Lab& lab, const Wishes& wishes) {
  if (!wishes.last) return lab.stages.size();
  std::vector<std::string> names;
  for (const Stage& stage : lab.stages) {
    names.push_back(stage.name);
    if (stage.name == *wishes.last) return names.size();
  }
  throw CaseError({{"--stage", "", casefile::unknown_word("stage", *wishes.last, names)}});
}

Calibration calibrate(const Lab& lab, const Wishes& wishes, Runs& runs) {
  Calibration c;
  c.values = guesses(lab);
  const std::size_t count = stages_wanted(lab, wishes);
  for (std::size_t s = 0; s < count && !c.is_refused; ++s) {
    c.stages.push_back(solve(lab, s, c.values, c.found, wishes.is_full, runs));
    const StageResult& result = c.stages.back();
    wishes.on_stage(result);
    for (const std::string& warning : result.warnings)
      c.warnings.push_back("stage " + lab.stages[s].name + ": " + warning);
    c.is_refused = result.modes.empty();
    if (c.is_refused) continue;
    add_found(lab.stages[s], result, c);
    c.values = completed(lab, std::move(c.values));
  }
  for (const Derived& d : lab.derived) c.derived.push_back(derived_found(lab, d, c));
  const bool is_whole = !c.is_refused && count == lab.stages.size();
  if (is_whole && lab.predictions > 0) {
    predict(lab, runs, c);
    check_guesses(lab, c);
  }
  for (const std::string& warning : runs.warnings()) c.warnings.push_back(warning);
  return c;
}

}  // namespace pmr::calibrate
