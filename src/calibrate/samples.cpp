#include "calibrate/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::calibrate {
namespace {

using statistics::Surrogate;

constexpr double least_q2 = 0.8;
constexpr double most_square = 2.5;  // mean standardised [1]
constexpr double harmless = 0.5;     // [1] of the measured deviation: less need not be right
constexpr int expectations = 3;      // [1] of the censored runs

// Mean of a normal variable that is known to lie above a limit.
double mean_above(double limit, const statistics::Prediction& p) {
  if (!(p.deviation > 0.0)) return std::max(limit, p.mean);
  const double a = (limit - p.mean) / p.deviation;
  const double tail = 0.5 * std::erfc(a / std::sqrt(2.0));
  if (tail < 1e-12) return limit;
  return p.mean + p.deviation * std::exp(-0.5 * a * a) / std::sqrt(2.0 * pi) / tail;
}

// Why a surrogate must not be used. It is of the mean response, so noise in the points that it is
// held against is not its fault. Bands that are too narrow matter only where the errors are no
// longer small beside the measured deviation. Bands that are too wide, as those of any smooth
// function without noise (0.05 for x y), make a result wider than it need be, not wrong.
std::string refusal_of(const Target& target, const Surrogate& surrogate,
                       const statistics::Validation& v) {
  if (!surrogate.basis().why_constant.empty()) return surrogate.basis().why_constant;
  if (!(v.q2_of_mean >= least_q2))
    return fmt::format("left-out points are foretold with Q2 = {:.2f} beyond noise, wanted {}",
                       v.q2_of_mean, least_q2);
  const double harm = harmless * measured(target).deviation;
  if (v.mean_standardised_square > most_square && v.rmse > harm)
    return fmt::format("its bands are too narrow: error2 / deviation2 = {:.1f}, wanted at most {}",
                       v.mean_standardised_square, most_square);
  return {};
}

}  // namespace

double transformed(const Target& target, double value) {
  return target.is_logarithmic ? std::log(value) : value;
}

double restored(const Target& target, double value) {
  return target.is_logarithmic ? std::exp(value) : value;
}

statistics::Measured measured(const Target& target) {
  const double unit = target.is_logarithmic ? 1.0 / target.value : 1.0;
  const double deviation = std::hypot(target.error, target.floor, target.discrepancy);
  return {transformed(target, target.value), unit * deviation};
}

Fit fit(const Target& target, const std::vector<Parameter>& parameters,
        const std::vector<Sample>& samples) {
  std::vector<statistics::Span> spans;
  for (const Parameter& p : parameters) spans.push_back(p.box);
  statistics::Points points;
  std::vector<double> values;
  std::vector<std::size_t> hidden;  // censored
  std::size_t lost = 0;
  double low = infinity, high = -low;
  for (const Sample& sample : samples) {
    if (std::isfinite(sample.value)) {
      low = std::min(low, sample.value);
      high = std::max(high, sample.value);
    } else if (sample.is_completed && target.beyond) {
      hidden.push_back(points.size());
    } else {
      ++lost;
      continue;
    }
    points.push_back(sample.point);
    values.push_back(std::isfinite(sample.value) ? transformed(target, sample.value) : nan);
  }
  Surrogate surrogate(spans, points, values);  // of the others: NaN are left out
  for (int k = 0; k < expectations && !hidden.empty(); ++k) {
    for (const std::size_t h : hidden)
      values[h] = mean_above(transformed(target, *target.beyond), surrogate.predict(points[h]));
    surrogate = Surrogate(spans, points, values);
  }
  if (!hidden.empty()) high = infinity;
  const auto validation = surrogate.validate();
  std::string refusal = refusal_of(target, surrogate, validation);
  return {std::move(surrogate), validation, lost, hidden.size(), low, high, std::move(refusal)};
}

bool is_within_reach(double level, const Fit& fit) { return level >= fit.low && level <= fit.high; }

}  // namespace pmr::calibrate
