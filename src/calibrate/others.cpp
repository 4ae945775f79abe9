#include "calibrate/others.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace pmr::calibrate {
namespace {

constexpr std::size_t most_components = 3;

using Move = study::Values;  // of the others' parameters, by name, to one side

// Deviations along the leading components of the correlation of those that reach the test.
std::vector<Move> components(const Found& others, const Runs& runs, std::size_t test) {
  std::vector<std::size_t> moved;
  for (std::size_t k = 0; k < others.parameters.size(); ++k)
    if (runs.reaches(others.parameters[k]->name, test) && others.covariance[k][k] > 0.0)
      moved.push_back(k);
  const auto n = static_cast<Eigen::Index>(moved.size());
  if (n == 0) return {};
  const auto deviation = [&](std::size_t k) { return std::sqrt(others.covariance[k][k]); };
  Eigen::MatrixXd correlation(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t a = moved[static_cast<std::size_t>(i)];
      const std::size_t b = moved[static_cast<std::size_t>(j)];
      correlation(i, j) = others.covariance[a][b] / (deviation(a) * deviation(b));
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(correlation);  // rising
  std::vector<Move> moves;
  for (Eigen::Index c = n - 1; c >= 0 && moves.size() < most_components; --c) {
    const double length = std::sqrt(std::max(0.0, solved.eigenvalues()[c]));
    Move move;
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t k = moved[static_cast<std::size_t>(i)];
      move[others.parameters[k]->name] = length * solved.eigenvectors()(i, c) * deviation(k);
    }
    moves.push_back(std::move(move));
  }
  return moves;
}

// The part of a move to one side that stays within the boxes [1].
double part_inside(const Found& others, const Move& move, double sign) {
  double part = 1.0;
  for (std::size_t k = 0; k < others.parameters.size(); ++k) {
    const auto step = move.find(others.parameters[k]->name);
    if (step == move.end() || step->second == 0.0) continue;
    const statistics::Span& box = others.parameters[k]->box;
    const double edge = sign * step->second > 0.0 ? box.high : box.low;
    part = std::min(part, std::max(0.0, (edge - others.values[k]) / (sign * step->second)));
  }
  return part;
}

study::Values moved(const Found& others, const Move& move, double by) {
  study::Values values;
  for (std::size_t k = 0; k < others.parameters.size(); ++k)
    if (const auto step = move.find(others.parameters[k]->name); step != move.end())
      values[step->first] = rounded(others.values[k] + by * step->second);
  return values;
}

// A test at either side of a move.
struct Sides {
  std::size_t test;
  double width;  // [1] of the move, between the sides: 2 where neither meets the edge of a box
};

}  // namespace

void add_others(const Lab& lab, const Stage& stage, const StageRuns& wanted, const Found& others,
                const std::vector<double>& at, const std::string& which, Runs& runs,
                StageResult& result) {
  study::Values here;
  for (std::size_t v = 0; v < at.size(); ++v) here[stage.parameters[v].name] = rounded(at[v]);
  std::vector<Wanted> asked;
  std::vector<Sides> sides;  // each asks for two runs
  for (std::size_t test = 0; test < lab.tests.size(); ++test) {
    const bool is_used = std::any_of(stage.use.begin(), stage.use.end(),
                                     [&](TargetIndex t) { return t.test == test; });
    if (!is_used) continue;
    const auto moves = components(others, runs, test);
    for (std::size_t c = 0; c < moves.size(); ++c) {
      const double up = part_inside(others, moves[c], 1.0);
      const double down = part_inside(others, moves[c], -1.0);
      if (up + down == 0.0) continue;
      sides.push_back({test, up + down});
      for (const double by : {up, -down}) {
        study::Values changes = moved(others, moves[c], by);
        changes.insert(here.begin(), here.end());
        const bool is_up = asked.size() % 2 == 0;
        asked.push_back(wanted.changed(test, changes,
                                       fmt::format("{}-{}{}", which, c + 1, is_up ? "up" : "down"),
                                       wanted.is_small(test), is_up ? 1 : 2));
      }
    }
  }
  if (asked.empty()) return;
  const auto outcomes = runs.get(asked);
  for (std::size_t l = 0; l < stage.use.size(); ++l) {
    Level& level = result.levels[l];
    const Target& target = lab.target(level.target);
    const double noise = level.fit.surrogate.basis().noise;
    const auto value = [&](std::size_t run) {
      return transformed(target, outcomes[run].responses[level.target.target]);
    };
    double variance = 0.0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (sides[k].test != level.target.test) continue;
      const double slope = (value(2 * k) - value(2 * k + 1)) / sides[k].width;
      if (std::isfinite(slope))
        variance += slope * slope - 2.0 * noise * noise / (sides[k].width * sides[k].width);
      else
        result.warnings.push_back("a run that moves other stages' parameters gave no " +
                                  lab.target_name(level.target));
    }
    const double more = std::sqrt(std::max(0.0, variance));
    level.others = std::hypot(level.others, more);
    level.measured.deviation = std::hypot(level.measured.deviation, more);
  }
}

}  // namespace pmr::calibrate
