#include "physics/conduction.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::physics {
namespace {

double conductivity_of(const AluminaConductivity& law, double T, double) {
  const double celsius = T - zero_celsius;
  return law.factor * (law.c0 + law.c1 * std::exp(-law.c2 * celsius) / (celsius + law.c3));
}

double conductivity_of(const TabulatedConductivity& law, double T, double pressure) {
  const double kept = pressure / (pressure + law.half_pressure);  // of the part gas carries [1]
  return law.table(T) * (1.0 - law.gas_share * (1.0 - kept));
}

double contact_modulus(double E1, double nu1, double E2, double nu2) {
  return 1.0 / ((1.0 - nu1 * nu1) / E1 + (1.0 - nu2 * nu2) / E2);
}

}  // namespace

double conductivity(const Conductivity& law, double T, double pressure) {
  return std::visit([&](const auto& one) { return conductivity_of(one, T, pressure); }, law);
}

double soft_contact_modulus(const Material& one, const Material& two) {
  return contact_modulus(one.young_soft, one.poisson_soft, two.young_soft, two.poisson_soft);
}

double real_contact_modulus(const Material& one, const Material& two) {
  return contact_modulus(one.young_real, one.poisson_real, two.young_real, two.poisson_real);
}

double contact_softening(const Material& one, const Material& two) {
  return std::cbrt(soft_contact_modulus(one, two) / real_contact_modulus(one, two));
}

double reduced_radius(double radius_1, double radius_2) {
  return 1.0 / (1.0 / radius_1 + 1.0 / radius_2);
}

double contact_radius(double reduced_radius, double overlap, double softening) {
  return std::sqrt(reduced_radius * std::max(overlap, 0.0)) * softening;
}

double contact_conductance(double conductivity_1, double conductivity_2, double contact_radius) {
  const double sum = conductivity_1 + conductivity_2;
  return sum > 0.0 ? 4.0 * contact_radius * conductivity_1 * conductivity_2 / sum : 0.0;
}

}  // namespace pmr::physics
