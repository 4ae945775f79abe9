#include <catch2/catch.hpp>
#include <cmath>

#include "statistics/kriging.hpp"

using namespace pmr::statistics;

namespace {

const std::vector<Span> square = {{0.0, 1.0}, {0.0, 1.0}};
const Matern covariance{{0.4, 0.9}, 1.7};

Points places(std::size_t count) { return sample(Sequence::sobol, square, count, 0); }

std::vector<double> values_at(const Points& points) {
  std::vector<double> values;
  for (const std::vector<double>& p : points)
    values.push_back(std::sin(5.0 * p[0]) + p[0] * p[1] * p[1]);
  return values;
}

Kriging without(Points points, std::vector<double> values, std::vector<double> noise,
                std::size_t left_out) {
  const auto at = static_cast<std::ptrdiff_t>(left_out);
  points.erase(points.begin() + at);
  values.erase(values.begin() + at);
  noise.erase(noise.begin() + at);
  return Kriging(points, values, noise, covariance);
}

}  // namespace

TEST_CASE("Matern's covariance of smoothness 5/2 has its known value and falls with distance") {
  // r = sqrt(5) at one scale apart: s^2 (1 + sqrt(5) + 5/3) exp(-sqrt(5)).
  const double at_scale =
      1.7 * 1.7 * (1.0 + std::sqrt(5.0) + 5.0 / 3.0) * std::exp(-std::sqrt(5.0));
  CHECK(covariance(std::vector{0.1, 0.1}, std::vector{0.5, 0.1}) == Approx(at_scale));
  CHECK(covariance(std::vector{0.1, 0.1}, std::vector{0.1, 1.0}) == Approx(at_scale));
  CHECK(covariance(std::vector{0.1, 0.1}, std::vector{0.1, 0.1}) == Approx(1.7 * 1.7));
}

TEST_CASE("What the others say of each datum is the same in closed form and computed without it") {
  // Brute force: the datum taken out, the same covariance; its deviation has the datum's own noise
  // and nugget added. Both solve systems of condition below 1e5 here: 1e-9 is ample.
  const Points points = places(9);
  const std::vector<double> values = values_at(points);
  std::vector<double> noise(points.size(), 0.0);
  noise[2] = 0.3;
  noise[5] = 0.01;
  const std::vector<Prediction> closed = Kriging(points, values, noise, covariance).left_out();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Prediction brute = without(points, values, noise, i).predict(points[i]);
    CHECK(closed[i].mean == Approx(brute.mean).epsilon(1e-9));
    const double own = noise[i] + nugget * 1.7 * 1.7;
    CHECK(closed[i].deviation ==
          Approx(std::sqrt(brute.deviation * brute.deviation + own)).epsilon(1e-9));
  }
}

TEST_CASE("Kriging of one datum with all its noise is that datum everywhere") {
  // Ordinary Kriging of one datum: mean y, variance s^2 - k^2/C + (1 - k/C)^2 C = s^2 + C - 2 k.
  const Kriging one({{0.2, 0.2}}, {4.0}, {0.5}, covariance);
  const std::vector<double> far = {0.9, 0.1};
  const double c = 1.7 * 1.7 + 0.5, k = covariance(std::vector{0.2, 0.2}, far);
  CHECK(one.predict(far).mean == Approx(4.0));
  CHECK(one.predict(far).deviation == Approx(std::sqrt(1.7 * 1.7 + c - 2.0 * k)));
}

TEST_CASE("A noisy datum is followed less than an exact one") {
  const Points points = places(9);
  const std::vector<double> values = values_at(points);
  std::vector<double> noise(points.size(), 0.0);
  const double exact = Kriging(points, values, noise, covariance).predict(points[4]).deviation;
  noise[4] = 1.0;
  const Prediction noisy = Kriging(points, values, noise, covariance).predict(points[4]);
  CHECK(exact < 1e-4);
  CHECK(noisy.deviation > 0.05);
  CHECK(std::abs(noisy.mean - values[4]) > 1e-3);
}

TEST_CASE("The likeliest covariance tells a variable that matters from one that does not") {
  const Points points = places(30);
  std::vector<double> values;
  double squares = 0.0;
  for (const std::vector<double>& p : points) {
    values.push_back(std::sin(6.283185307179586 * p[0]));
    squares += values.back() * values.back();
  }
  for (double& value : values) value /= std::sqrt(squares / 30.0);
  const Matern found = likeliest(points, values, std::vector<double>(30, 0.0));
  CHECK(found.scale[0] < 2.0);
  CHECK(found.scale[1] == Approx(20.0).epsilon(1e-3));  // at the bound
}
