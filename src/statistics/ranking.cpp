#include "statistics/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <openturns/CorrelationAnalysis.hxx>

#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/random.hpp"
#include "statistics/band.hpp"

namespace pmr::statistics {
namespace {

constexpr std::size_t resamples = 400;

using Column = std::vector<double>;

// Ranks from 1, equal values at the mean of theirs. (OpenTURNS gives equal values the highest.)
Column mean_ranks(const Column& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  Column ranks(values.size());
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    for (std::size_t k = first; k < last; ++k)
      ranks[order[k]] = 0.5 * static_cast<double>(first + last + 1);
  }
  return ranks;
}

bool varies(const Column& values) {
  return std::any_of(values.begin(), values.end(), [&](double v) { return v != values.front(); });
}

struct Regression {
  std::vector<double> coefficients;
  double r2;
};

// Of ranks of the response, the last column, on those of the others that vary.
Regression regress(const std::vector<Column>& columns) {
  const std::size_t dimension = columns.size() - 1, n = columns.front().size();
  Regression result{std::vector<double>(dimension, 0.0), 0.0};
  std::vector<std::size_t> varying;
  for (std::size_t k = 0; k < dimension; ++k)
    if (varies(columns[k])) varying.push_back(k);
  if (varying.empty()) return result;
  const auto ranks_into = [&](OT::Sample& sample, std::size_t to, const Column& values) {
    const Column ranks = mean_ranks(values);
    for (std::size_t i = 0; i < n; ++i) sample(i, to) = ranks[i];
  };
  OT::Sample inputs(n, varying.size()), response(n, 1);
  for (std::size_t j = 0; j < varying.size(); ++j) ranks_into(inputs, j, columns[varying[j]]);
  ranks_into(response, 0, columns.back());
  const OT::CorrelationAnalysis analysis(inputs, response);
  const OT::Point slopes = analysis.computeSRC(),
                  correlations = analysis.computePearsonCorrelation();
  for (std::size_t j = 0; j < varying.size(); ++j) {
    result.coefficients[varying[j]] = slopes[j];
    result.r2 += slopes[j] * correlations[j];  // of standardised least squares
  }
  return result;
}

// Inputs and the response as columns, of the runs where all are finite.
std::vector<Column> finite_columns(const Points& inputs, std::span<const double> responses) {
  std::vector<Column> columns(inputs.front().size() + 1);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    ensure(inputs[i].size() + 1 == columns.size(), "each run has a value of each input");
    const auto finite = [](double v) { return std::isfinite(v); };
    if (!finite(responses[i]) || !std::all_of(inputs[i].begin(), inputs[i].end(), finite)) continue;
    for (std::size_t k = 0; k < inputs[i].size(); ++k) columns[k].push_back(inputs[i][k]);
    columns.back().push_back(responses[i]);
  }
  return columns;
}

std::vector<Column> resampled(const std::vector<Column>& columns, std::size_t number) {
  const std::size_t n = columns.front().size();
  Random random(0, Purpose::bootstrap, number);
  std::vector<Column> drawn(columns.size(), Column(n));
  for (std::size_t i = 0; i < n; ++i) {
    const auto from = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
    for (std::size_t k = 0; k < columns.size(); ++k) drawn[k][i] = columns[k][from];
  }
  return drawn;
}

// Coefficients of each input over the bootstrap samples whose response varies, sorted.
std::vector<Column> bootstrapped(const std::vector<Column>& columns) {
  std::vector<Column> found(columns.size() - 1);
  for (std::size_t b = 0; b < resamples; ++b) {
    const std::vector<Column> drawn = resampled(columns, b);
    if (!varies(drawn.back())) continue;
    const Regression regression = regress(drawn);
    for (std::size_t k = 0; k < found.size(); ++k) found[k].push_back(regression.coefficients[k]);
  }
  for (Column& column : found) std::sort(column.begin(), column.end());
  return found;
}

}  // namespace

Ranking rank(const Points& inputs, std::span<const double> responses) {
  ensure(inputs.size() == responses.size(), "each run has inputs and a response");
  if (inputs.empty()) return {{}, nan, 0};
  const std::vector<Column> columns = finite_columns(inputs, responses);
  const std::size_t dimension = columns.size() - 1, runs = columns.back().size();
  Ranking ranking{std::vector<Rank>(dimension, {nan, nan, nan}), nan, inputs.size() - runs};
  if (runs < dimension + 2 || !varies(columns.back())) return ranking;
  const Regression regression = regress(columns);
  const std::vector<Column> scatter = bootstrapped(columns);
  ranking.r2 = regression.r2;
  for (std::size_t k = 0; k < dimension; ++k)
    ranking.inputs[k] = {regression.coefficients[k], quantile(scatter[k], 0.05),
                         quantile(scatter[k], 0.95)};
  return ranking;
}

}  // namespace pmr::statistics
