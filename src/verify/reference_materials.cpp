#include "verify/reference_materials.hpp"

#include "pmr/base/constants.hpp"

namespace pmr::verify {
namespace {

// Al2O3 (corundum), NIST Chemistry WebBook (P).
constexpr Shomate corundum{102.4290,  38.74980,  -15.91090,   2.628181, -3.007551,
                           -1717.930, -1675.690, 101.9613e-3, 298.0,    2327.0};

// Cp of SrFeO2.5 by Neumann-Kopp from SrO and Fe2O3 of NIST, +-8 % (D).
constexpr OxideHeat brownmillerite{109.666, 51.718, -28.097, -2.551, 298.15, 1500.0};

// Fit of the DLR thermogravimetry of SrFeO(3-d): Vieten et al., Energy Environ. Sci. 12 (2019)
// 1369, data set RedoxThermoCSP (P); the constant oxygen entropy is the project's choice (D).
constexpr RedoxEquilibrium vieten{.enthalpy = ArctanEnthalpy{.minimum = 63000.0,
                                                             .maximum = 87440.61481,
                                                             .shift = 0.058683613,
                                                             .steepness = 59.79085191,
                                                             .offset = 0.236534743},
                                  .vibration_entropy = -28.05301778,
                                  .oxygen_entropy = 115.53095,
                                  .configuration = 0.756732351,
                                  .delta_limit = 0.5,
                                  .fit_delta_minimum = 0.289,
                                  .fit_delta_maximum = 0.458,
                                  .fit_temperature_minimum = 400.0 + zero_celsius,
                                  .fit_temperature_maximum = 1200.0 + zero_celsius,
                                  .fit_pressure_minimum = 1e-4 * bar,
                                  .fit_pressure_maximum = 0.9 * bar};

// A and Ea of Harrison et al., Energy Fuels 37 (2023) 9487 (P); factor and order assumed (A).
constexpr PowerRate harrison{
    .factor = 0.5, .reduction = {623.0, 75.7e3}, .exponent = 1.0, .oxidation = std::nullopt};

Table celsius_table(std::vector<double> celsius, std::vector<double> value) {
  for (double& T : celsius) T += zero_celsius;
  return {std::move(celsius), std::move(value)};
}

// What all of them share: the softened contact of the mechanics (E 5 MPa, nu 0.3).
Material plain_material(const char* name, double density) {
  Material material{};
  material.name = name;
  material.density = density;
  material.young_soft = 5e6;
  material.poisson_soft = 0.3;
  material.emissivity.table = constant(0.9);
  material.accommodation = 0.9;  // (A), 0.5-1
  return material;
}

}  // namespace

Material reference_alumina() {
  Material material = plain_material("Al2O3", 3690.0);
  material.young_real = 300e9;  // (L)
  material.poisson_real = 0.22;
  material.heat = corundum;
  // Munro, J. Am. Ceram. Soc. 80 (1997) 1919 for 99.5 % (P), times 0.6 for 92 % (A).
  material.conductivity = AluminaConductivity{0.6, 5.85, 15360.0, 0.002, 516.0};
  material.emissivity.table =
      celsius_table({300, 600, 900, 1100}, {0.75, 0.65, 0.52, 0.45});  // (L)
  return material;
}

Material reference_ferrite() {
  Material material = plain_material("SrFeO3", 3460.0);
  material.young_real = 53e9;  // (D), 30-80 GPa
  material.poisson_real = 0.25;
  material.heat = brownmillerite;
  material.conductivity = TabulatedConductivity{constant(1.1)};  // (A/D), 0.7-1.6
  // Molar mass and oxygen from atomic weights; the delta at which the density is meant is (A).
  material.redox = Redox{.equilibrium = vieten,
                         .rate = harrison,
                         .rate_temperature_minimum = 0.0,
                         .rate_temperature_maximum = 2000.0,
                         .pores = std::nullopt,
                         .oxygen_atoms = 3.0,
                         .molar_mass = 191.462e-3,
                         .atomic_oxygen = 15.999e-3,
                         .density_delta = 0.25};
  return material;
}

// scripts/fit-equilibrium (D).
RedoxEquilibrium smooth_equilibrium() {
  return {.enthalpy = PolynomialEnthalpy{{25768.6, 342130.0, -472683.0, 0.0}},
          .vibration_entropy = 0.0,
          .oxygen_entropy = 92.0266,
          .configuration = 1.09293,
          .delta_limit = 0.5,
          .fit_delta_minimum = 0.168,
          .fit_delta_maximum = 0.476,
          .fit_temperature_minimum = 400.0 + zero_celsius,
          .fit_temperature_maximum = 1100.0 + zero_celsius,
          .fit_pressure_minimum = 0.01 * bar,
          .fit_pressure_maximum = 0.9 * bar};
}

Material reference_fibre_board() {
  Material material = plain_material("fibre board", 300.0);  // (A)
  material.young_real = 30e9;
  material.poisson_real = 0.25;
  material.heat = ConstantHeat{1100.0};  // (L), 1050-1130
  material.conductivity = TabulatedConductivity{
      celsius_table({200, 400, 600, 800, 1000}, {0.12, 0.15, 0.18, 0.22, 0.28})};  // (L)
  return material;
}

Material constant_solid(double density, double heat_capacity, double conductivity) {
  Material material = plain_material("constant solid", density);
  material.young_real = 30e9;
  material.poisson_real = 0.25;
  material.heat = ConstantHeat{heat_capacity};
  material.conductivity = TabulatedConductivity{constant(conductivity)};
  return material;
}

}  // namespace pmr::verify
