#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"
#include "statistics/surrogate.hpp"

using namespace pmr;
using namespace pmr::statistics;

namespace {

// Branin's function (Dixon & Szego, Towards Global Optimisation 2, 1978) on its box.
const std::vector<Span> branin_box = {{-5.0, 10.0}, {0.0, 15.0}};
double branin(const std::vector<double>& x) {
  const double bend = x[1] - 5.1 / (4.0 * pi * pi) * x[0] * x[0] + 5.0 / pi * x[0] - 6.0;
  return bend * bend + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * std::cos(x[0]) + 10.0;
}

template <class Function>
std::vector<double> responses(const Function& function, const Points& points) {
  std::vector<double> values;
  for (const std::vector<double>& point : points) values.push_back(function(point));
  return values;
}

double noise(Random& random) {  // standard normal, Box and Muller
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * pi * random.uniform());
}

}  // namespace

TEST_CASE("A surrogate runs through exact data and foretells a smooth function between them") {
  const Points runs = sample(Sequence::latin_hypercube, branin_box, 40, 3);
  const std::vector<double> y = responses(branin, runs);
  const Surrogate surrogate(branin_box, runs, y);
  CHECK(surrogate.basis().why_constant.empty());
  CHECK(surrogate.basis().noise == 0.0);
  // Branin goes from 0.4 to 308.
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Prediction there = surrogate.predict(runs[i]);
    CHECK(std::abs(there.mean - y[i]) < 1e-6 * 308.0);
    CHECK(there.deviation < 1e-3 * 308.0);
  }
  // Standard deviation of Branin: 51. Of a tenth of it, left out one at a time, q2 is 0.99.
  const Validation validation = surrogate.validate();
  CHECK(validation.q2 > 0.99);
  CHECK(validation.rmse < 0.1 * 51.0);
  CHECK(validation.observed == y);
  // Branin is smoother than the process: bands are too wide (0.15 to 0.28 for eight designs).
  CHECK(validation.mean_standardised_square > 0.05);
  CHECK(validation.mean_standardised_square < 1.5);

  const Points held_out = sample(Sequence::sobol, branin_box, 200, 0);
  int covered = 0;
  double squares = 0.0;
  for (const std::vector<double>& point : held_out) {
    const Prediction there = surrogate.predict(point);
    const double miss = std::abs(there.mean - branin(point));
    covered += miss <= 2.0 * there.deviation;
    squares += miss * miss;
  }
  // 95 % if Branin were drawn from the process; it is smoother (above), so more.
  CHECK(covered >= 160);
  CHECK(std::sqrt(squares / 200.0) < 0.1 * 51.0);
}

TEST_CASE("A response of a logarithm is straight over a logarithmic span") {
  const std::vector<Span> box = {{1e-3, 1e3, true}};
  const auto decades = [](const std::vector<double>& x) { return std::log10(x[0]); };
  const Points runs = sample(Sequence::sobol, box, 7, 0);
  const Surrogate surrogate(box, runs, responses(decades, runs));
  // Linear in the fraction: a process of the longest scale follows within a thousandth of the span.
  for (const double x : {0.01, 0.7, 50.0})
    CHECK(std::abs(surrogate.predict(std::vector{x}).mean - std::log10(x)) < 6e-3);
}

TEST_CASE("Replicates are averaged and their scatter becomes the noise") {
  const std::vector<Span> box = {{0.0, 1.0}};
  Random random(11, Purpose::test, 0);
  Points runs;
  std::vector<double> y;
  for (int place = 0; place <= 10; ++place)
    for (int replicate = 0; replicate < 6; ++replicate) {
      runs.push_back({0.1 * place});
      y.push_back(2.0 * std::sin(0.3 * place) + 0.5 * noise(random));
    }
  const Surrogate surrogate(box, runs, y);
  CHECK(surrogate.basis().points.size() == 11);
  // Standard deviation of 0.5 from 55 degrees of freedom: +-3 of 0.5 / sqrt(110).
  CHECK(std::abs(surrogate.basis().noise - 0.5) < 3.0 * 0.5 / std::sqrt(110.0));
  // A mean of six scatters by 0.5 / sqrt(6) = 0.2, less with its neighbours; 3 deviations.
  for (int place = 0; place <= 10; ++place) {
    const Prediction there = surrogate.predict(std::vector{0.1 * place});
    CHECK(there.deviation > 0.03);
    CHECK(there.deviation < 0.5 / std::sqrt(6.0));
    CHECK(std::abs(there.mean - 2.0 * std::sin(0.3 * place)) < 3.0 * there.deviation);
  }
  // Each of the eleven means has a sixth of a run's variance, which no surrogate of the mean
  // response can foretell.
  const Validation v = surrogate.validate();
  const double left = 11.0 * std::pow(surrogate.basis().noise, 2) / 6.0;
  const double squares = 11.0 * v.rmse * v.rmse, total = squares / (1.0 - v.q2);
  CHECK(v.q2_of_mean == Approx(1.0 - std::max(0.0, squares - left) / (total - left)).epsilon(1e-9));
  CHECK(v.q2_of_mean > v.q2);
}

TEST_CASE("Of noise alone nothing is foretold, whatever is allowed for it") {
  Random random(6, Purpose::test, 0);
  const std::vector<Span> box = {{0.0, 1.0}};
  Points runs;
  std::vector<double> y;
  for (int place = 0; place <= 12; ++place)
    for (int replicate = 0; replicate < 2; ++replicate) {
      runs.push_back({place / 12.0});
      y.push_back(noise(random));
    }
  CHECK_FALSE(Surrogate(box, runs, y).validate().q2_of_mean > 0.5);
}

TEST_CASE("Too few or equal runs give a constant and say why") {
  const std::vector<Span> box = {{0.0, 1.0}, {0.0, 1.0}};
  const auto constant = [&](const Points& runs, const std::vector<double>& y) {
    return Surrogate(box, runs, y);
  };
  const Surrogate none = constant({{0.1, 0.1}}, {pmr::nan});
  CHECK(none.basis().left_out == 1);
  CHECK(none.basis().why_constant == "no run has a finite response");
  CHECK(std::isnan(none.predict(std::vector{0.5, 0.5}).mean));

  const Surrogate one = constant({{0.1, 0.1}, {0.2, 0.3}}, {7.0, pmr::nan});
  CHECK(one.basis().why_constant == "1 distinct point where 2 variables need 4");
  CHECK(one.predict(std::vector{0.5, 0.5}).mean == 7.0);
  CHECK(std::isnan(one.predict(std::vector{0.5, 0.5}).deviation));
  CHECK(std::isnan(one.validate().rmse));

  const Surrogate two = constant({{0.1, 0.1}, {0.2, 0.3}}, {7.0, 9.0});
  CHECK(two.basis().why_constant == "2 distinct points where 2 variables need 4");
  CHECK(two.predict(std::vector{0.5, 0.5}).mean == 8.0);
  CHECK(two.predict(std::vector{0.5, 0.5}).deviation == Approx(std::sqrt(2.0)));
  CHECK(two.validate().predicted == std::vector{9.0, 7.0});
  CHECK(two.validate().rmse == 2.0);
  CHECK(std::isnan(two.validate().q2));

  const Points runs = sample(Sequence::sobol, box, 8, 0);
  const Surrogate equal = constant(runs, std::vector<double>(8, 0.1));
  CHECK(equal.basis().why_constant == "the responses at all 8 points are equal");
  CHECK(equal.predict(runs[0]).mean == Approx(0.1).epsilon(1e-15));
  CHECK(equal.predict(runs[0]).deviation < 1e-15);
  CHECK(equal.validate().rmse < 1e-15);
  CHECK(std::isnan(equal.validate().q2));
  CHECK(std::isnan(equal.effects().first[0]));
  CHECK(equal.main_effect(1, 0.4).mean == Approx(0.1));
}

TEST_CASE("Runs that gave no number are left out and counted") {
  const Points runs = sample(Sequence::sobol, branin_box, 20, 0);
  std::vector<double> y = responses(branin, runs);
  const Points fewer(runs.begin() + 2, runs.end());
  const Surrogate expected(branin_box, fewer, std::vector<double>(y.begin() + 2, y.end()));
  y[0] = pmr::nan;
  y[1] = std::numeric_limits<double>::infinity();
  const Surrogate surrogate(branin_box, runs, y);
  CHECK(surrogate.basis().left_out == 2);
  CHECK(surrogate.basis().points == fewer);
  CHECK(surrogate.predict(runs[0]).mean == expected.predict(runs[0]).mean);
}

TEST_CASE("A surrogate of an additive function has its shares, no pairs, and its main effects") {
  // f = 3 x + 2 z on the unit cube, u inert: variances 9/12 and 4/12, shares 9/13 and 4/13.
  const std::vector<Span> box = {{0.0, 1.0}, {0.0, 1.0}, {0.0, 1.0}};
  const auto f = [](const std::vector<double>& x) { return 3.0 * x[0] + 2.0 * x[2]; };
  const Points runs = sample(Sequence::latin_hypercube, box, 25, 4);
  const Surrogate surrogate(box, runs, responses(f, runs));
  const Effects effects = surrogate.effects(1024);
  CHECK(effects.first[0] == Approx(9.0 / 13.0).margin(0.02));
  CHECK(effects.first[1] == Approx(0.0).margin(0.02));
  CHECK(effects.total[2] == Approx(4.0 / 13.0).margin(0.02));
  CHECK(effects.pair[0][2] == Approx(0.0).margin(0.02));
  // Averaged over the others: 3 x + 1.
  for (const double x : {0.1, 0.9}) {
    const Prediction effect = surrogate.main_effect(0, x);
    CHECK(effect.mean == Approx(3.0 * x + 1.0).margin(0.02));
    CHECK(effect.deviation > 0.0);
    CHECK(effect.deviation < 0.1);
  }
}
