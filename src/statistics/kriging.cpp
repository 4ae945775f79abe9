#include "statistics/kriging.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/errors.hpp"

namespace pmr::statistics {

double Matern::operator()(std::span<const double> a, std::span<const double> b) const {
  double square = 0.0;
  for (std::size_t k = 0; k < scale.size(); ++k) {
    const double step = (a[k] - b[k]) / scale[k];
    square += 5.0 * step * step;
  }
  const double r = std::sqrt(square);
  return deviation * deviation * (1.0 + r + square / 3.0) * std::exp(-r);
}

Kriging::Kriging(Points points, const std::vector<double>& values, const std::vector<double>& noise,
                 Matern covariance)
    : points_(std::move(points)),
      values_(Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()))),
      covariance_(std::move(covariance)) {
  const Eigen::Index n = values_.size();
  ensure(points_.size() == values.size() && noise.size() == values.size(),
         "each datum of a Kriging has a place, a value and a noise");
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    matrix.col(i) = covariances(points_[static_cast<std::size_t>(i)]);
    matrix(i, i) += noise[static_cast<std::size_t>(i)];
  }
  const double variance = covariance_.deviation * covariance_.deviation;
  double added = nugget;
  do {
    factor_.compute(matrix + added * variance * Eigen::MatrixXd::Identity(n, n));
    added *= 10.0;
  } while (factor_.info() != Eigen::Success && added < 1e-5);
  if (factor_.info() != Eigen::Success)
    throw NumericsError("the covariance of " + std::to_string(n) + " points is not positive");
  solved_one_ = factor_.solve(Eigen::VectorXd::Ones(n));
  trend_ = solved_one_.dot(values_) / solved_one_.sum();
  weights_ = factor_.solve((values_.array() - trend_).matrix());
}

Eigen::VectorXd Kriging::covariances(std::span<const double> point) const {
  Eigen::VectorXd column(values_.size());
  for (Eigen::Index i = 0; i < column.size(); ++i)
    column[i] = covariance_(points_[static_cast<std::size_t>(i)], point);
  return column;
}

double Kriging::mean(std::span<const double> point) const {
  return trend_ + covariances(point).dot(weights_);
}

Prediction Kriging::predict(std::span<const double> point) const {
  const Eigen::VectorXd column = covariances(point);
  const double known = factor_.matrixL().solve(column).squaredNorm();
  const double untold = 1.0 - solved_one_.dot(column);  // for the mean that had to be estimated
  const double variance =
      covariance_.deviation * covariance_.deviation - known + untold * untold / solved_one_.sum();
  return {trend_ + column.dot(weights_), std::sqrt(std::max(variance, 0.0))};
}

std::vector<Prediction> Kriging::left_out() const {
  const Eigen::Index n = values_.size();
  const Eigen::MatrixXd inverse = factor_.solve(Eigen::MatrixXd::Identity(n, n));
  std::vector<Prediction> predictions;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double q = inverse(i, i) - solved_one_[i] * solved_one_[i] / solved_one_.sum();
    predictions.push_back({values_[i] - weights_[i] / q, 1.0 / std::sqrt(q)});  // weights = Q y
  }
  return predictions;
}

}  // namespace pmr::statistics
