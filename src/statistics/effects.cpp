#include "statistics/effects.hpp"

#include <algorithm>
#include <limits>

#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"
#include "statistics/design.hpp"

namespace pmr::statistics {
namespace {

using Values = std::vector<double>;

// Pairs of independent points and the function's values on mixtures of them.
class Pairs {
 public:
  Pairs(const UnitFunction& response, std::size_t dimension, std::size_t count)
      : response_(response),
        dimension_(dimension),
        points_(
            sample(Sequence::sobol, std::vector<Span>(2 * dimension, Span{0.0, 1.0}), count, 0)) {}

  // f(a_u) for the variables u.
  Values mixed(std::span<const std::size_t> from_b) const {
    Values values(points_.size());
    parallel_for(
        points_.size(),
        [&](std::size_t i) {
          const auto b = points_[i].begin() + static_cast<std::ptrdiff_t>(dimension_);
          std::vector<double> point(points_[i].begin(), b);
          for (const std::size_t k : from_b) point[k] = b[static_cast<std::ptrdiff_t>(k)];
          values[i] = response_(point);
        },
        64);
    return values;
  }

 private:
  const UnitFunction& response_;
  std::size_t dimension_;
  Points points_;
};

double sum(const Values& values) {
  double total = 0.0;
  for (const double v : values) total += v;
  return total;
}

// Values on the points a and b, their common mean and variance.
struct Ends {
  Values a, b;
  double mean, variance;
};

Ends ends_of(const Pairs& pairs, std::size_t dimension) {
  std::vector<std::size_t> all(dimension);
  for (std::size_t k = 0; k < dimension; ++k) all[k] = k;
  Ends ends{pairs.mixed({}), pairs.mixed(all), 0.0, 0.0};
  const double n = 2.0 * static_cast<double>(ends.a.size());
  ends.mean = (sum(ends.a) + sum(ends.b)) / n;
  for (const Values* values : {&ends.a, &ends.b})
    for (const double v : *values) ends.variance += (v - ends.mean) * (v - ends.mean) / n;
  return ends;
}

// Taking the mean off f(b) changes nothing in the limit and much in the scatter.
double closed_index(const Ends& ends, const Values& mixed) {
  double covariance = 0.0;
  for (std::size_t i = 0; i < mixed.size(); ++i)
    covariance += (ends.b[i] - ends.mean) * (mixed[i] - ends.a[i]);
  return covariance / static_cast<double>(mixed.size()) / ends.variance;
}

double total_index(const Ends& ends, const Values& mixed) {
  double squares = 0.0;
  for (std::size_t i = 0; i < mixed.size(); ++i)
    squares += (ends.a[i] - mixed[i]) * (ends.a[i] - mixed[i]);
  return squares / (2.0 * static_cast<double>(mixed.size())) / ends.variance;
}

}  // namespace

Effects sobol_indices(const UnitFunction& response, std::size_t dimension, std::size_t count) {
  ensure(dimension > 0 && count > 1, "Sobol' indices have variables and points");
  const Values none(dimension, std::numeric_limits<double>::quiet_NaN());
  Effects effects{none, none, std::vector<Values>(dimension, none)};
  const Pairs pairs(response, dimension, count);
  const Ends ends = ends_of(pairs, dimension);
  // Rounding alone gives a variance of some 1e-32 of the mean squared.
  if (!(ends.variance > 1e-26 * ends.mean * ends.mean)) return effects;
  for (std::size_t i = 0; i < dimension; ++i) {
    const Values mixed = pairs.mixed(std::vector{i});
    effects.first[i] = closed_index(ends, mixed);
    effects.total[i] = total_index(ends, mixed);
    effects.pair[i][i] = 0.0;
    for (std::size_t j = 0; j < i; ++j) {
      const double closed = closed_index(ends, pairs.mixed(std::vector{i, j}));
      effects.pair[i][j] = effects.pair[j][i] = closed - effects.first[i] - effects.first[j];
    }
  }
  return effects;
}

}  // namespace pmr::statistics
