// One response of a simulation, foretold between the points where it was run.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "statistics/design.hpp"
#include "statistics/effects.hpp"
#include "statistics/kriging.hpp"

namespace pmr::statistics {

// How well each design point is foretold from all the others, with the covariance of all (the trend
// is estimated anew): values of points with replicates are their means.
struct Validation {
  double q2;  // 1 - sum (y - y_loo)^2 / sum (y - mean)^2 [1]; 1 is perfect, NaN for a constant
  // The same of the mean response: both sums less the variances that the runs' noise leaves in the
  // points' values. NaN where noise is all there is.
  double q2_of_mean;
  double rmse;                      // root mean square of y - y_loo [unit of the response]
  double mean_standardised_square;  // mean ((y - y_loo) / deviation)^2 [1]; near 1 for honest bands
  std::vector<double> observed, predicted, deviation;  // at each point [unit of the response]
};

// What the surrogate rests on.
struct Basis {
  Points points;              // distinct, in the order they first came, in the variables' units
  std::size_t left_out;       // runs whose response was no finite number
  double noise;               // standard deviation of one run by replicates, 0 without [response]
  std::vector<double> scale;  // correlation lengths, fractions of the spans [1]; {} for a constant
  std::string why_constant;   // reason why the surrogate is a constant, empty when it is none
};

// Kriging of one response with a constant trend and a Matern 5/2 covariance, one scale to each
// variable; variables as fractions of their spans. Runs at the same point (1e-9 of the spans) are
// replicates: their mean enters, and the variance pooled over all such points is the variance of
// one run anywhere (one of n runs: divided by n). Without replicates data are taken as exact. Fewer
// than d + 2 distinct points, or equal responses, give a constant and why.
class Surrogate {
 public:
  // A row of `points` and a response to each run; those that are not finite are left out.
  Surrogate(std::vector<Span> spans, const Points& points, std::span<const double> responses);

  const Basis& basis() const { return basis_; }
  // The response without the noise of a run. A constant: mean and deviation of the points' values,
  // NaN where there are too few to tell.
  Prediction predict(std::span<const double> point) const;
  Validation validate() const;
  // Sobol' indices of the predicted mean over the box, evenly spread (logarithmic: by logarithm).
  Effects effects(std::size_t count = 4096) const;
  // Mean and deviation at a value of one variable, averaged over 256 points of all others.
  Prediction main_effect(std::size_t variable, double value) const;

 private:
  std::vector<double> fractions(std::span<const double> point) const;
  Prediction predict_scaled(std::span<const double> fractions) const;

  std::vector<Span> spans_;
  Basis basis_;
  std::vector<double> values_;      // at the distinct points [unit of the response]
  double noise_left_ = 0.0;         // sum of the values' variances by noise [response^2]
  double centre_, spread_;          // mean and standard deviation of values_
  std::optional<Kriging> kriging_;  // of (values - centre) / spread
};

}  // namespace pmr::statistics
