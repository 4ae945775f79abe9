#include "physics/bed_conductivity.hpp"

#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::physics {
namespace {

constexpr double shape_factor = 1.25;  // [1] C of spheres
constexpr double flattening = 0.0077;  // [1] phi, ceramic spheres

}  // namespace

double zehner_bauer_schluender(const PackedBed& bed) {
  // Everything in units of the gas' conductivity, named as in the Heat Atlas.
  const double porosity = 1.0 - bed.solid_fraction;
  const double T = bed.temperature;
  const double k_p = bed.solid_conductivity / bed.gas_conductivity;
  const double k_rad = 4.0 * stefan_boltzmann / (2.0 / bed.emissivity - 1.0) * T * T * T *
                       bed.diameter / bed.gas_conductivity;
  const double k_D = 1.0 / (1.0 + bed.jump / bed.diameter);
  const double B = shape_factor * std::pow(bed.solid_fraction / porosity, 10.0 / 9.0);
  const double N =
      (1.0 + (k_rad - B * k_D) / k_p) / k_D - B * (1.0 / k_D - 1.0) * (1.0 + k_rad / k_p);
  const double logarithm = std::log((k_p + k_rad) / (B * (k_D + (1.0 - k_D) * (k_p + k_rad))));
  const double core =
      2.0 / N *
      (B * (k_p + k_rad - 1.0) / (N * N * k_D * k_p) * logarithm +
       (B + 1.0) / (2.0 * B) * (k_rad / k_D - B * (1.0 + (1.0 - k_D) / k_D * k_rad)) -
       (B - 1.0) / (N * k_D));
  const double cell = std::sqrt(bed.solid_fraction);
  const double k = (1.0 - cell) * porosity * (1.0 / (porosity - 1.0 + 1.0 / k_D) + k_rad) +
                   cell * (flattening * k_p + (1.0 - flattening) * core);
  return k * bed.gas_conductivity;
}

}  // namespace pmr::physics
