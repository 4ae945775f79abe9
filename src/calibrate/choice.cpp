#include "calibrate/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics/crossing.hpp"

namespace pmr::calibrate {
namespace {

using statistics::Grid;

constexpr double clear = 10.0;    // [1] times as heavy as the next: decided
constexpr double far = 2.0;       // [1] deviations: a level that is missed
constexpr double on_edge = 0.01;  // [1] of the mass

double distance(const Stage& stage, const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const auto& box = stage.parameters[v].box;
    const double step = statistics::fraction_at(box, a[v]) - statistics::fraction_at(box, b[v]);
    square += step * step;
  }
  return std::sqrt(square);
}

// Each crossing belongs to the mode whose peak is nearest; a mode's own is the nearest of its.
void give_crossings(const Stage& stage, const statistics::Points& roots, StageResult& result) {
  for (const auto& root : roots) {
    ModeFound* nearest = &result.modes.front();
    for (ModeFound& m : result.modes)
      if (distance(stage, root, m.mode.best) < distance(stage, root, nearest->mode.best))
        nearest = &m;
    if (nearest->is_crossing && distance(stage, nearest->at, nearest->mode.best) <=
                                    distance(stage, root, nearest->mode.best))
      continue;
    nearest->at = root;
    nearest->is_crossing = true;
  }
}

void give_closest(const statistics::Problem& problem, const Grid& grid, StageResult& result) {
  result.is_closest = true;
  ModeFound& first = result.modes.front();
  first.at = statistics::closest(problem, grid);
  result.doubts.push_back(
      "the measured levels do not cross: the point that comes closest is given");
}

// The likelihood of what decides at each mode, times its mass.
void decide(const Lab& lab, const Stage& stage, StageResult& result) {
  std::vector<std::string> by;
  for (std::size_t l = stage.use.size(); l < result.levels.size(); ++l) {
    const Level& level = result.levels[l];
    if (!level.fit.refusal.empty()) {
      result.doubts.push_back(lab.target_name(level.target) +
                              " cannot decide, its surrogate does not hold: " + level.fit.refusal);
      continue;
    }
    by.push_back(lab.target_name(level.target));
    for (ModeFound& m : result.modes) {
      const auto there = level.fit.surrogate.predict(m.at);
      const double s = std::hypot(level.measured.deviation, there.deviation);
      const double miss = (there.mean - level.measured.level) / s;
      m.weight *= std::exp(-0.5 * miss * miss) / s;
    }
  }
  double sum = 0.0;
  for (const ModeFound& m : result.modes) sum += m.weight;
  const bool is_told = sum > 0.0;  // else no mode is anywhere near what decides
  for (ModeFound& m : result.modes) m.weight = is_told ? m.weight / sum : m.mode.mass;
  std::stable_sort(result.modes.begin(), result.modes.end(),
                   [](const ModeFound& a, const ModeFound& b) { return a.weight > b.weight; });
  const bool has_prior = std::any_of(stage.parameters.begin(), stage.parameters.end(),
                                     [](const Parameter& p) { return p.prior.has_value(); });
  if (result.modes.size() == 1) {
    result.decided = "There is one mode";
    return;
  }
  std::string what;
  for (const std::string& name : by) what += (what.empty() ? "" : ", ") + name;
  if (what.empty()) what = has_prior ? "the prior" : "nothing but the modes' masses";
  result.decided = fmt::format("{} modes; {} gives the first {:.2g} of the weight",
                               result.modes.size(), what, result.modes.front().weight);
  if (result.modes[0].weight < clear * result.modes[1].weight)
    result.doubts.push_back(
        fmt::format("{} modes, none clearly the heaviest: all are given, the first is used",
                    result.modes.size()));
}

}  // namespace

Miss miss_of(const Target& target, const Level& level, const std::vector<double>& point) {
  const auto there = level.fit.surrogate.predict(point);
  const double off = there.mean - level.measured.level, s = level.measured.deviation;
  const double unit = target.is_logarithmic ? target.value : 1.0;
  const double predicted = restored(target, there.mean + level.shift());
  return {predicted, predicted - target.value, off / s,
          unit * std::sqrt(std::max(0.0, off * off - s * s))};
}

void choose(const Lab& lab, const Stage& stage, StageResult& result) {
  result.modes.clear();
  result.doubts.clear();
  result.is_closest = false;
  const auto problem = problem_of(stage, result.levels);
  std::vector<statistics::Span> box;
  for (const Parameter& p : stage.parameters) box.push_back(p.box);
  const Grid grid(box, fine_steps(stage));
  for (statistics::Mode& mode : statistics::find_modes(problem, box, grid.steps())) {
    const auto at = mode.best;
    const double mass = mode.mass;
    result.modes.push_back({std::move(mode), at, false, mass});
  }
  const bool may_cross = stage.use.size() == stage.parameters.size();
  const auto roots = may_cross ? statistics::crossings(problem, grid) : statistics::Points{};
  if (may_cross && !roots.empty()) give_crossings(stage, roots, result);
  if (may_cross && roots.empty()) give_closest(problem, grid, result);
  decide(lab, stage, result);
  std::vector<statistics::Field> fields;
  for (const auto& response : problem.responses)
    fields.push_back(statistics::field_of(grid, response));
  result.mass_on_edge =
      statistics::normalised(
          grid, statistics::log_density(grid, fields, problem.measured, problem.priors))
          .mass_on_edge(grid);
  if (result.mass_on_edge > on_edge)
    result.doubts.push_back(fmt::format(
        "{:.0f} % of the mass lies on the edge of the box: widen it", 100.0 * result.mass_on_edge));
  for (std::size_t l = 0; l < stage.use.size(); ++l) {
    const Target& target = lab.target(stage.use[l]);
    const Miss miss = miss_of(target, result.levels[l], result.best().at);
    if (std::abs(miss.deviations) > far)
      result.doubts.push_back(fmt::format(
          "{} is missed by {:.3g} {} ({:.1f} deviations); a discrepancy of {:.3g} would reconcile "
          "them",
          lab.target_name(stage.use[l]), miss.difference, target.response.unit, miss.deviations,
          miss.discrepancy));
  }
}

}  // namespace pmr::calibrate
