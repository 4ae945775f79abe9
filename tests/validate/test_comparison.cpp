// Computed against measured: figures by hand.
#include <catch2/catch.hpp>
#include <cmath>

#include "pmr/base/errors.hpp"
#include "validate/comparison.hpp"

using namespace pmr;
using namespace pmr::validate;

namespace {

// Three points at x = 1, 2, 4 with measured values 10, 20, 40 and a deviation of 2; one figure y.
Experiment three_points() {
  Experiment e;
  e.points.columns = {{"x", "1", {1.0, 2.0, 4.0}}, {"m", "K", {10.0, 20.0, 40.0}}};
  e.points.rows = 3;
  e.axis.value = "x";
  Figure y;
  y.name = "y";
  y.key = "y";
  e.figures = {y};
  return e;
}

Quantity y_against_m(Bar bar) {
  Quantity q;
  q.computed = "y";
  q.measured = "m";
  q.deviation = "2";
  q.bar = bar;
  return q;
}

Bar bar_of(Bar::Kind kind, double most) {
  Bar bar;
  bar.kind = kind;
  bar.most = most;
  return bar;
}

Readings of(const std::vector<std::vector<double>>& seeds_of_points) {
  Readings readings;
  for (const auto& seeds : seeds_of_points) {
    readings.emplace_back();
    for (const double y : seeds) readings.back().push_back({"completed", "", {y}});
  }
  return readings;
}

}  // namespace

TEST_CASE("Misses, their mean, rms and largest, in the unit and in deviations") {
  const Readings readings = of({{11.0}, {18.0}, {44.0}});  // misses 1, -2, 4
  const Comparison c =
      held_against(three_points(), y_against_m(bar_of(Bar::Kind::largest, 4.0)), readings);
  CHECK(c.judged == 3);
  CHECK(c.mean == Approx(1.0));
  CHECK(c.rms == Approx(std::sqrt(21.0 / 3.0)));
  CHECK(c.largest == Approx(4.0));
  CHECK(c.relative == Approx(0.1));
  CHECK(c.rms_in_deviations == Approx(std::sqrt(21.0 / 3.0) / 2.0));
  CHECK(c.verdict == Verdict::held);
  const auto verdict = [&](Bar::Kind kind, double most) {
    return held_against(three_points(), y_against_m(bar_of(kind, most)), readings).verdict;
  };
  CHECK(verdict(Bar::Kind::largest, 3.9) == Verdict::missed);
  CHECK(verdict(Bar::Kind::rms, 2.65) == Verdict::held);
  CHECK(verdict(Bar::Kind::rms, 2.64) == Verdict::missed);
  CHECK(verdict(Bar::Kind::relative, 0.1001) == Verdict::held);
  CHECK(verdict(Bar::Kind::relative, 0.0999) == Verdict::missed);
  CHECK(verdict(Bar::Kind::none, 0.0) == Verdict::shown);
}

TEST_CASE("A bar judges its part of the axis alone") {
  Bar bar = bar_of(Bar::Kind::largest, 2.5);
  bar.to = 2.0;
  const Comparison c = held_against(three_points(), y_against_m(bar), of({{11.0}, {18.0}, {99.0}}));
  CHECK(c.judged == 2);
  CHECK(c.verdict == Verdict::held);
  CHECK(c.points[2].miss() == Approx(59.0));
}

TEST_CASE("The seeds' standard error counts beside the measured deviation") {
  const Comparison c = held_against(three_points(), y_against_m(bar_of(Bar::Kind::rms, 1.0)),
                                    of({{9.0, 13.0}, {20.0, 20.0}, {40.0, 40.0}}));
  CHECK(c.points[0].computed == Approx(11.0));
  CHECK(c.points[0].error == Approx(2.0));  // sqrt(8) / sqrt(2)
  CHECK(c.points[0].miss_in_deviations() == Approx(1.0 / std::sqrt(8.0)));
}

TEST_CASE("A free zero takes the mean miss off, and tells it") {
  Quantity q = y_against_m(bar_of(Bar::Kind::largest, 1.01));
  q.has_free_zero = true;
  const Comparison c = held_against(three_points(), q, of({{110.0}, {121.0}, {139.0}}));
  CHECK(c.zero == Approx(100.0));
  CHECK(c.mean == Approx(0.0).margin(1e-12));
  CHECK(c.largest == Approx(1.0));
  CHECK(c.verdict == Verdict::held);
}

TEST_CASE("A point without its run, or without a figure, leaves the comparison without verdict") {
  Readings readings = of({{11.0}, {18.0}, {44.0}});
  const auto verdict = [&] {
    return held_against(three_points(), y_against_m(bar_of(Bar::Kind::largest, 4.0)), readings)
        .verdict;
  };
  readings[1][0].status = "failed";
  CHECK(verdict() == Verdict::not_run);
  readings[1][0] = {"completed", "", {std::nan("")}};
  CHECK(verdict() == Verdict::not_run);
  readings[1][0] = {"completed", "", {18.0}};
  CHECK(verdict() == Verdict::held);
}

TEST_CASE("The slope of a power law, with its error, against its bar") {
  Slope slope{"n", "exponent", "log(x)", "log(y)", 2.5, 0.05, 0.1, ""};
  const auto power = [](double n) {
    return of({{3.0}, {3.0 * std::pow(2.0, n)}, {3.0 * std::pow(4.0, n)}});
  };
  const SlopeFound exact = slope_through(three_points(), slope, power(2.45));
  CHECK(exact.value == Approx(2.45));
  CHECK(exact.error == Approx(0.0).margin(1e-9));
  CHECK(exact.verdict == Verdict::held);
  CHECK(slope_through(three_points(), slope, power(2.39)).verdict == Verdict::missed);
  // y = x + (0, 1, 0): slope 13/14 by hand, s^2 of the rest = 9/14, error sqrt(9/14 / (14/3)).
  slope.x = "x";
  slope.y = "y";
  const SlopeFound bent = slope_through(three_points(), slope, of({{1.0}, {3.0}, {4.0}}));
  CHECK(bent.value == Approx(13.0 / 14.0));
  CHECK(bent.error == Approx(std::sqrt(9.0 / 14.0 / (14.0 / 3.0))));
}

TEST_CASE("An expression without a value is told with its point") {
  Quantity q = y_against_m({});
  q.computed = "log(y)";
  CHECK_THROWS_AS(held_against(three_points(), q, of({{1.0}, {-1.0}, {1.0}})), CaseError);
}
