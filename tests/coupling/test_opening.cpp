// What particles hold as a run begins.
#include <catch2/catch.hpp>
#include <numbers>

#include "chemistry/redox.hpp"
#include "verify/coupling_scenes.hpp"

using namespace pmr;

namespace {

constexpr double granule_radius = 0.75e-3;  // [m]

// A granule whose density is stated at `density_delta` begins at delta 0.3.
Particles opened(double density_delta, bool mechanics_only) {
  Case c = verify::redox_case(granule_radius);
  c.materials.list[0].redox->density_delta = density_delta;
  c.models.mechanics_only = mechanics_only;
  verify::ThermalScene scene(std::move(c));
  scene.add(Vec3(0, 0, 0), 700.0);
  scene.begin();
  return scene.state.particles;
}

}  // namespace

TEST_CASE("formula unit per volume follows from the density and the delta that it is stated at") {
  const Material ferrite = verify::redox_case(granule_radius).materials.list[0];
  const double volume =
      4.0 / 3.0 * std::numbers::pi * granule_radius * granule_radius * granule_radius;
  for (const double stated_at : {0.0, 0.1665, 0.3, 0.5}) {
    const Particles p = opened(stated_at, false);
    // docs/theory.md 7.4, with 191.462 - 15.999 delta g/mol
    const double formula_units = ferrite.density * volume / (0.191462 - 0.015999 * stated_at);
    CHECK(p.formula_units[0] == Approx(formula_units).epsilon(1e-12));
    CHECK(p.mass[0] == Approx(formula_units * (0.191462 - 0.015999 * 0.3)).epsilon(1e-12));
  }
}

TEST_CASE("with mechanics alone a granule weighs what its density says, whatever its delta") {
  const Material ferrite = verify::redox_case(granule_radius).materials.list[0];
  const double volume =
      4.0 / 3.0 * std::numbers::pi * granule_radius * granule_radius * granule_radius;
  CHECK(opened(0.0, true).mass[0] == Approx(ferrite.density * volume).epsilon(1e-12));
}
