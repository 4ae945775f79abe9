// The angle of repose of heaps whose angle is known: spheres packed at random into a cone.
#include <catch2/catch.hpp>
#include <cmath>

#include "beds.hpp"
#include "instruments/heap.hpp"
#include "physics/deposition.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::instruments;

namespace {

constexpr double degree = pi / 180.0;

struct Cone {
  double angle;   // [rad]
  double foot;    // [m]
  double summit;  // [m] what lies higher is cut off
};

// Spheres let down one by one (physics/deposition.hpp), and all of them taken away that stand out
// of the cone.
Particles packed(const Cone& cone, double d, std::uint64_t seed) {
  const double slope = std::tan(cone.angle);
  const auto ground = physics::ground(CylinderRegion{Vec3::Zero(), cone.foot + d, 0.0, 1.0});
  const double volume = pi * ground.reach * ground.reach * (slope * cone.foot + d);
  const std::vector<double> radii(static_cast<std::size_t>(0.5 * volume / (pi / 6.0 * d * d * d)),
                                  0.5 * d);
  Particles heap;
  for (const Vec3& x : physics::deposit(ground, radii, seed, 0))
    if (x.z() <= std::min(cone.summit, (cone.foot - x.head<2>().norm()) * slope))
      test::add_sphere(heap, 0, x, 0.5 * d, 1.0);
  return heap;
}

const HeapInstrument tool{Vec3::Zero(), 0.1, 24, 3e-3};

}  // namespace

// The lab's angles of repose of the demonstrator study.
TEST_CASE("The angle of a cone of spheres is found to half a degree, cut tops and strays or not") {
  for (const double angle : {20.3, 26.8, 32.7})
    for (const double cut : {1.0, 0.7}) {
      const Cone cone{angle * degree, 70e-3, cut * 70e-3 * std::tan(angle * degree)};
      Particles heap = packed(cone, 3e-3, 7);
      Random random(3, Purpose::test, 1);
      for (int k = 0; k < 12; ++k)  // strays in the air and far out on the plate
        test::add_sphere(heap, 0,
                         Vec3(0.14 * random.uniform() - 0.07, 0.14 * random.uniform() - 0.07,
                              k % 2 == 0 ? 1.5e-3 : 45e-3),
                         1.5e-3, 1.0);
      const auto found = measure_heap(heap, tool);
      REQUIRE(found);
      INFO(angle << " deg, cut at " << cut << ": " << found->angle / degree << " +- "
                 << found->scatter / degree);
      CHECK(found->angle / degree == Approx(angle).margin(0.5));
      CHECK(found->scatter / degree < 0.5);
      CHECK(found->scatter == Approx(found->sector_deviation / std::sqrt(24.0)).epsilon(1e-9));
      CHECK_FALSE(found->is_edged);
    }
}

TEST_CASE("The scatter of a heap's angle covers the differences between heaps of other seeds") {
  const Cone cone{26.8 * degree, 45e-3, 1.0};
  double sum = 0.0, squares = 0.0, scatter = 0.0;
  constexpr int heaps = 8;
  for (int k = 0; k < heaps; ++k) {
    const auto found = measure_heap(packed(cone, 3e-3, 20 + static_cast<std::uint64_t>(k)), tool);
    REQUIRE(found);
    sum += found->angle / degree;
    squares += found->angle / degree * (found->angle / degree);
    scatter += found->scatter / degree / heaps;
  }
  const double between = std::sqrt((squares - sum * sum / heaps) / (heaps - 1));
  CHECK(scatter > 0.4 * between);
  CHECK(scatter < 4.0 * between + 0.2);
}

TEST_CASE("A heap that reaches the rim of its plate says so, and a flat layer is no heap") {
  const Cone cone{26.8 * degree, 45e-3, 1.0};
  HeapInstrument small = tool;
  small.radius = 42e-3;
  REQUIRE(measure_heap(packed(cone, 3e-3, 1), small));
  CHECK(measure_heap(packed(cone, 3e-3, 1), small)->is_edged);
  CHECK_FALSE(measure_heap(Particles{}, tool));
  CHECK_FALSE(measure_heap(test::cubic_bed(12, 1, 3e-3), tool));
}

// A wedge of known slope between walls at y = +-15 mm, from x = 0 on, with a tongue of one layer.
TEST_CASE("A plane heap has the angle and the reach of its wedge") {
  const double d = 2e-3, slope = std::tan(25.0 * degree), foot = 80e-3, tongue = 100e-3;
  Particles heap;
  Random random(5, Purpose::test, 2);
  for (double x = 0.5 * d; x < tongue; x += 0.5 * d)
    for (double y = -15e-3 + 0.5 * d; y < 15e-3; y += 0.5 * d) {
      const double top = std::max(d, (foot - x) * slope);
      test::add_sphere(heap, 0, Vec3(x, y, top - 0.5 * d + 1e-5 * random.uniform()), 0.5 * d, 1.0);
    }
  test::add_sphere(heap, 0, Vec3(0.15, 0.0, 0.5 * d), 0.5 * d, 1.0);  // a stray far out
  const PlaneHeap plane{Vec3::UnitX(), 30e-3};
  const auto found = measure_heap(heap, {Vec3::Zero(), 0.3, 4, d, plane});
  REQUIRE(found);
  CHECK(found->angle / degree == Approx(25.0).margin(0.5));
  CHECK(found->reach == Approx(tongue).margin(d));
  CHECK_FALSE(found->is_edged);
}
