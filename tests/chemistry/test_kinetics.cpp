// Rate laws: zero at equilibrium, right in sign, slopes as differences.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/kinetics.hpp"
#include "chemistry/redox.hpp"
#include "verify/reference_materials.hpp"

using namespace pmr;
using namespace pmr::chemistry;

namespace {
Redox with_exponent(double m) {
  Redox redox = *verify::reference_ferrite().redox;
  std::get<PowerRate>(redox.rate).exponent = m;
  return redox;
}
}  // namespace

TEST_CASE("the rate vanishes at equilibrium and has the sign of the drive") {
  for (const double m : {0.5, 1.0}) {
    const Redox redox = with_exponent(m);
    const double p = equilibrium_pressure(redox.equilibrium, 900.0, 0.33);
    CHECK(oxygen_rate(redox, {900.0, 0.33, p}) == 0.0);
    CHECK(oxygen_rate(redox, {900.0, 0.33, 0.5 * p}) > 0.0);
    CHECK(oxygen_rate(redox, {900.0, 0.33, 2.0 * p}) < 0.0);
    CHECK(oxygen_rate_slopes(redox, {900.0, 0.33, p}).rate == 0.0);
  }
}

TEST_CASE("the rate's slopes are those of its differences") {
  // Central differences of relative step h: error h^2 times (ln p)''' scale, about 1e-6.
  for (const double m : {0.5, 1.0}) {
    const Redox redox = with_exponent(m);
    const RateState at{800.0, 0.31, 3000.0};
    const auto rate = [&](double T, double d, double p) { return oxygen_rate(redox, {T, d, p}); };
    const RateSlopes slopes = oxygen_rate_slopes(redox, at);
    const double T = at.temperature, d = at.delta, p = at.oxygen_pressure;
    CHECK(slopes.rate == oxygen_rate(redox, at));
    CHECK(slopes.by_temperature ==
          Approx((rate(T + 0.01, d, p) - rate(T - 0.01, d, p)) / 0.02).epsilon(1e-6));
    CHECK(slopes.by_delta ==
          Approx((rate(T, d + 1e-6, p) - rate(T, d - 1e-6, p)) / 2e-6).epsilon(1e-6));
    CHECK(slopes.by_oxygen_pressure ==
          Approx((rate(T, d, p + 1.0) - rate(T, d, p - 1.0)) / 2.0).epsilon(1e-6));
  }
}

TEST_CASE("a delta outside its domain gives no rate but NaN") {
  const Redox redox = with_exponent(1.0);
  CHECK(std::isnan(oxygen_rate(redox, {900.0, 0.5, 1000.0})));
  CHECK(std::isnan(oxygen_rate(redox, {900.0, -1e-9, 1000.0})));
}

TEST_CASE("a pressure just below zero, as integrators try, is no fault") {
  CHECK(std::isfinite(oxygen_rate(with_exponent(1.0), {900.0, 0.33, -1e-9})));
  CHECK(std::isfinite(oxygen_rate(with_exponent(0.5), {900.0, 0.33, -1e-9})));
}

TEST_CASE("delta rises by two for each oxygen molecule per iron") {
  const Material ferrite = verify::reference_ferrite();
  const RateState at{900.0, 0.33, 1000.0};
  CHECK(delta_rate(ferrite, at) * iron_concentration(ferrite) ==
        Approx(2.0 * oxygen_rate(*ferrite.redox, at)).epsilon(1e-15));
}
