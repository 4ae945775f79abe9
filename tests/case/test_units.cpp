#include <catch2/catch.hpp>

#include "case/nearest.hpp"
#include "case/units.hpp"

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

TEST_CASE("edit distance counts inserts, deletions, changes and swaps") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);  // the textbook example of Levenshtein (1966)
  CHECK(edit_distance("mass", "mssa") == 2);
  CHECK(edit_distance("maerial", "material") == 1);
  CHECK(edit_distance("ab", "ba") == 1);
}
