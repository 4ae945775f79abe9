// Heat content of solids: enthalpy and temperature are inverse, Cp is the slope, books can close.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/gas.hpp"
#include "chemistry/redox.hpp"
#include "chemistry/solids.hpp"
#include "pmr/base/errors.hpp"
#include "verify/reference_materials.hpp"

using namespace pmr;
using namespace pmr::chemistry;

namespace {
Material tabulated() {
  Material material = verify::reference_alumina();
  material.heat = TabulatedHeat{IntegratedTable({{200.0, 400.0, 1000.0}, {600.0, 900.0, 1200.0}})};
  return material;
}
const std::vector<Material> solids{verify::reference_alumina(), verify::reference_ferrite(),
                                   verify::reference_fibre_board(), tabulated()};
}  // namespace

TEST_CASE("temperature inverts enthalpy to rounding, from any guess") {
  // Rounding of the enthalpy, some eps * 4e5 J/mol, over Cp of 70 J/mol/K or more: 2e-12 K.
  for (const Material& material : solids)
    for (const double delta : {0.1, 0.35, 0.49})
      for (double T = 151.0; T < 2999.0; T += 37.3)
        for (const double guess : {T, 150.0, 298.15, 2900.0, std::nan("")}) {
          const Solid solid{&material, 3.1e-8};
          const double back = temperature(solid, enthalpy(solid, T, delta), delta, guess);
          CHECK(std::abs(back - T) < 5e-12);
        }
}

TEST_CASE("particles of any size at one temperature are told the same temperature") {
  for (const Material& material : solids)
    for (const double amount : {3e-8, 5.17e-5, 0.77, 13.0})
      for (const double guess : {700.0, 1000.0}) {
        const Solid solid{&material, amount};
        const double back = temperature(solid, enthalpy(solid, 873.15, 0.31), 0.31, guess);
        CHECK(std::abs(back - 873.15) < 1e-12);
      }
}

TEST_CASE("heat capacity is the slope of enthalpy, inside and beyond the fits") {
  for (const Material& material : solids)
    for (double T = 160.0; T < 2990.0; T += 21.7) {
      const Solid solid{&material, 1.0};
      const double h = 0.05;
      const double slope = (enthalpy(solid, T + h, 0.3) - enthalpy(solid, T - h, 0.3)) / (2.0 * h);
      CHECK(heat_capacity(solid, T, 0.3) == Approx(slope).epsilon(1e-7));
      CHECK(heat_capacity(solid, T, 0.3) > 0.0);
    }
}

TEST_CASE("heat capacity and its slope have no step at the ends of a fit") {
  for (const double end : {298.0, 298.15, 1500.0, 2000.0, 2327.0})
    for (const Material& material : solids) {
      const Solid solid{&material, 1.0};
      const auto c = [&](double T) { return heat_capacity(solid, T, 0.3); };
      const double below = c(end) - c(end - 0.1), above = c(end + 0.1) - c(end);
      CHECK(std::abs(above - below) < 1e-5 * c(end));
    }
}

TEST_CASE("a tabulated heat capacity holds the trapezia between its rows") {
  const Material material = tabulated();  // 750 J/kg/K at 300 K
  CHECK(specific_enthalpy(material, 400.0) - specific_enthalpy(material, 300.0) ==
        Approx(825.0 * 100.0).epsilon(1e-14));
  CHECK(specific_enthalpy(material, 1500.0) - specific_enthalpy(material, 400.0) ==
        Approx(1050.0 * 600.0 + 1200.0 * 500.0).epsilon(1e-14));
  CHECK(specific_enthalpy(material, 200.0) - specific_enthalpy(material, 160.0) ==
        Approx(600.0 * 40.0).epsilon(1e-13));
  CHECK(specific_enthalpy(material, 298.15) == 0.0);
}

TEST_CASE("enthalpy vanishes at 298.15 K but for what delta holds") {
  CHECK(specific_enthalpy(solids[2], 298.15) == 0.0);
  // NIST's own F and H leave -26.5 J/mol for corundum, computed by hand from the constants.
  CHECK(specific_enthalpy(solids[0], 298.15) * 101.9613e-3 == Approx(-26.5).epsilon(1e-2));
  const double held = reduction_heat(solids[1].redox->equilibrium, 0.3);
  CHECK(molar_enthalpy(solids[1], 298.15, 0.3) == Approx(held).epsilon(1e-12));
}

TEST_CASE("oxygen that leaves takes its enthalpy and dh, at every temperature") {
  const Solid solid{&solids[1], 0.02};
  for (const double T : {300.0, 700.0, 1200.0})
    for (const double delta : {0.2, 0.295, 0.45}) {
      const double h = 1e-6;
      const double slope =
          (enthalpy(solid, T, delta + h) - enthalpy(solid, T, delta - h)) / (2.0 * h);
      CHECK(enthalpy_delta_slope(solid, T, delta) == Approx(slope).epsilon(1e-6));
      const double with_gas = slope + 0.5 * solid.amount * oxygen_heat(T).enthalpy;
      const double dh = reduction_enthalpy(solids[1].redox->equilibrium, delta);
      CHECK(with_gas == Approx(solid.amount * dh).epsilon(1e-6));
    }
  CHECK(enthalpy_delta_slope({&solids[0], 1.0}, 700.0, 0.0) == 0.0);
}

TEST_CASE("an energy of no temperature is refused") {
  const Solid solid{&solids[0], 1.0};
  CHECK_THROWS_AS(temperature(solid, -1e9, 0.0, 300.0), NumericsError);
  CHECK_THROWS_AS(temperature(solid, 1e9, 0.0, 300.0), NumericsError);
  CHECK_THROWS_AS(temperature(solid, std::nan(""), 0.0, 300.0), NumericsError);
}

TEST_CASE("heat laws are held to the kind of material they are made for") {
  for (const Material& material : solids) CHECK(heat_law_fits(material));
  Material odd = solids[0];
  odd.heat = solids[1].heat;
  CHECK_FALSE(heat_law_fits(odd));
  CHECK_THROWS_AS(specific_heat(odd, 500.0), std::logic_error);
}
