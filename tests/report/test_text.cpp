#include <catch2/catch.hpp>
#include <limits>

#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/text.hpp"
#include "report/value.hpp"

using namespace pmr::report;

TEST_CASE("Numbers get the digits they deserve") {
  CHECK(with_unit(Quantity::temperature, 1185.44) == "912.3\u202f°C");
  CHECK(with_unit(Quantity::temperature_difference, 7.83) == "7.8\u202fK");
  CHECK(with_unit(Quantity::delta, 0.45213) == "0.4521");
  CHECK(with_unit(Quantity::energy, 3310.4) == "3.31\u202fkJ");
  CHECK(with_unit(Quantity::count, 173769.0) == "173,769");
  CHECK(with_unit(Quantity::residual, 3.14e-9) == "3.1·10⁻⁹");
  CHECK(with_unit(Quantity::pressure, 101325.0) == "101.3\u202fkPa");
  CHECK(with_unit(Quantity::time, 1800.0) == "30\u202fmin");
}

TEST_CASE("A number just below a border is written as the one above it that it is rounded to") {
  CHECK(with_unit(Quantity::mass, 0.99998) == "1.000\u202fkg");
  CHECK(with_unit(Quantity::mass, 1.0) == "1.000\u202fkg");
  CHECK(with_unit(Quantity::energy, 999.6e3) == "1.00\u202fMJ");
  CHECK(with_unit(Quantity::energy, -999.6) == "\u22121.00\u202fkJ");
  CHECK(with_unit(Quantity::residual, 9.96e-9) == "10⁻⁸");
  CHECK(with_unit(Quantity::pressure, 9999.96) == "10.00\u202fkPa");
  CHECK(with_unit(Quantity::pressure, 0.99999) == "1.000\u202fPa");
  CHECK(with_unit(Quantity::time, 599.9) == "10\u202fmin");
  CHECK(with_unit(Quantity::ratio, 9.996) == "10.0");
  CHECK(with_unit(Quantity::temperature_difference, 0.996) == "1.0\u202fK");
}

TEST_CASE("A value that is not known is shown as a dash") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(with_unit(Quantity::temperature, none) == "\u2013");
  CHECK(difference(Quantity::delta, none) == "\u2013");
}

TEST_CASE("A difference carries its sign, and one of temperatures is in kelvin") {
  CHECK(difference(Quantity::temperature, -3.14) == "\u22123.1\u202fK");
  CHECK(difference(Quantity::delta, 0.0123) == "+0.0123");
  CHECK(difference(Quantity::delta, 0.0) == "±0");
}

TEST_CASE("Base 64 agrees with RFC 4648") {
  // Test vectors of RFC 4648 section 10.
  const auto of = [](std::string_view text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
  };
  CHECK(of("") == "");
  CHECK(of("f") == "Zg==");
  CHECK(of("fo") == "Zm8=");
  CHECK(of("foo") == "Zm9v");
  CHECK(of("foobar") == "Zm9vYmFy");
}

TEST_CASE("Text cannot become markup") {
  CHECK(escape("<b>&\"") == "&lt;b&gt;&amp;&quot;");
  CHECK(chemical("SrFeO3") == "SrFeO₃");
}

TEST_CASE("JSON is read and written, and what is absent reads as absent") {
  const Value value = parse_json(R"({"a": {"b": [1, 2.5, null]}, "s": "x", "n": null})");
  CHECK(value.items("a/b").size() == 3);
  CHECK(value.items("a/b")[1].as_number() == 2.5);
  CHECK(value.text("s") == "x");
  CHECK_FALSE(value.has("n"));
  CHECK_FALSE(value.has("a/c/d"));
  CHECK(std::isnan(value.number("s")));
  CHECK(to_json(value) == R"({"a":{"b":[1,2.5,null]},"s":"x","n":null})");
  CHECK(to_json(Value(std::numeric_limits<double>::infinity())) == "null");
}

TEST_CASE("The colour maps start and end where their tables do") {
  // matplotlib's viridis: #440154 at 0, #21918c at 0.5, #fde725 at 1; the fit is within 2 %.
  const auto near = [](const Rgb& a, const Rgb& b) {
    for (std::size_t c = 0; c < 3; ++c) CHECK(a[c] == Approx(b[c]).margin(0.02));
  };
  near(colour_at(ColourMap::viridis, 0.0), {0x44 / 255.0, 0x01 / 255.0, 0x54 / 255.0});
  near(colour_at(ColourMap::viridis, 0.5), {0x21 / 255.0, 0x91 / 255.0, 0x8c / 255.0});
  near(colour_at(ColourMap::viridis, 1.0), {0xfd / 255.0, 0xe7 / 255.0, 0x25 / 255.0});
}

TEST_CASE("Lightness rises all along viridis and inferno") {
  for (const ColourMap map : {ColourMap::viridis, ColourMap::inferno}) {
    double last = -1.0;
    for (int k = 0; k <= 20; ++k) {
      const Rgb c = colour_at(map, k / 20.0);
      const double luma = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];  // Rec. 709 weights
      CHECK(luma > last);
      last = luma;
    }
  }
}

TEST_CASE("Round limits hold the range they are made for") {
  const Limits limits = round_limits(0.3269, 0.4612);
  CHECK(limits.low <= 0.3269);
  CHECK(limits.high >= 0.4612);
  CHECK(limits.high - limits.low < 1.4 * (0.4612 - 0.3269));
}
