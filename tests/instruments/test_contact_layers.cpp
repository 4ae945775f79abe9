// Contacts by layer against lattices whose contacts can be counted.
#include <catch2/catch.hpp>
#include <cmath>

#include "beds.hpp"
#include "instruments/contact_layers.hpp"

using namespace pmr;
using namespace pmr::instruments;

namespace {

// n x n x 6 spheres on a cubic lattice pressed a little, species 0 and 1 by turns upwards.
Particles sandwich(std::size_t n) {
  Particles bed = test::cubic_bed(n, 6, 0.002);
  for (std::size_t i = 0; i < bed.size(); ++i) {
    bed.position[i] *= 0.999;
    bed.species[i] = static_cast<SpeciesIndex>(i / (n * n) % 2);
  }
  return bed;
}

}  // namespace

TEST_CASE("Each sphere of a cubic lattice touches what a count says, layer by layer") {
  for (const std::size_t n : {std::size_t{1}, std::size_t{4}}) {
    const Particles bed = sandwich(n);
    const auto layers = contact_layers(bed, 2, Vec3::UnitZ(), 6);
    REQUIRE(layers.size() == 6);
    const double count = static_cast<double>(n);
    const double beside = 4.0 * (count - 1.0) / count;  // [1] of n (n - 1) rows and as many columns
    for (std::size_t k = 0; k < 6; ++k) {
      CAPTURE(n, k);
      const ContactLayer& layer = layers[k];
      const std::size_t own = 1 - k % 2, other = k % 2;  // the first is on top: species 1
      const double across = k == 0 || k == 5 ? 1.0 : 2.0;
      CHECK(layer.particles[own] == n * n);
      CHECK(layer.particles[other] == 0);
      CHECK(layer.touched(own, own) == Approx(beside));
      CHECK(layer.touched_of_others(own) == Approx(across));
      CHECK(layer.touched(own) == Approx(beside + across));
      CHECK(std::isnan(layer.touched(other)));
      CHECK(layer.top - layer.bottom == Approx(layers[0].top / 6.0));
    }
    CHECK(layers.back().bottom == Approx(0.0).margin(1e-12));
    const ContactLayer all = whole_bed(layers);
    CHECK(all.particles == std::vector<std::size_t>{3 * n * n, 3 * n * n});
    CHECK(all.touched_of_others(0) == Approx((1.0 + 2.0 + 2.0) / 3.0));
    CHECK(all.bottom == layers.back().bottom);
  }
}

TEST_CASE("Layers lie across gravity, whatever its direction, and hold all that there is") {
  Particles bed = sandwich(4);
  const auto upright = contact_layers(bed, 2, Vec3::UnitZ(), 3);
  for (Vec3& x : bed.position) x = Vec3(x.z(), x.x(), x.y()) + Vec3(0.5, 0.1, -0.2);
  const auto lying = contact_layers(bed, 2, Vec3::UnitX(), 3);
  REQUIRE(lying.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(lying[k].particles == upright[k].particles);
    CHECK(lying[k].partners == upright[k].partners);
  }
  test::add_sphere(bed, 0, Vec3(0.9, 0.1, -0.2), 0.001, 1e-6);  // far above what is called the bed
  const auto more = contact_layers(bed, 2, Vec3::UnitX(), 3);
  CHECK(more[0].particles[0] == lying[0].particles[0] + 1);
  CHECK(contact_layers({}, 2, Vec3::UnitX(), 3).empty());
}

TEST_CASE("The table of contacts names who touches whom") {
  const auto layers = contact_layers(sandwich(4), 2, Vec3::UnitZ(), 6);
  const io::Series table = contact_table(layers, {"bead", "granule"});
  CHECK(table.rows() == 6);
  CHECK(table.values("particles.granule")[0] == 16.0);
  CHECK(table.values("touched_by.granule")[0] == Approx(4.0));
  CHECK(table.values("touched_by.granule.bead")[1] != table.values("touched_by.granule.bead")[0]);
  CHECK(table.values("touched_by.bead.granule")[1] == Approx(2.0));
  CHECK(table.values("touched_by.bead.bead")[1] == Approx(3.0));
}
