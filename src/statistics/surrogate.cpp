#include "statistics/surrogate.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "statistics/band.hpp"

namespace pmr::statistics {
namespace {

constexpr double same_point = 1e-9;  // of the spans [1]

// Runs at one point.
struct Group {
  std::vector<double> fractions;
  std::vector<double> point;
  std::vector<double> responses;
};

bool is_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool is_same(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::abs(x - y) <= same_point; });
}

// Variance of one run, pooled over the groups; 0 without replicates [response^2].
double pooled_variance(const std::vector<Group>& groups) {
  double squares = 0.0, freedom = 0.0;
  for (const Group& group : groups) {
    const Band spread = band(group.responses);
    if (spread.count < 2) continue;
    const auto n = static_cast<double>(spread.count - 1);
    squares += n * spread.deviation * spread.deviation;
    freedom += n;
  }
  return freedom > 0.0 ? squares / freedom : 0.0;
}

std::string why_constant(std::size_t points, std::size_t dimension, const Band& values) {
  const auto counted = [](std::size_t n, const char* noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
  };
  if (points == 0) return "no run has a finite response";
  if (points < dimension + 2)
    return counted(points, "distinct point") + " where " + counted(dimension, "variable") +
           " need" + (dimension == 1 ? "s " : " ") + std::to_string(dimension + 2);
  // Differences of rounding say nothing.
  if (values.deviation <= 1e-12 * std::abs(values.mean))
    return "the responses at all " + std::to_string(points) + " points are equal";
  return {};
}

Validation scored(Validation leave_one_out, double spread, double noise) {
  Validation& v = leave_one_out;
  const auto n = static_cast<double>(v.observed.size());
  double squares = 0.0, standardised = 0.0;
  for (std::size_t i = 0; i < v.observed.size(); ++i) {
    const double miss = v.observed[i] - v.predicted[i];
    squares += miss * miss;
    standardised += miss * miss / (v.deviation[i] * v.deviation[i]);
  }
  const double total = (n - 1.0) * spread * spread;
  v.q2 = 1.0 - squares / total;
  v.q2_of_mean = total > noise ? 1.0 - std::max(0.0, squares - noise) / (total - noise) : nan;
  v.rmse = std::sqrt(squares / n);
  v.mean_standardised_square = standardised / n;
  return v;
}

}  // namespace

Surrogate::Surrogate(std::vector<Span> spans, const Points& points,
                     std::span<const double> responses)
    : spans_(std::move(spans)), basis_{{}, 0, 0.0, {}, {}} {
  ensure(points.size() == responses.size(), "each run has a point and a response");
  std::vector<Group> groups;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<double> place = fractions(points[i]);
    if (!std::isfinite(responses[i]) || !is_finite(place)) {
      ++basis_.left_out;
      continue;
    }
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& g) { return is_same(g.fractions, place); });
    if (group == groups.end()) group = groups.insert(group, {place, points[i], {}});
    group->responses.push_back(responses[i]);
  }
  for (const Group& group : groups) {
    basis_.points.push_back(group.point);
    values_.push_back(band(group.responses).mean);
  }
  const Band all = band(values_);
  centre_ = all.mean;
  spread_ = all.deviation;
  const double variance = pooled_variance(groups);
  basis_.noise = std::sqrt(variance);
  basis_.why_constant = why_constant(groups.size(), spans_.size(), all);
  if (!basis_.why_constant.empty()) return;

  Points places;
  std::vector<double> standardised, noise;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    places.push_back(groups[i].fractions);
    standardised.push_back((values_[i] - centre_) / spread_);
    const auto runs = static_cast<double>(groups[i].responses.size());
    noise.push_back(variance / (runs * spread_ * spread_));
    noise_left_ += variance / runs;
  }
  const Matern covariance = likeliest(places, standardised, noise);
  basis_.scale = covariance.scale;
  kriging_.emplace(std::move(places), standardised, noise, covariance);
}

std::vector<double> Surrogate::fractions(std::span<const double> point) const {
  ensure(point.size() == spans_.size(), "a point has a value of each variable");
  std::vector<double> result(point.size());
  for (std::size_t k = 0; k < point.size(); ++k) result[k] = fraction_at(spans_[k], point[k]);
  return result;
}

Prediction Surrogate::predict_scaled(std::span<const double> fractions) const {
  if (!kriging_) return {centre_, spread_};
  const Prediction standardised = kriging_->predict(fractions);
  return {centre_ + spread_ * standardised.mean, spread_ * standardised.deviation};
}

Prediction Surrogate::predict(std::span<const double> point) const {
  return predict_scaled(fractions(point));
}

Validation Surrogate::validate() const {
  Validation result{nan, nan, nan, nan, values_, {}, {}};
  if (kriging_) {
    for (const Prediction& other : kriging_->left_out()) {
      result.predicted.push_back(centre_ + spread_ * other.mean);
      result.deviation.push_back(spread_ * other.deviation);
    }
    return scored(std::move(result), spread_, noise_left_);
  }
  // A constant: the mean of the others, and no claim.
  const auto n = static_cast<double>(values_.size());
  double squares = 0.0;
  for (const double value : values_) {
    const double others = n > 1.0 ? (n * centre_ - value) / (n - 1.0) : nan;
    result.predicted.push_back(others);
    result.deviation.push_back(nan);
    squares += (value - others) * (value - others);
  }
  result.rmse = std::sqrt(squares / n);
  return result;
}

Effects Surrogate::effects(std::size_t count) const {
  // Shares of a variance do not depend on centre and spread.
  return sobol_indices(
      [this](std::span<const double> fractions) {
        return kriging_ ? kriging_->mean(fractions) : 1.0;
      },
      spans_.size(), count);
}

Prediction Surrogate::main_effect(std::size_t variable, double value) const {
  ensure(variable < spans_.size(), "a main effect is of a variable");
  constexpr std::size_t count = 256;
  Prediction sum{0.0, 0.0};
  const std::vector<Span> cube(spans_.size(), Span{0.0, 1.0});
  for (std::vector<double>& point : sample(Sequence::sobol, cube, count, 0)) {
    point[variable] = fraction_at(spans_[variable], value);
    const Prediction one = predict_scaled(point);
    sum = {sum.mean + one.mean, sum.deviation + one.deviation};
  }
  return {sum.mean / count, sum.deviation / count};
}

}  // namespace pmr::statistics
