// Equilibrium of the ferrite: what must hold for any parameters. Values are checked in src/verify.
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"
#include "verify/reference_materials.hpp"

using namespace pmr;
using namespace pmr::chemistry;

namespace {
const RedoxEquilibrium two_plateaus = verify::reference_ferrite().redox->equilibrium;
const RedoxEquilibrium both[] = {two_plateaus, verify::smooth_equilibrium()};

// Central difference; error h^2 f'''/6 plus rounding eps f/h.
template <class F>
double slope(const F& f, double x, double h) {
  return (f(x + h) - f(x - h)) / (2.0 * h);
}
}  // namespace

TEST_CASE("the slopes of ln p are those of its differences") {
  for (const RedoxEquilibrium& eq : both)
    for (const auto& place : std::vector<std::pair<double, double>>{
             {0.05, 400.0}, {0.25, 700.0}, {0.295, 1300.0}, {0.33, 700.0}, {0.47, 1300.0}}) {
      const double delta = place.first, T = place.second;
      const double by_delta =
          slope([&](double d) { return ln_equilibrium_pressure(eq, T, d); }, delta, 1e-6);
      const double by_T =
          slope([&](double t) { return ln_equilibrium_pressure(eq, t, delta); }, T, 1e-2);
      CHECK(ln_pressure_delta_slope(eq, T, delta) == Approx(by_delta).epsilon(1e-7));
      CHECK(ln_pressure_temperature_slope(eq, T, delta) == Approx(by_T).epsilon(1e-8));
    }
}

TEST_CASE("dh is the slope of H, and its own slope is right") {
  for (const RedoxEquilibrium& eq : both)
    for (const double delta : {0.01, 0.2, 0.295, 0.3, 0.49}) {
      const double by_delta = slope([&](double d) { return reduction_heat(eq, d); }, delta, 1e-5);
      CHECK(reduction_enthalpy(eq, delta) == Approx(by_delta).epsilon(1e-6));
      CHECK(bond_at(eq, delta).enthalpy == reduction_enthalpy(eq, delta));
      const double second = slope([&](double d) { return reduction_enthalpy(eq, d); }, delta, 1e-6);
      CHECK(reduction_enthalpy_slope(eq, delta) == Approx(second).epsilon(1e-7));
    }
}

TEST_CASE("delta is unique where pressure falls all the way as it rises, and a law may fail that") {
  for (const RedoxEquilibrium& eq : both) CHECK(is_stable(eq, 298.15));
  RedoxEquilibrium two_phases = verify::smooth_equilibrium();
  std::get<PolynomialEnthalpy>(two_phases.enthalpy).c = {150e3, -150e3, 0.0, 0.0};
  CHECK(is_stable(two_phases, 1500.0));
  CHECK_FALSE(is_stable(two_phases, 298.15));
}

TEST_CASE("delta_eq is where p_eq equals the pressure") {
  for (int k = 0; k < 400; ++k) {
    const RedoxEquilibrium& eq = both[k % 2];
    const double T = 300.0 + 50.0 * (k / 2 % 25), p = std::pow(10.0, -2 + k / 50);
    const double delta = equilibrium_delta(eq, T, p);
    // delta is good to about eps (1 + its distance from the limit): a few ulps of ln p's slope.
    const double ulps = 8.0 * 0x1p-52 * (1.0 + std::abs(ln_pressure_delta_slope(eq, T, delta)));
    CHECK(std::abs(ln_equilibrium_pressure(eq, T, delta) - std::log(p / bar)) < 20.0 * ulps);
  }
}

TEST_CASE("delta_eq stays inside its domain in the extremes") {
  for (const RedoxEquilibrium& eq : both)
    for (const double T : {150.0, 300.0, 3000.0})
      for (const double p : {1e-12, 1.0, 1e8}) {
        const double delta = equilibrium_delta(eq, T, p);
        CHECK(delta > 0.0);
        CHECK(delta < eq.delta_limit);
        CHECK_FALSE(std::isnan(equilibrium_pressure(eq, T, delta)));
      }
}

TEST_CASE("delta outside its domain is answered by NaN") {
  for (const double delta : {-0.1, 0.0, 0.5, 0.6, std::nan("")})
    CHECK(std::isnan(equilibrium_pressure(two_plateaus, 1000.0, delta)));
}

TEST_CASE("the range of the fit is known") {
  CHECK(is_within_fit(two_plateaus, 1000.0, 0.35, 1e4));
  CHECK_FALSE(is_within_fit(two_plateaus, 500.0, 0.35, 1e4));
  CHECK_FALSE(is_within_fit(two_plateaus, 1000.0, 0.2, 1e4));
  CHECK_FALSE(is_within_fit(two_plateaus, 1000.0, 0.35, 1.0));
}

TEST_CASE("formula unit per volume times molar mass is the density") {
  const Material ferrite = verify::reference_ferrite();
  const double mass = molar_mass(*ferrite.redox, ferrite.redox->density_delta);
  CHECK(formula_unit_concentration(ferrite) * mass == Approx(ferrite.density).epsilon(1e-15));
  CHECK_THROWS_AS(formula_unit_concentration(verify::reference_alumina()), std::logic_error);
}
