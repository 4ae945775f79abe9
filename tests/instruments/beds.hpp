// Beds with known answers.
#pragma once
#include <cstddef>

#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::test {

// One sphere more, at rest.
void add_sphere(Particles& bed, SpeciesIndex species, const Vec3& position, double radius,
                double mass);

// n x n x layers spheres that touch on a simple cubic lattice; lowest spheres rest on z = 0.
Particles cubic_bed(std::size_t n, std::size_t layers, double diameter);

// A ring of eight positions, one in the middle of each sector, at a height [m].
Vec3 on_ring(std::size_t sector, double height);

// Layers of the given fractions, eight sectors, ramp along +x.
Decomposition tool(std::vector<double> fractions);

}  // namespace pmr::test
