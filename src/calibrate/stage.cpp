#include "calibrate/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "calibrate/choice.hpp"
#include "calibrate/others.hpp"
#include "calibrate/stage_runs.hpp"
#include "statistics/band.hpp"
#include "statistics/crossing.hpp"

namespace pmr::calibrate {
namespace {

using statistics::Grid;
using statistics::Mode;

// Points along each variable of the grid on which the next run is looked for.
constexpr std::array<std::size_t, 3> coarse{401, 81, 25};
constexpr std::array<std::size_t, 3> fine{2001, 201, 41};
constexpr double told = 0.5;    // [1] of the measured deviation: a surrogate that tells enough
constexpr double heavy = 0.01;  // [1] of a mode, or of the mass on the box's edge

std::vector<statistics::Span> box_of(const Stage& stage) {
  std::vector<statistics::Span> box;
  for (const Parameter& p : stage.parameters) box.push_back(p.box);
  return box;
}

// Small and full runs of one test at one point.
struct Pair {
  std::vector<double> small;  // transformed
  double full = nan;
};

// Runs, their samples, and the surrogates that follow.
class Search {
 public:
  Search(const Lab& lab, std::size_t stage, const study::Values& values, bool is_full, Runs& runs)
      : lab_(lab),
        stage_(lab.stages[stage]),
        targets_(targets_of(stage_)),
        wanted_(lab, stage, values, is_full),
        runs_(runs) {
    result_.stage = stage;
    result_.samples.resize(targets_.size());
    pairs_.resize(targets_.size());
  }

  StageResult run(const Found& earlier) {
    add(wanted_.first_points(), true);
    while (true) {
      fit_all();
      if (const auto reason = end(); !reason.empty()) {
        result_.ended = reason;
        break;
      }
      const auto next = next_points();
      if (next.empty()) {
        result_.ended = "the point that would tell most was run already, and has no noise";
        break;
      }
      add(next, false);
    }
    if (refuse()) return std::move(result_);
    add_others(lab_, stage_, wanted_, earlier, mode_in_sight(), "earlier", runs_, result_);
    choose(lab_, stage_, result_);
    return std::move(result_);
  }

 private:
  void add(const std::vector<DesignPoint>& points, bool are_first) {
    const auto wanted = wanted_.wanted(points, are_first);
    const auto outcomes = runs_.get(wanted);
    visits_ += points.size();
    for (const DesignPoint& point : points)
      if (is_new(point.at)) result_.points.push_back(point.at);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      std::vector<double> at;
      for (const Parameter& p : stage_.parameters) at.push_back(wanted[k].values.at(p.name));
      for (std::size_t l = 0; l < targets_.size(); ++l)
        if (targets_[l].test == wanted[k].test) take(l, at, outcomes[k]);
    }
  }

  void take(std::size_t level, const std::vector<double>& at, const Outcome& outcome) {
    const double value = outcome.responses[targets_[level].target];
    const bool is_full_pair = !outcome.is_small && wanted_.is_small(outcome.test);
    Pair& pair = pairs_[level][at];
    const double transformed_value = transformed(lab_.target(targets_[level]), value);
    if (is_full_pair)
      pair.full = transformed_value;
    else
      result_.samples[level].push_back({at, value, outcome.status == "completed"});
    if (!is_full_pair && std::isfinite(value)) pair.small.push_back(transformed_value);
  }

  bool is_new(const std::vector<double>& at) const {
    return std::find(result_.points.begin(), result_.points.end(), at) == result_.points.end();
  }

  void fit_all() {
    result_.levels.clear();
    for (std::size_t l = 0; l < targets_.size(); ++l) {
      const Target& target = lab_.target(targets_[l]);
      Level level{targets_[l],     fit(target, stage_.parameters, result_.samples[l]), {}, {}, 0.0,
                  measured(target)};
      correct(level, l);
      result_.levels.push_back(std::move(level));
    }
  }

  // From small to full samples: the mean difference of the pairs. Its error is that of the mean,
  // and what the differences scatter by beyond the seeds' noise, as the difference may go with the
  // point.
  void correct(Level& level, std::size_t l) const {
    if (!wanted_.is_small(level.target.test)) return;
    std::vector<double> differences;
    double noise = 0.0;  // [transformed squared] of a difference, from the seeds
    for (const auto& [at, pair] : pairs_[l]) {
      if (pair.small.empty() || !std::isfinite(pair.full)) continue;
      differences.push_back(pair.full - statistics::band(pair.small).mean);
      const double seeds = level.fit.surrogate.basis().noise;
      noise += seeds * seeds * (1.0 + 1.0 / static_cast<double>(pair.small.size()));
    }
    const auto n = static_cast<double>(differences.size());
    if (differences.size() < 2) {
      level.fit.refusal = "fewer than two points were run both small and in full";
      return;
    }
    const auto band = statistics::band(differences);
    const double scatter = band.deviation * band.deviation;
    level.add(level.small, band.mean, std::sqrt(scatter / n + std::max(0.0, scatter - noise / n)));
  }

  std::vector<statistics::Field> fields_on(const Grid& grid) const {
    std::vector<statistics::Field> fields;
    for (const auto& response : problem_of(stage_, result_.levels).responses)
      fields.push_back(statistics::field_of(grid, response));
    return fields;
  }

  Grid coarse_grid() const { return Grid(box_of(stage_), coarse[stage_.parameters.size() - 1]); }

  bool is_foretold() const {
    return std::all_of(result_.levels.begin(),
                       result_.levels.begin() + static_cast<std::ptrdiff_t>(stage_.use.size()),
                       [](const Level& l) { return l.fit.surrogate.basis().why_constant.empty(); });
  }

  bool is_told_at(const std::vector<double>& point) const {
    for (std::size_t l = 0; l < stage_.use.size(); ++l) {
      const Level& level = result_.levels[l];
      const double deviation = level.fit.surrogate.predict(point).deviation;
      if (!(deviation < told * level.measured.deviation)) return false;
    }
    return true;
  }

  // Why there is nothing more to be run; empty where there is.
  std::string end() const {
    if (!is_foretold()) return "there are too few results to go on from";
    const bool is_full_up = visits_ >= stage_.sampling.most;
    const auto problem = problem_of(stage_, result_.levels);
    const Grid grid = coarse_grid();
    const auto posterior = statistics::normalised(
        grid, statistics::log_density(grid, fields_on(grid), problem.measured, problem.priors));
    bool is_told = true;
    for (const Mode& mode : statistics::find_modes(problem, grid.spans(), grid.steps()))
      is_told = is_told && (mode.mass < heavy || is_told_at(mode.best));
    if (posterior.mass_on_edge(grid) > heavy)
      is_told = is_told && is_told_at(grid.point(heaviest_on_edge(grid, posterior)));
    for (std::size_t l = 0; l < stage_.use.size(); ++l)
      is_told = is_told && result_.levels[l].fit.refusal.empty();
    if (is_told) return "the surrogates are surer than half of the measured deviations";
    return is_full_up ? fmt::format("the most points were run, {}", stage_.sampling.most) : "";
  }

  static std::size_t heaviest_on_edge(const Grid& grid, const statistics::Posterior& posterior) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (grid.is_on_edge(i) && posterior.log_density[i] > posterior.log_density[best]) best = i;
    return best;
  }

  // One after the other, each as if the one before had come out as expected.
  std::vector<DesignPoint> next_points() {
    const auto samples = result_.samples;
    std::vector<DesignPoint> points;
    const std::size_t room = stage_.sampling.most - visits_;
    while (points.size() < std::min(stage_.sampling.batch, room)) {
      const Grid grid = coarse_grid();
      const auto fields = fields_on(grid);
      const auto problem = problem_of(stage_, result_.levels);
      const auto posterior = statistics::normalised(
          grid, statistics::log_density(grid, fields, problem.measured, problem.priors));
      std::vector<double> at =
          grid.point(statistics::most_telling(posterior, fields, problem.measured));
      for (double& x : at) x = rounded(x);
      if (is_run(at) && !has_noise()) break;
      points.push_back({at, result_.samples.front().size() + 1, 1});
      if (points.size() == stage_.sampling.batch) break;
      for (std::size_t l = 0; l < result_.levels.size(); ++l) {
        const double expected = result_.levels[l].fit.surrogate.predict(at).mean;
        result_.samples[l].push_back({at, restored(lab_.target(targets_[l]), expected), true});
      }
      fit_all();
    }
    result_.samples = samples;
    return points;
  }

  bool has_noise() const {
    return std::any_of(result_.levels.begin(), result_.levels.end(),
                       [](const Level& l) { return l.fit.surrogate.basis().noise > 0.0; });
  }

  bool is_run(const std::vector<double>& at) const {
    const auto& samples = result_.samples.front();
    return std::any_of(samples.begin(), samples.end(),
                       [&](const Sample& s) { return s.point == at; });
  }

  bool refuse() {
    bool is_refused = false;
    for (std::size_t l = 0; l < stage_.use.size(); ++l) {
      const Level& level = result_.levels[l];
      const std::string name = lab_.target_name(level.target);
      if (!level.fit.refusal.empty()) {
        result_.warnings.push_back("refused: the surrogate of " + name +
                                   " does not hold: " + level.fit.refusal);
        is_refused = true;
      } else if (const double wanted = restored(lab_.target(level.target), level.measured.level);
                 !is_within_reach(wanted, level.fit)) {
        result_.warnings.push_back(
            fmt::format("target out of reach: {} = {:.4g}, the runs lie between {:.4g} and {:.4g}; "
                        "widen the box",
                        name, wanted, level.fit.low, level.fit.high));
      }
    }
    return is_refused;
  }

  std::vector<double> mode_in_sight() const {
    const Grid grid = coarse_grid();
    return statistics::find_modes(problem_of(stage_, result_.levels), grid.spans(), grid.steps())
        .front()
        .best;
  }

  const Lab& lab_;
  const Stage& stage_;
  std::vector<TargetIndex> targets_;
  StageRuns wanted_;
  Runs& runs_;
  StageResult result_;
  std::size_t visits_ = 0;  // [1] points run, those run again counted again
  std::vector<std::map<std::vector<double>, Pair>> pairs_;  // of each level, by the point
};

}  // namespace

void Level::add(Shift& shift, double value, double error) {
  const double before = shift.error;
  const double variance = measured.deviation * measured.deviation - before * before;
  shift = {shift.value + value, error};
  measured.level -= value;
  measured.deviation = std::sqrt(std::max(0.0, variance) + error * error);
}

statistics::Problem problem_of(const Stage& stage, const std::vector<Level>& levels) {
  statistics::Problem problem;
  for (std::size_t l = 0; l < stage.use.size(); ++l) {
    problem.responses.emplace_back(
        [surrogate = &levels[l].fit.surrogate](std::span<const double> p) {
          return surrogate->predict(p);
        });
    problem.measured.push_back(levels[l].measured);
  }
  for (const Parameter& p : stage.parameters) problem.priors.push_back(p.prior);
  return problem;
}

statistics::Prediction foretold(const Level& level, const std::vector<double>& point) {
  const auto bare = level.fit.surrogate.predict(point);
  return {bare.mean + level.shift(),
          std::hypot(bare.deviation, level.small.error, level.guesses.error)};
}

std::size_t fine_steps(const Stage& stage) { return fine[stage.parameters.size() - 1]; }

StageResult solve(const Lab& lab, std::size_t stage, const study::Values& values,
                  const Found& earlier, bool is_full, Runs& runs) {
  return Search(lab, stage, values, is_full, runs).run(earlier);
}

}  // namespace pmr::calibrate
