// Gaussian process regression (Kriging) in scaled variables, with a covariance that is given.
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "statistics/design.hpp"

namespace pmr::statistics {

// Mean and standard deviation of what is expected, in the unit of the response.
struct Prediction {
  double mean;
  double deviation;
};

// Matern covariance of smoothness 5/2: s^2 (1 + r + r^2 / 3) exp(-r), r^2 = 5 sum (x - x')^2 / l^2
// (Rasmussen & Williams, Gaussian Processes for Machine Learning, MIT Press 2006, eq. 4.17).
struct Matern {
  std::vector<double> scale;  // l of each variable, in fractions of its span [1]
  double deviation;           // s [unit of the response]

  double operator()(std::span<const double> a, std::span<const double> b) const;
};

// Added to the covariance of each datum with itself, relative to s^2 [1]: keeps the matrix
// solvable, at the cost of exact data missed by some 1e-6 of their spread at the worst. Ten times
// as much is tried, and again, where it does not do.
inline constexpr double nugget = 1e-12;

// The process given noisy data, with an unknown constant mean (ordinary Kriging; equations:
// Rasmussen & Williams, section 2.7).
class Kriging {
 public:
  // Points [point][variable] apart from each other, their values, and the variances of their noise.
  Kriging(Points points, const std::vector<double>& values, const std::vector<double>& noise,
          Matern covariance);

  double mean(std::span<const double> point) const;
  // Of the response itself: the noise of a new datum is not in the deviation.
  Prediction predict(std::span<const double> point) const;
  // What all the others say of each datum, its noise included, with the same covariance. In closed
  // form (Dubrule, Math. Geol. 15 (1983) 687): y - m = [Q y]_i / Q_ii, deviation^2 = 1 / Q_ii,
  // Q = C^-1 - C^-1 1 1' C^-1 / (1' C^-1 1).
  std::vector<Prediction> left_out() const;

 private:
  Eigen::VectorXd covariances(std::span<const double> point) const;

  Points points_;
  Eigen::VectorXd values_;
  Matern covariance_;
  Eigen::LLT<Eigen::MatrixXd> factor_;  // of C, the covariance of the data with their noise
  Eigen::VectorXd solved_one_;          // C^-1 1
  double trend_;                        // the constant mean
  Eigen::VectorXd weights_;             // C^-1 (y - trend)
};

// The covariance under which the values are most likely, with the constant mean and the noise as in
// Kriging: scales between 0.05 and 20, deviation between 0.01 and 100 (values have mean 0 and
// deviation 1). Likelihood by OpenTURNS, climbed with Powell's BOBYQA (Cambridge report DAMTP
// 2009/NA06) in the logarithms from the best 4 of 32 starts.
Matern likeliest(const Points& points, const std::vector<double>& values,
                 const std::vector<double>& noise);

}  // namespace pmr::statistics
