#include "statistics/crossing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "pmr/base/errors.hpp"

namespace pmr::statistics {
namespace {

using Place = std::array<double, 2>;

std::vector<double> point_at(const std::vector<Span>& spans, const std::vector<double>& fractions) {
  std::vector<double> point(fractions.size());
  for (std::size_t k = 0; k < point.size(); ++k) point[k] = value_at(spans[k], fractions[k]);
  return point;
}

// Where the level lies on the edge of a cell between two corners.
Place between(const Grid& grid, const std::vector<double>& values, double level,
              std::array<std::size_t, 2> ends) {
  const auto a = grid.fractions(ends[0]), b = grid.fractions(ends[1]);
  const double part = (level - values[ends[0]]) / (values[ends[1]] - values[ends[0]]);
  Place place;
  for (std::size_t k = 0; k < 2; ++k)
    place[k] = value_at(grid.spans()[k], a[k] + part * (b[k] - a[k]));
  return place;
}

// Misses of all responses, in their deviations, at fractions of the box.
Eigen::VectorXd misses(const Problem& problem, const std::vector<Span>& spans,
                       const std::vector<double>& fractions) {
  const std::vector<double> point = point_at(spans, fractions);
  Eigen::VectorXd all(static_cast<Eigen::Index>(problem.responses.size()));
  for (std::size_t r = 0; r < problem.responses.size(); ++r)
    all[static_cast<Eigen::Index>(r)] =
        (problem.responses[r](point).mean - problem.measured[r].level) /
        problem.measured[r].deviation;
  return all;
}

// Newton's method with central differences; none where it leaves the box or does not settle.
std::optional<std::vector<double>> newton(const Problem& problem, const std::vector<Span>& spans,
                                          std::vector<double> at) {
  // Steps at a root of surrogates of 20 runs go on at 3e-11 to 7e-10, by the surrogates' rounding.
  constexpr double step = 1e-5, settled = 1e-8, beyond = 0.05;  // [1] of the spans
  constexpr int most = 40;
  const std::size_t d = at.size();
  for (int k = 0; k < most; ++k) {
    Eigen::MatrixXd slopes(d, d);
    for (std::size_t v = 0; v < d; ++v) {
      auto low = at, high = at;
      low[v] -= step;
      high[v] += step;
      slopes.col(static_cast<Eigen::Index>(v)) =
          (misses(problem, spans, high) - misses(problem, spans, low)) / (2.0 * step);
    }
    const Eigen::VectorXd move = slopes.partialPivLu().solve(misses(problem, spans, at));
    for (std::size_t v = 0; v < d; ++v) {
      at[v] -= move[static_cast<Eigen::Index>(v)];
      if (!(at[v] > -beyond && at[v] < 1.0 + beyond)) return std::nullopt;
    }
    if (move.norm() < settled) break;
    if (k + 1 == most) return std::nullopt;
  }
  const bool is_inside =
      std::all_of(at.begin(), at.end(), [](double f) { return f >= -1e-9 && f <= 1.0 + 1e-9; });
  return is_inside ? std::optional(at) : std::nullopt;
}

// Whether the level lies between the values at the corners.
bool is_crossed(const std::vector<std::size_t>& corners, const std::vector<double>& values,
                double level) {
  const auto is_above = [&](std::size_t i) { return values[i] > level; };
  return std::any_of(corners.begin(), corners.end(), is_above) &&
         !std::all_of(corners.begin(), corners.end(), is_above);
}

}  // namespace

std::vector<Segment> level_line(const Grid& grid, const std::vector<double>& values, double level) {
  ensure(grid.dimension() == 2, "a level line is one of two variables");
  std::vector<Segment> line;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const auto c = grid.corners(i);
    if (c.empty() || !is_crossed(c, values, level)) continue;
    // Round the cell; where the level passes an edge stands in `cuts`.
    const std::array<std::size_t, 5> round{c[0], c[1], c[3], c[2], c[0]};
    std::vector<Place> cuts;
    for (std::size_t e = 0; e < 4; ++e)
      if ((values[round[e]] > level) != (values[round[e + 1]] > level))
        cuts.push_back(between(grid, values, level, {round[e], round[e + 1]}));
    if (cuts.size() == 2) line.push_back({cuts[0], cuts[1]});
    if (cuts.size() != 4) continue;
    const double middle = (values[c[0]] + values[c[1]] + values[c[2]] + values[c[3]]) / 4.0;
    // Cut 0 follows the first corner: the corners cut off are the first and third, or the others.
    const bool cuts_off_first = (values[c[0]] > level) != (middle > level);
    const std::size_t first = cuts_off_first ? 3 : 1;
    line.push_back({cuts[0], cuts[first]});
    line.push_back({cuts[2], cuts[4 - first]});
  }
  return line;
}

Points crossings(const Problem& problem, const Grid& grid) {
  ensure(problem.responses.size() == grid.dimension(), "as many levels cross as there are axes");
  std::vector<Field> fields;
  for (const Response& response : problem.responses) fields.push_back(field_of(grid, response));
  constexpr double same = 1e-5;  // [1] of the spans
  Points found;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const auto corners = grid.corners(i);
    bool are_crossed = !corners.empty();
    for (std::size_t r = 0; r < fields.size() && are_crossed; ++r)
      are_crossed = is_crossed(corners, fields[r].mean, problem.measured[r].level);
    if (!are_crossed) continue;
    std::vector<double> start = grid.fractions(i);
    for (double& f : start) f += 0.5 / static_cast<double>(grid.steps() - 1);
    const auto root = newton(problem, grid.spans(), start);
    if (!root) continue;
    const bool is_known = std::any_of(found.begin(), found.end(), [&](const auto& other) {
      return std::equal(other.begin(), other.end(), root->begin(),
                        [](double a, double b) { return std::abs(a - b) < same; });
    });
    if (!is_known) found.push_back(*root);
  }
  for (auto& root : found) root = point_at(grid.spans(), root);
  return found;
}

std::vector<double> closest(const Problem& problem, const Grid& grid) {
  const auto badness = [&](const std::vector<double>& fractions) {
    return misses(problem, grid.spans(), fractions).squaredNorm();
  };
  std::vector<double> at;
  double least = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const auto fractions = grid.fractions(i);
    const double here = badness(fractions);
    if (at.empty() || here < least) {
      at = fractions;
      least = here;
    }
  }
  for (double step = 1.0 / static_cast<double>(grid.steps() - 1); step > 1e-7;) {
    bool is_better = false;
    for (std::size_t v = 0; v < at.size(); ++v)
      for (const double move : {-step, step}) {
        auto trial = at;
        trial[v] = std::clamp(at[v] + move, 0.0, 1.0);
        const double there = badness(trial);
        if (there < least) {
          at = trial;
          least = there;
          is_better = true;
        }
      }
    if (!is_better) step *= 0.5;
  }
  return point_at(grid.spans(), at);
}

}  // namespace pmr::statistics
