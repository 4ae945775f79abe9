#include "calibrate/correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/choice.hpp"
#include "calibrate/others.hpp"
#include "calibrate/stage_runs.hpp"
#include "statistics/band.hpp"

namespace pmr::calibrate {
namespace {

constexpr double matters = 0.5;  // [1] of the measured deviation: a difference that does
constexpr double sure = 2.0;     // [1] deviations: a difference that is none of noise

bool is_used(const Stage& stage, std::size_t test) {
  return std::any_of(stage.use.begin(), stage.use.end(),
                     [&](TargetIndex t) { return t.test == test; });
}

// The transformed response of each run that has it; of a censored one, its limit.
std::vector<double> values_of(const Lab& lab, TargetIndex at,
                              const std::vector<Outcome>& outcomes) {
  const Target& target = lab.target(at);
  std::vector<double> values;
  for (const Outcome& o : outcomes) {
    if (o.test != at.test) continue;
    const double value = o.responses[at.target];
    if (std::isfinite(value))
      values.push_back(transformed(target, value));
    else if (o.status == "completed" && target.beyond)
      values.push_back(transformed(target, *target.beyond));
  }
  return values;
}

// Adds to a level what it is off by; false where that is nothing. What would take a correction back
// is taken by half, the other half being its error: a surrogate is not off by the same everywhere,
// and with all of it the point found can swing between two places for ever.
bool correct_level(const StageResult& result, const std::vector<double>& values, Level& level) {
  if (values.empty() || !level.fit.refusal.empty()) return false;
  const auto there = level.fit.surrogate.predict(result.best().at);
  const double noise =
      level.fit.surrogate.basis().noise / std::sqrt(static_cast<double>(values.size()));
  const double off = statistics::band(values).mean - there.mean - level.guesses.value;
  if (std::abs(off) <=
      std::max(matters * level.measured.deviation, sure * std::hypot(there.deviation, noise)))
    return false;
  const double left = off * level.guesses.value < 0.0 ? 0.5 * off : 0.0;
  level.add(level.guesses, off - left, std::hypot(noise, left));
  return true;
}

// One round: true where a level was corrected.
bool correct_once(const Lab& lab, bool is_full, std::size_t round, Runs& runs, Calibration& c) {
  std::vector<Wanted> wanted;
  for (std::size_t t = 0; t < lab.tests.size(); ++t) {
    if (std::none_of(lab.stages.begin(), lab.stages.end(),
                     [&](const Stage& stage) { return is_used(stage, t); }))
      continue;
    const bool is_small = !is_full && !lab.tests[t].small.empty();
    for (std::size_t seed = 1; seed <= lab.tests[t].predictions; ++seed)
      wanted.push_back({t, is_small, c.values, fmt::format("round-{}", round), seed});
  }
  const auto outcomes = runs.get(wanted);
  bool is_corrected = false;
  for (StageResult& result : c.stages) {
    bool is_moved = false;
    for (Level& level : result.levels)
      is_moved |= correct_level(result, values_of(lab, level.target, outcomes), level);
    if (is_moved) choose(lab, lab.stages[result.stage], result);
    is_corrected |= is_moved;
  }
  return is_corrected;
}

// The parameters of the stages after one.
Found after(const Lab& lab, const Calibration& c, std::size_t stage) {
  std::size_t first = 0;
  for (std::size_t s = 0; s <= stage; ++s) first += lab.stages[s].parameters.size();
  Found later;
  for (std::size_t k = first; k < c.found.parameters.size(); ++k) {
    later.parameters.push_back(c.found.parameters[k]);
    later.values.push_back(c.found.values[k]);
    later.covariance.emplace_back(
        c.found.covariance[k].begin() + static_cast<std::ptrdiff_t>(first),
        c.found.covariance[k].end());
  }
  return later;
}

void add_later(const Lab& lab, bool is_full, Runs& runs, Calibration& c) {
  for (StageResult& result : c.stages) {
    const Stage& stage = lab.stages[result.stage];
    const StageRuns wanted(lab, result.stage, c.values, is_full);
    add_others(lab, stage, wanted, after(lab, c, result.stage), result.best().at, "later", runs,
               result);
    choose(lab, stage, result);
  }
  gather(lab, c);
}

}  // namespace

void gather(const Lab& lab, Calibration& c) {
  c.found = {};
  for (const StageResult& result : c.stages) {
    if (result.modes.empty()) continue;
    const Stage& stage = lab.stages[result.stage];
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
  c.values = completed(lab, std::move(c.values));
}

void correct(const Lab& lab, const Wishes& wishes, Runs& runs, Calibration& c) {
  if (lab.stages.size() < 2) return;  // nothing was guessed
  for (std::size_t round = 1; round <= lab.rounds; ++round) {
    if (!correct_once(lab, wishes.is_full, round, runs, c)) break;
    gather(lab, c);
    for (const StageResult& result : c.stages) wishes.on_stage(result);
  }
  add_later(lab, wishes.is_full, runs, c);
}

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
        if (std::abs(transformed(target, mean) - there.mean) >
            std::max(level.measured.deviation, sure * std::hypot(there.deviation, noise)))
          c.warnings.push_back(fmt::format(
              "{}: stage {} foretold {:.4g} {}, with all parameters found it is {:.4g}; set their "
              "guesses to what was found and calibrate again",
              lab.target_name(level.target), lab.stages[result.stage].name,
              restored(target, there.mean), target.response.unit, mean));
      }
    }
}

}  // namespace pmr::calibrate
