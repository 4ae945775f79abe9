// A bed of spheres as layers that gas passes.
#include "physics/porous_bed.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::physics;

namespace {
// n x n x n spheres of radius r on a cubic lattice that just touch.
Particles cubic(int n, double r) {
  Particles p;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        p.id.push_back(static_cast<ParticleId>(p.id.size()));
        p.radius.push_back(r);
        p.position.emplace_back(2.0 * r * i, 2.0 * r * j, r * (1.0 + 2.0 * k));
      }
  return p;
}
}  // namespace

TEST_CASE("layers share out all of the bed's solid and surface") {
  const Particles p = cubic(6, 1e-3);
  for (const std::size_t layers : {1, 4, 5}) {
    const LayeredBed bed = cut_in_layers(p, layers);
    double volume = 0.0, surface = 0.0;
    for (const BedLayer& layer : bed.layers) {
      volume += layer.solid_volume;
      surface += layer.surface;
      CHECK(layer.sauter_diameter == Approx(2e-3).epsilon(1e-12));
    }
    CHECK(volume == Approx(216 * 4.0 / 3.0 * pi * 1e-9).epsilon(1e-12));
    CHECK(surface == Approx(216 * 4.0 * pi * 1e-6).epsilon(1e-12));
  }
}

TEST_CASE("a lattice has its own porosity, but for the hull's round corners") {
  // Square hull of side 12 mm with corners of radius 1 mm; layers of whole lattice planes. Circles
  // stand as polygons of 16 corners of the same area, 1.3 % wider at their corners.
  const LayeredBed bed = cut_in_layers(cubic(6, 1e-3), 6);
  const double hull = 144e-6 - (4.0 - pi) * 1e-6;
  for (const BedLayer& layer : bed.layers) {
    CHECK(layer.area == Approx(hull).epsilon(5e-3));
    CHECK(layer.porosity() ==
          Approx(1.0 - 36.0 * 4.0 / 3.0 * pi * 1e-9 / (hull * 2e-3)).epsilon(5e-3));
  }
  for (std::size_t i = 0; i < 216; ++i) CHECK(bed.layer_of[i] == i % 6);
}

TEST_CASE("layers lie across whatever way is up") {
  const Particles along_z = cubic(5, 1e-3);
  const LayeredBed wanted = cut_in_layers(along_z, 3);
  Particles along_x = along_z;
  for (Vec3& x : along_x.position) x = Vec3(x.z(), x.y(), -x.x());  // z is now x
  const LayeredBed bed = cut_in_layers(along_x, 3, Vec3::UnitX());
  REQUIRE(bed.layers.size() == wanted.layers.size());
  CHECK(bed.layer_of == wanted.layer_of);
  for (std::size_t k = 0; k < bed.layers.size(); ++k) {
    CHECK(bed.layers[k].solid_volume == Approx(wanted.layers[k].solid_volume).epsilon(1e-9));
    CHECK(bed.layers[k].height == Approx(wanted.layers[k].height).epsilon(1e-9));
    CHECK(bed.layers[k].area == Approx(wanted.layers[k].area).epsilon(1e-3));
  }
}

TEST_CASE("no layer is thinner than the largest sphere, and one sphere is a bed") {
  CHECK(cut_in_layers(cubic(6, 1e-3), 100).layers.size() == 6);
  const LayeredBed bed = cut_in_layers(cubic(1, 1e-3), 12);
  REQUIRE(bed.layers.size() == 1);
  CHECK(bed.layers[0].porosity() == Approx(1.0 / 3.0).epsilon(1e-6));  // a sphere in its cylinder
}

TEST_CASE("permeability and slip of a bed of 2 mm spheres") {
  const double K = carman_kozeny(2e-3, 0.41);
  CHECK(K == Approx(4.4e-9).epsilon(0.01));  // by hand: d^2 psi^3/(180 (1 - psi)^2)
  const double r = capillary_radius(K, 0.41, 1.5);
  CHECK(0.41 * r * r / (8.0 * 1.5) == Approx(K).epsilon(1e-14));
  CHECK(slip_factor(0.25 * r, r) == Approx(2.0).epsilon(1e-14));
}
