#include "calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/correction.hpp"
#include "calibrate/stage_runs.hpp"
#include "case/nearest.hpp"
#include "statistics/band.hpp"

namespace pmr::calibrate {
namespace {

// Whether something derived changes with a parameter that is still a guess.
bool rests_on_guesses(const Lab& lab, const Derived& d, const Calibration& c) {
  for (const Stage& stage : lab.stages)
    for (const Parameter& p : stage.parameters) {
      const auto& found = c.found.parameters;
      if (std::find(found.begin(), found.end(), &p) != found.end()) continue;
      study::Values other = c.values;
      other[p.name] = p.guess == p.box.low ? p.box.high : p.box.low;
      if (completed(lab, other).at(d.name) != c.values.at(d.name)) return true;
    }
  return false;
}

// By the slopes of its formula at the parameters found.
DerivedFound derived_found(const Lab& lab, const Derived& d, const Calibration& c) {
  if (rests_on_guesses(lab, d, c)) return {nan, nan};
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
    for (std::size_t seed = 1; seed <= lab.tests[t].predictions; ++seed)
      wanted.push_back({t, false, c.values, "found", seed});
  const auto outcomes = runs.get(wanted);
  for (std::size_t t = 0; t < lab.tests.size(); ++t)
    for (std::size_t r = 0; r < lab.tests[t].targets.size(); ++r) {
      Predicted p{{t, r}, {}, ""};
      for (const Outcome& o : outcomes) {
        if (o.test != t) continue;
        if (std::isfinite(o.responses[r])) p.values.push_back(o.responses[r]);
        if (p.run.empty() && o.status == "completed") p.run = o.name;
      }
      c.predicted.push_back(std::move(p));
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
    wishes.on_stage(c.stages.back());
    c.is_refused = c.stages.back().modes.empty();
    gather(lab, c);
  }
  const bool is_whole = !c.is_refused && count == lab.stages.size();
  if (is_whole) {
    correct(lab, wishes, runs, c);
    predict(lab, runs, c);
    check_guesses(lab, c);
  }
  for (const Derived& d : lab.derived) c.derived.push_back(derived_found(lab, d, c));
  std::vector<std::string> warnings;
  for (const StageResult& result : c.stages)
    for (const auto* all : {&result.warnings, &result.doubts})
      for (const std::string& warning : *all)
        warnings.push_back("stage " + lab.stages[result.stage].name + ": " + warning);
  for (const std::string& warning : runs.warnings()) c.warnings.push_back(warning);
  c.warnings.insert(c.warnings.begin(), warnings.begin(), warnings.end());
  return c;
}

}  // namespace pmr::calibrate
