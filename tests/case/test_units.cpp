#include <catch2/catch.hpp>

#include "case/nearest.hpp"
#include "case/units.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr::casefile;

namespace {
double si(const char* text, Dimension dimension) {
  static const Units units;
  const Quantities read = units.parse(text, dimension);
  INFO(text << ": " << read.problem);
  REQUIRE(read.values.size() == 1);
  return read.values[0];
}
std::string problem(const char* text, Dimension dimension) {
  const Units units;
  return units.parse(text, dimension).problem;
}
}  // namespace

TEST_CASE("units convert to SI by their definitions") {
  CHECK(si("1100 degC", Dimension::temperature) == Approx(1373.15).epsilon(1e-15));
  CHECK(si("43 deg", Dimension::angle) == Approx(43 * 3.14159265358979323846 / 180).epsilon(1e-14));
  CHECK(si("125 ms", Dimension::time) == Approx(0.125).epsilon(1e-15));
  CHECK(si("5 MPa", Dimension::pressure) == Approx(5e6).epsilon(1e-15));
  CHECK(si("1 atm", Dimension::pressure) == Approx(101325).epsilon(1e-15));
  CHECK(si("2.99mm", Dimension::length) == Approx(2.99e-3).epsilon(1e-15));
  CHECK(si("36 l", Dimension::volume) == Approx(0.036).epsilon(1e-15));
  CHECK(si("1.1 W/m/K", Dimension::conductivity) == Approx(1.1).epsilon(1e-15));
  CHECK(si("191.462 g/mol", Dimension::molar_mass) == Approx(0.191462).epsilon(1e-15));
  CHECK(si("0.002 1/K", Dimension::per_temperature) == Approx(0.002).epsilon(1e-15));
  CHECK(si("30 min", Dimension::time) == Approx(1800).epsilon(1e-15));
  CHECK(si("60 rpm", Dimension::spin) == Approx(2 * 3.14159265358979323846).epsilon(1e-14));
}

TEST_CASE("several numbers share one unit") {
  const Units units;
  const Quantities read = units.parse("0 -1e1 +10 mm", Dimension::length);
  REQUIRE(read.values.size() == 3);
  CHECK(read.values[1] == Approx(-0.01));
}

TEST_CASE("a scale with an offset is no temperature difference") {
  CHECK_THAT(problem("5 degC", Dimension::temperature_difference), Catch::Contains("offset"));
  CHECK(si("5 K", Dimension::temperature_difference) == 5.0);
}

TEST_CASE("turns and radians are told apart by the unit") {
  constexpr double turn = 2 * pmr::pi;
  for (const char* text : {"20 rpm", "20 min-1", "20 1/min", "0.3333333333333333 Hz", "120 deg/s",
                           "0.3333333333333333 turn/s", "2.0943951023931953 rad/s"})
    CHECK(si(text, Dimension::rotation_rate) == Approx(turn / 3).epsilon(1e-14));
  for (const char* text : {"50 Hz", "3000 rpm", "50 rps", "3000 1/min", "314.1592653589793 rad/s"})
    CHECK(si(text, Dimension::frequency) == Approx(50).epsilon(1e-14));
  CHECK(si("10 rad/s", Dimension::spin) == 10.0);
  CHECK_THAT(problem("10 1/s", Dimension::spin),
             Catch::Contains("is a frequency; wanted an angular"));
  CHECK(si("2000 Hz", Dimension::event_rate) == 2000.0);
  CHECK_THAT(problem("20 rpm", Dimension::event_rate), Catch::Contains("is an angular velocity"));
  CHECK_THAT(problem("5 %", Dimension::angle), Catch::Contains("is a dimensionless number"));
}

TEST_CASE("exponents of a unit are read whole") {
  for (const char* good : {"1 W/m2/K", "1 W m^-2 K-1", "1 W.m**-2.K-1", "1 W/(m2 K)"})
    CHECK(si(good, Dimension::film_coefficient) == Approx(1.0).epsilon(1e-15));
  CHECK(si("1 cmH2O", Dimension::pressure) == Approx(98.0665).epsilon(1e-12));
  CHECK(si("1 (1/K)", Dimension::per_temperature) == 1.0);
  for (const char* bad : {"2.0 mol/s/m3/Pa^0.5", "2 mol/s/m3/Pa0.5", "2 mol/s/m3/Pa^1/2",
                          "2 mol/s/m3 10", "2 mol/s/m 3", "2 10^3 mol/s/m3", "2 mol/s/m3/Pa^(1/2)"})
    CHECK_THAT(problem(bad, Dimension::volumetric_rate), Catch::Contains("no whole exponent"));
}

TEST_CASE("a unit is not taken for its reciprocal") {
  CHECK_THAT(problem("20 ms", Dimension::frequency),
             Catch::Contains("is a time; wanted a frequency"));
  CHECK_THAT(problem("50 Hz", Dimension::time), Catch::Contains("is a frequency; wanted a time"));
  CHECK_THAT(problem("5 s/m", Dimension::speed), Catch::Contains("of another dimension"));
  CHECK_THAT(problem("500 K", Dimension::per_temperature), Catch::Contains("is a temperature"));
  CHECK_THAT(problem("2 m.K/W", Dimension::conductivity), Catch::Contains("of another dimension"));
}

TEST_CASE("temperatures in compound units are differences; logarithms and dates are no units") {
  CHECK(si("900 J/kg/degC", Dimension::heat_capacity) == Approx(900).epsilon(1e-15));
  CHECK(si("9 W/m2/degF", Dimension::film_coefficient) == Approx(9 * 1.8).epsilon(1e-12));
  CHECK(si("-40 degF", Dimension::temperature) == Approx(233.15).epsilon(1e-12));
  CHECK_THAT(problem("3 dBm", Dimension::pressure), Catch::Contains("another dimension"));
  CHECK_THAT(problem("3 s since 2000-01-01", Dimension::time),
             Catch::Contains("no whole exponent"));
}

TEST_CASE("names of units that begin like a number are names") {
  CHECK(si("5 nanometre", Dimension::length) == Approx(5e-9).epsilon(1e-15));
  CHECK_THAT(problem("+-5 mm", Dimension::length), Catch::Contains("is no number with a unit"));
  CHECK_THAT(problem("1,5 mm", Dimension::length), Catch::Contains("unit ',5 mm'"));
  CHECK_THAT(problem("1e307 km", Dimension::length), Catch::Contains("is not finite in SI"));
}

TEST_CASE("the unit of a column holds no number") {
  const Units units;
  const Scale celsius = units.scale("degC", Dimension::temperature);
  CHECK(celsius.offset == Approx(273.15));
  CHECK(celsius.factor == Approx(1.0).epsilon(1e-12));
  CHECK_THAT(units.scale("1e-3 m", Dimension::length).problem, Catch::Contains("holds a number"));
}

TEST_CASE("edit distance counts inserts, deletions, changes and swaps") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);  // the textbook example of Levenshtein (1966)
  CHECK(edit_distance("mass", "mssa") == 2);
  CHECK(edit_distance("maerial", "material") == 1);
  CHECK(edit_distance("ab", "ba") == 1);
}
