#include "beds.hpp"

#include <cmath>
#include <utility>

#include "pmr/base/constants.hpp"

namespace pmr::test {

void add_sphere(Particles& bed, SpeciesIndex species, const Vec3& position, double radius,
                double mass) {
  const std::size_t i = bed.size();
  resize(bed, i + 1);
  bed.id[i] = static_cast<ParticleId>(i);
  bed.species[i] = species;
  bed.position[i] = position;
  bed.radius[i] = radius;
  bed.mass[i] = mass;
}

Particles cubic_bed(std::size_t n, std::size_t layers, double diameter) {
  Particles bed;
  for (std::size_t k = 0; k < layers; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        const Vec3 cell(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        add_sphere(bed, 0, diameter * (cell + Vec3(0.5, 0.5, 0.5)), 0.5 * diameter, 1e-3);
      }
  return bed;
}

Vec3 on_ring(std::size_t sector, double height) {
  const double azimuth = 2.0 * pi * static_cast<double>(sector) / 8.0;
  return {0.04 * std::cos(azimuth), 0.04 * std::sin(azimuth), height};
}

Decomposition tool(std::vector<double> fractions) {
  return {Vec3(0.0, 0.0, 0.0), 0.0, std::move(fractions), 8, "", {}};
}

}  // namespace pmr::test
