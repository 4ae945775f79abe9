#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"
#include "statistics/band.hpp"
#include "statistics/ranking.hpp"

using namespace pmr;
using namespace pmr::statistics;

namespace {

// Independent standard normal inputs (Box and Muller).
Points normal_inputs(std::size_t runs, std::size_t dimension) {
  Random random(3, Purpose::test, 0);
  Points inputs(runs, std::vector<double>(dimension));
  for (std::vector<double>& run : inputs)
    for (double& x : run) {
      const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
      x = radius * std::cos(2.0 * pi * random.uniform());
    }
  return inputs;
}

}  // namespace

TEST_CASE("Rank coefficients of a linear response to normal inputs are the known ones") {
  // Independent inputs: the coefficient is the rank correlation, which for normal variables of
  // correlation c is 6/pi asin(c/2) (Pearson 1907); here c = 3, -2, 0 over sqrt(13).
  const std::size_t runs = 1000;
  const Points inputs = normal_inputs(runs, 3);
  std::vector<double> y;
  for (const std::vector<double>& x : inputs) y.push_back(5.0 + 3.0 * x[0] - 2.0 * x[1]);
  const Ranking ranking = rank(inputs, y);
  const double share[3] = {3.0 / std::sqrt(13.0), -2.0 / std::sqrt(13.0), 0.0};
  double r2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double known = 6.0 / pi * std::asin(0.5 * share[k]);
    r2 += known * known;
    const Rank& found = ranking.inputs[k];
    // Residual variance of the ranks is below 0.1: scatter sqrt(0.1 / 1000) = 0.01, thrice.
    CHECK(found.coefficient == Approx(known).margin(0.03));
    CHECK(found.low < found.coefficient);
    CHECK(found.high > found.coefficient);
    CHECK(found.high - found.low < 0.06);
  }
  CHECK(ranking.r2 == Approx(r2).margin(0.02));
  CHECK(ranking.left_out == 0);
}

TEST_CASE("Ranks follow any rising response and not the inputs that have no part in it") {
  const Points inputs = normal_inputs(60, 2);
  std::vector<double> y;
  for (const std::vector<double>& x : inputs) y.push_back(-std::exp(3.0 * x[1]));
  const Ranking ranking = rank(inputs, y);
  CHECK(ranking.r2 == Approx(1.0));
  CHECK(ranking.inputs[0].coefficient == Approx(0.0).margin(1e-12));
  CHECK(ranking.inputs[1].coefficient == Approx(-1.0));
  CHECK(ranking.inputs[1].low == Approx(-1.0));
  // The same on every call.
  const Ranking again = rank(inputs, y);
  CHECK(again.inputs[1].high == ranking.inputs[1].high);
}

TEST_CASE("A response that is not monotone warns with a small r2") {
  const Points inputs = normal_inputs(300, 1);
  std::vector<double> y;
  for (const std::vector<double>& x : inputs) y.push_back(x[0] * x[0]);
  CHECK(rank(inputs, y).r2 < 0.05);
}

TEST_CASE("Inputs that do not vary have no part, equal values share their rank, and NaN are out") {
  Points inputs = {{1, 5}, {1, 5}, {2, 5}, {2, 5}, {3, 5}, {4, 5}, {pmr::nan, 5}, {1, 5}};
  const std::vector<double> y = {10, 10, 20, 20, 30, 40, 50, pmr::nan};
  const Ranking ranking = rank(inputs, y);
  CHECK(ranking.left_out == 2);
  CHECK(ranking.inputs[0].coefficient == Approx(1.0));
  CHECK(ranking.inputs[1].coefficient == 0.0);
  CHECK(ranking.inputs[1].high == 0.0);
}

TEST_CASE("Too few runs, or a response that does not vary, have no ranking") {
  const Points inputs = normal_inputs(10, 2);
  const Ranking flat = rank(inputs, std::vector<double>(10, 4.0));
  CHECK(std::isnan(flat.r2));
  CHECK(std::isnan(flat.inputs[1].low));
  const Points few(inputs.begin(), inputs.begin() + 3);
  CHECK(std::isnan(rank(few, std::vector{1.0, 2.0, 3.0}).inputs[0].coefficient));
  CHECK(rank({}, {}).inputs.empty());
}

TEST_CASE("Quantiles are those of type 7") {
  // By hand: place (n - 1) p = 0.15, 1.5, 2.85 between the sorted 1, 2, 4, 8; squares sum to 85.
  const Band four = band(std::vector{8.0, pmr::nan, 1.0, 4.0, 2.0});
  CHECK(four.count == 4);
  CHECK(four.p5 == Approx(1.15));
  CHECK(four.p50 == 3.0);
  CHECK(four.p95 == Approx(7.4));
  CHECK(four.mean == 3.75);
  CHECK(four.deviation == Approx(std::sqrt((85.0 - 4.0 * 3.75 * 3.75) / 3.0)));
  const Band one = band(std::vector{6.0});
  CHECK(one.p5 == 6.0);
  CHECK(one.p95 == 6.0);
  CHECK(std::isnan(one.deviation));
  const Band none = band(std::vector{pmr::nan});
  CHECK(none.count == 0);
  CHECK(std::isnan(none.p50));
  CHECK(std::isnan(none.mean));
}
