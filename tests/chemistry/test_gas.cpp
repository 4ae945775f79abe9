// Oxygen, nitrogen and mixtures; limits of rarefaction.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/gas.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

using namespace pmr;
using namespace pmr::chemistry;

TEST_CASE("gas enthalpies vanish at 298.15 K and are continuous") {
  CHECK(std::abs(oxygen_heat(298.15).enthalpy) < 1e-10);
  CHECK(std::abs(nitrogen_heat(298.15).enthalpy) < 1e-10);
  for (const double join : {500.0, 700.0, 2000.0})
    for (const auto gas : {oxygen_heat, nitrogen_heat}) {
      const double before = std::nextafter(join, 0.0);
      // Across one ulp the enthalpy may move by Cp ulp and rounding: 1e-10 J/mol.
      CHECK(std::abs(gas(join).enthalpy - gas(before).enthalpy) < 1e-10);
      // The two published fits meet in Cp to their own rounding, some mJ/mol/K.
      CHECK(std::abs(gas(join).heat_capacity - gas(before).heat_capacity) < 5e-3);
    }
}

TEST_CASE("the constants of integration agree with the published ones to 1 J/mol") {
  // NIST's F: h = 1000 (A t + ... - E/t + F); recomputed here for O2 at 500 K and N2 at 400 K.
  const auto nist = [](double A, double B, double C, double D, double E, double F, double t) {
    return 1e3 * (A * t + B * t * t / 2 + C * t * t * t / 3 + D * t * t * t * t / 4 - E / t + F);
  };
  const double o2 = nist(31.32234, -20.23531, 57.86644, -36.50624, -0.007374, -8.903471, 0.5);
  const double n2 = nist(28.98641, 1.853978, -9.647459, 16.63537, 0.000117, -8.671914, 0.4);
  CHECK(std::abs(oxygen_heat(500.0).enthalpy - o2) < 1.0);
  CHECK(std::abs(nitrogen_heat(400.0).enthalpy - n2) < 1.0);
}

TEST_CASE("temperature inverts the internal energy of any mixture") {
  for (const GasAmount gas : {GasAmount{1.0, 0.0}, {0.0, 2e-3}, {0.021, 0.079}})
    for (double T = 151.0; T < 2999.0; T += 71.9)
      for (const double guess : {300.0, T, 2500.0}) {
        const double back = gas_temperature(gas, internal_energy(gas, T), guess);
        CHECK(std::abs(back - T) < 5e-12);  // rounding of some 1e5 J/mol over Cv of 21 J/mol/K
      }
  CHECK_THROWS_AS(gas_temperature({1.0, 0.0}, -1e9, 300.0), NumericsError);
}

TEST_CASE("Cv is the slope of the internal energy, and Cp - Cv = R") {
  const GasAmount gas{0.3, 0.7};
  for (double T = 160.0; T < 2900.0; T += 133.0) {
    const double slope = (internal_energy(gas, T + 0.05) - internal_energy(gas, T - 0.05)) / 0.1;
    const double cv = heat_capacity_constant_volume(gas, T);
    CHECK(cv == Approx(slope).epsilon(1e-6));
    CHECK(heat_capacity_ratio(0.3, T) == Approx((cv + gas_constant) / cv).epsilon(1e-12));
  }
}

TEST_CASE("mixture properties run between those of the pure gases") {
  for (const double T : {300.0, 1000.0})
    for (const auto property : {viscosity, gas_conductivity}) {
      CHECK(property(0.21, T) > property(0.0, T));
      CHECK(property(0.21, T) < property(1.0, T));
    }
  // Air, power law through handbook values: the linear mixture is within 1.5 %.
  CHECK(gas_conductivity(0.21, 1000.0) == Approx(0.06734).epsilon(0.015));
  CHECK(oxygen_fraction({0.0, 0.0}) == 1.0);
}

TEST_CASE("a gap conducts as k/L in dense gas and independent of its width in thin gas") {
  const auto film = [](double pressure, double width) {
    const double g = jump_length(1.0, 1000.0, pressure, 0.9);
    return gas_conductivity(1.0, 1000.0) / (width + 2.0 * g);
  };
  const double dense = gas_conductivity(1.0, 1000.0) / 1e-3;
  CHECK(film(1e9, 1e-3) == Approx(dense).epsilon(1e-6));  // g = 60.8 um at 1000 Pa, over 1e6
  CHECK(film(1e-3, 1e-3) == Approx(film(1e-3, 1e-5)).epsilon(1e-4));
  CHECK(film(2e-3, 1e-3) == Approx(2.0 * film(1e-3, 1e-3)).epsilon(1e-4));
}

TEST_CASE("the jump length falls as accommodation improves") {
  CHECK(jump_length(1.0, 1000.0, 1000.0, 0.5) > jump_length(1.0, 1000.0, 1000.0, 0.9));
  CHECK(jump_length(1.0, 1000.0, 1000.0, 0.5) ==
        Approx(3.0 * jump_length(1.0, 1000.0, 1000.0, 1.0)).epsilon(1e-14));
}
