// Rate laws: zero at equilibrium, right in sign, slopes as differences.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "chemistry/kinetics.hpp"
#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"
#include "verify/reference_materials.hpp"

using namespace pmr;
using namespace pmr::chemistry;

namespace {
Redox with_exponent(double m) {
  Redox redox = *verify::reference_ferrite().redox;
  std::get<PowerRate>(redox.rate).exponent = m;
  return redox;
}
// Every law and what may be added to it.
std::vector<Redox> laws() {
  std::vector<Redox> all{with_exponent(0.5), with_exponent(1.0), with_exponent(1.0),
                         with_exponent(1.0), with_exponent(1.0), with_exponent(1.0),
                         with_exponent(1.0)};
  std::get<PowerRate>(all[2].rate).oxidation = Arrhenius{3.4e10, 177.1e3};
  all[3].pores = PoreDiffusion{3e-5, 1000.0};
  all[4].rate = RelaxationRate{40.0, 673.15, 144e3, 92e3, 1.0};
  all[5].equilibrium.oxygen_entropy.reset();
  all[6].rate = VacancyRate{82.0, 36e3, 0.218, 1e5};
  return all;
}
constexpr double concentration = 1.8e4, radius = 0.735e-3;  // [mol/m3], [m]
}  // namespace

TEST_CASE("every rate law is among those that these tests try") {
  std::vector<bool> tried(std::variant_size_v<RateLaw>, false);
  for (const Redox& redox : laws()) tried[redox.rate.index()] = true;
  CHECK(tried == std::vector<bool>(tried.size(), true));
}

TEST_CASE("the rate vanishes at equilibrium and has the sign of the drive, in a vacuum too") {
  for (const Redox& redox : laws())
    for (const double T : {900.0, 500.0}) {
      const double p = equilibrium_pressure(redox.equilibrium, T, 0.33);
      if (T == 500.0) CHECK((p > 1e-8 && p < 1e-3));
      if (p < 1e-3 && std::holds_alternative<RelaxationRate>(redox.rate)) continue;  // cut there
      const auto rate = [&](double pressure) {
        return oxygen_rate(redox, {T, 0.33, pressure, concentration, radius});
      };
      const double scale = rate(0.5 * p);
      CHECK(scale > 0.0);
      CHECK(std::abs(rate(p)) < 1e-10 * scale);
      CHECK(rate(2.0 * p) < 0.0);
    }
}

TEST_CASE("the rate's slopes are those of its differences") {
  // Central differences of relative step h: error h^2 times (ln p)''' scale, about 1e-6.
  for (const Redox& redox : laws())
    for (const double p : {3000.0, 3e6}) {  // reducing and oxidising
      const RateState at{800.0, 0.31, p, concentration, radius};
      const auto rate = [&](double T, double d, double pressure) {
        return oxygen_rate(redox, {T, d, pressure, concentration, radius});
      };
      const RateSlopes slopes = oxygen_rate_slopes(redox, at);
      const double T = at.temperature, d = at.delta, h = 1e-5 * p;
      CHECK(slopes.rate == oxygen_rate(redox, at));
      CHECK(slopes.by_temperature ==
            Approx((rate(T + 0.01, d, p) - rate(T - 0.01, d, p)) / 0.02).epsilon(2e-6));
      CHECK(slopes.by_delta ==
            Approx((rate(T, d + 1e-6, p) - rate(T, d - 1e-6, p)) / 2e-6).epsilon(2e-6));
      CHECK(slopes.by_oxygen_pressure ==
            Approx((rate(T, d, p + h) - rate(T, d, p - h)) / (2.0 * h)).epsilon(2e-6));
    }
}

TEST_CASE("by detailed balance the vacancies' law has the reduction that Bulfin et al. state") {
  // Their ceria: delta/(0.35 - delta) = 8700 (p/bar)^-n exp(-195.6 kJ/mol/(R T)), in the common
  // form as cases/materials/CeO2.toml says; oxidation 82/s (p/bar)^n exp(-36 kJ/mol/(R T)) delta.
  // In vacuum d(delta)/dt is then 82 8700 exp(-231.6 kJ/mol/(R T)) (0.35 - delta).
  constexpr double n = 0.217, bound = 195.6e3;
  Redox ceria = *verify::reference_ferrite().redox;
  RedoxEquilibrium& eq = ceria.equilibrium;
  eq.enthalpy = PolynomialEnthalpy{{bound / (2.0 * n), 0.0, 0.0, 0.0}};
  eq.vibration_entropy = 0.0;
  eq.oxygen_entropy = std::log(8700.0) / n * gas_constant / 2.0;
  eq.configuration = 1.0 / (4.0 * n);
  eq.delta_limit = 0.35;
  ceria.rate = VacancyRate{82.0, 36e3, n, 1e5};
  for (const double T : {1700.0, 2000.0})  // p_eq from 7e-9 Pa
    for (const double delta : {0.01, 0.1, 0.3}) {
      const auto by_time = [&](double p) {  // d(delta)/dt [1/s]
        return 2.0 * oxygen_rate(ceria, {T, delta, p, concentration, radius}) / concentration;
      };
      const double out =
          82.0 * 8700.0 * std::exp(-(36e3 + bound) / (gas_constant * T)) * (0.35 - delta);
      const double in = 82.0 * std::exp(-36e3 / (gas_constant * T)) * delta;  // of p/bar to the n
      CHECK(by_time(2e4) == Approx(out - in * std::pow(0.2, n)).epsilon(1e-9));
      CHECK(by_time(1.0) == Approx(out - in * std::pow(1e-5, n)).epsilon(1e-9));
    }
}

TEST_CASE("a porous sphere's effectiveness follows Thiele's solution") {
  // 3 (phi coth phi - 1)/phi^2 by hand; 1 - phi^2/15 for small phi, 3/phi for large.
  CHECK(effectiveness(1.0) == Approx(0.939106).epsilon(1e-5));
  CHECK(effectiveness(5.0) == Approx(0.480054).epsilon(1e-5));
  CHECK(effectiveness(0.0999) == Approx(effectiveness(0.1001)).epsilon(1e-5));
  CHECK(effectiveness(1e3) == Approx(3e-3).epsilon(2e-3));
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

TEST_CASE("delta rises by two for each oxygen molecule per formula unit") {
  const Material ferrite = verify::reference_ferrite();
  const RateState at{900.0, 0.33, 1000.0};
  CHECK(delta_rate(ferrite, at) * formula_unit_concentration(ferrite) ==
        Approx(2.0 * oxygen_rate(*ferrite.redox, at)).epsilon(1e-15));
}
