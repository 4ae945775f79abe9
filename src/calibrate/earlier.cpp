#include "calibrate/earlier.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace pmr::calibrate {
namespace {

constexpr std::size_t most_components = 3;

using Move = study::Values;  // of the earlier parameters, by name, to one side

// Deviations along the leading components of the correlation of those that reach the test.
std::vector<Move> components(const Found& earlier, const Runs& runs, std::size_t test) {
  std::vector<std::size_t> moved;
  for (std::size_t k = 0; k < earlier.parameters.size(); ++k)
    if (runs.reaches(earlier.parameters[k]->name, test) && earlier.covariance[k][k] > 0.0)
      moved.push_back(k);
  const auto n = static_cast<Eigen::Index>(moved.size());
  if (n == 0) return {};
  const auto deviation = [&](std::size_t k) { return std::sqrt(earlier.covariance[k][k]); };
  Eigen::MatrixXd correlation(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t a = moved[static_cast<std::size_t>(i)];
      const std::size_t b = moved[static_cast<std::size_t>(j)];
      correlation(i, j) = earlier.covariance[a][b] / (deviation(a) * deviation(b));
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(correlation);  // rising
  std::vector<Move> moves;
  for (Eigen::Index c = n - 1; c >= 0 && moves.size() < most_components; --c) {
    const double length = std::sqrt(std::max(0.0, solved.eigenvalues()[c]));
    Move move;
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t k = moved[static_cast<std::size_t>(i)];
      move[earlier.parameters[k]->name] = length * solved.eigenvectors()(i, c) * deviation(k);
    }
    moves.push_back(std::move(move));
  }
  return moves;
}

// The values moved to one side, within their boxes.
study::Values moved(const Found& earlier, const Move& move, double sign) {
  study::Values values;
  for (std::size_t k = 0; k < earlier.parameters.size(); ++k) {
    const Parameter& p = *earlier.parameters[k];
    if (const auto step = move.find(p.name); step != move.end())
      values[p.name] =
          rounded(std::clamp(earlier.values[k] + sign * step->second, p.box.low, p.box.high));
  }
  return values;
}

}  // namespace

void add_earlier(const Lab& lab, const Stage& stage, const StageRuns& wanted, const Found& earlier,
                 const std::vector<double>& at, Runs& runs, StageResult& result) {
  study::Values here;
  for (std::size_t v = 0; v < at.size(); ++v) here[stage.parameters[v].name] = rounded(at[v]);
  std::vector<Wanted> asked;
  for (std::size_t test = 0; test < lab.tests.size(); ++test) {
    const bool is_used = std::any_of(stage.use.begin(), stage.use.end(),
                                     [&](TargetIndex t) { return t.test == test; });
    if (!is_used) continue;
    const auto moves = components(earlier, runs, test);
    for (std::size_t c = 0; c < moves.size(); ++c)
      for (const double sign : {1.0, -1.0}) {
        study::Values changes = moved(earlier, moves[c], sign);
        changes.insert(here.begin(), here.end());
        asked.push_back(wanted.changed(
            test, changes, fmt::format("earlier-{}{}", c + 1, sign > 0.0 ? "up" : "down"),
            wanted.is_small(test), sign > 0.0 ? 1 : 2));
      }
  }
  if (asked.empty()) return;
  const auto outcomes = runs.get(asked);
  for (std::size_t l = 0; l < stage.use.size(); ++l) {
    Level& level = result.levels[l];
    const Target& target = lab.target(level.target);
    const double noise = level.fit.surrogate.basis().noise;
    double variance = 0.0;
    for (std::size_t k = 0; k + 1 < asked.size(); k += 2) {
      if (asked[k].test != level.target.test) continue;
      const double half =
          0.5 * (transformed(target, outcomes[k].responses[level.target.target]) -
                 transformed(target, outcomes[k + 1].responses[level.target.target]));
      if (std::isfinite(half))
        variance += half * half - 0.5 * noise * noise;
      else
        result.warnings.push_back("a run that moves earlier parameters gave no " +
                                  lab.target_name(level.target));
    }
    level.earlier = std::sqrt(std::max(0.0, variance));
    level.measured.deviation = std::hypot(level.measured.deviation, level.earlier);
  }
}

}  // namespace pmr::calibrate
