#include <catch2/catch.hpp>
#include <cmath>

#include "calibrate/run_table.hpp"
#include "calibrate/samples.hpp"
#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"

using namespace pmr;
using namespace pmr::calibrate;

namespace {

std::vector<Parameter> one_parameter() {
  Parameter p;
  p.name = "x";
  p.box = {0.0, 1.0};
  return {p};
}

Target of_value(double value, double error) {
  Target target;
  target.value = value;
  target.error = error;
  return target;
}

}  // namespace

TEST_CASE("Measurement, floor and discrepancy add up in squares, relative on a logarithmic scale") {
  Target target = of_value(10.0, 0.3);
  target.floor = 0.4;
  target.discrepancy = 1.2;
  CHECK(measured(target).deviation == Approx(1.3));
  CHECK(measured(target).level == 10.0);
  target.is_logarithmic = true;
  CHECK(measured(target).deviation == Approx(0.13));
  CHECK(measured(target).level == Approx(std::log(10.0)));
}

TEST_CASE("A run that ended before its figure counts as above the limit; a failed one not at all") {
  // y = 10 x, seen up to 6.
  Target target = of_value(3.0, 0.1);
  target.beyond = 6.0;
  std::vector<Sample> samples;
  for (int k = 0; k <= 10; ++k) {
    const double x = 0.1 * k, y = 10.0 * x;
    samples.push_back({{x}, k <= 6 ? y : pmr::nan, true});
  }
  samples.push_back({{0.55}, pmr::nan, false});
  const Fit seen = fit(target, one_parameter(), samples);
  CHECK(seen.censored == 4);
  CHECK(seen.lost == 1);
  CHECK(seen.refusal.empty());
  for (const double x : {0.7, 0.9, 1.0}) CHECK(seen.surrogate.predict(std::vector{x}).mean > 6.0);
  CHECK(seen.surrogate.predict(std::vector{0.3}).mean == Approx(3.0).margin(0.05));
  CHECK(is_within_reach(20.0, seen));
  target.beyond.reset();
  const Fit blind = fit(target, one_parameter(), samples);
  CHECK(blind.lost == 5);
  CHECK_FALSE(is_within_reach(7.0, blind));
}

TEST_CASE("A surrogate that left-out runs contradict is refused") {
  const Target target = of_value(0.5, 0.01);
  std::vector<Sample> rough, smooth;
  for (int k = 0; k <= 12; ++k) {
    const double x = k / 12.0;
    rough.push_back({{x}, k % 2 == 0 ? 0.0 : 1.0, true});
    smooth.push_back({{x}, x * x, true});
  }
  CHECK_THAT(fit(target, one_parameter(), rough).refusal, Catch::Contains("Q2"));
  CHECK(fit(target, one_parameter(), smooth).refusal.empty());
  CHECK_THAT(fit(target, one_parameter(), {smooth[0], smooth[1]}).refusal,
             Catch::Contains("2 distinct points"));
}

TEST_CASE("A table of runs is read as it was written, and its faults are told by line") {
  const auto file = std::filesystem::temp_directory_path() / "pmr-run-table.csv";
  const std::vector<TableRow> rows{
      {"a", "0123456789abcdef", "completed", "y", 0.1 + 0.2, ""},
      {"b", "0123456789abcdee", "failed", "y", pmr::nan, "it said, \"no\""}};
  write_run_table(file, rows);
  const auto read = read_run_table(file);
  REQUIRE(read.size() == 2);
  CHECK(read[0].value == 0.1 + 0.2);
  CHECK(std::isnan(read[1].value));
  CHECK(read[1].reason == "it said   no");
  io::replace_text(file, io::read_text(file) + "c,0,done,y,wide,\n");
  try {
    read_run_table(file);
    CHECK(false);
  } catch (const CaseError& error) {
    CHECK(error.faults().size() == 2);
    CHECK_THAT(error.what(), Catch::Contains("pmr-run-table.csv:4"));
  }
  std::filesystem::remove(file);
}
