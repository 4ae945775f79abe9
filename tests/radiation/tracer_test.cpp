#include "radiation/tracer.hpp"

#include <catch2/catch.hpp>

#include "radiation/emission.hpp"
#include "radiation/exchange.hpp"
#include "radiation/sampling.hpp"
#include "scenes.hpp"

using namespace pmr;
using namespace pmr::radiation;

TEST_CASE("a sphere never hits itself, far from the middle of a large scene") {
  // 2 mm spheres at the corners of 200 mm: 50 diameters from the tree's origin.
  std::vector<Sphere> spheres;
  for (std::uint32_t k = 0; k < 8; ++k)
    spheres.push_back({0.2 * Vec3(k & 1, k >> 1 & 1, k >> 2 & 1), 1e-3, k});
  const Tracer tracer(spheres, {});
  for (std::uint32_t k = 0; k < 8; ++k) CHECK(view_counts(tracer, k, 200000, 1, 9)[k] == 0);
}

TEST_CASE("the excluded primitive is passed through") {
  const std::vector<Sphere> spheres{{Vec3::Zero(), 1.0, 10}, {Vec3(5.0, 0.0, 0.0), 1.0, 11}};
  const Scene scene(spheres, {});
  const Ray ray{Vec3(-3.0, 0.0, 0.0), Vec3::UnitX()};
  CHECK(scene.nearest(ray).node == 10);
  CHECK(scene.nearest(ray).distance == Approx(2.0).epsilon(1e-6));
  CHECK(scene.nearest(ray, 0).node == 11);
  CHECK(scene.nearest({ray.origin, ray.direction, 6.0}).node == 11);
  CHECK(scene.nearest({ray.origin, -ray.direction}).is_empty());
}

TEST_CASE("a ray that starts inside an overlapping neighbour hits that neighbour") {
  // 1 reaches 0.1 into 0, and 2 into 1 from behind, whose front would come first after 1's inside.
  const std::vector<Sphere> spheres{
      {Vec3::Zero(), 1.0, 0}, {Vec3(1.9, 0.0, 0.0), 1.0, 1}, {Vec3(3.8, 0.0, 0.0), 1.0, 2}};
  const Tracer tracer(spheres, {});
  const Vec3 x = Vec3::UnitX();
  const Hit hit = tracer.follow({0, x, x, x});
  CHECK(hit.node == 1);
  CHECK(hit.distance == 0.0);
  CHECK(hit.normal.x() == Approx(-1.0));
  CHECK(tracer.follow({0, -x, -x, -x}).is_empty());
}

TEST_CASE("what a wall cuts off a sphere lands on the wall") {
  // Closed box; the sphere sinks 0.05 into its floor and into a side.
  const std::vector<Sphere> spheres{{Vec3(0.95, 2.0, 0.95), 1.0, 0}};
  const auto walls = inward_box(Vec3::Zero(), Vec3::Constant(4.0), 1);
  const Tracer tracer(spheres, walls);
  const Hit down = tracer.follow({0, -Vec3::UnitZ(), -Vec3::UnitZ(), -Vec3::UnitZ()});
  CHECK(down.node == 5);  // low z
  CHECK(down.distance == 0.0);
  CHECK(down.normal.z() == 1.0);
  const auto counts = view_counts(tracer, 0, 1000000, 1, 8);
  CHECK(counts[0] == 0);
  CHECK(counts[7] == 0);
}

TEST_CASE("a wall covered by a sphere that sinks into it sends its rays into the sphere") {
  const std::vector<Sphere> spheres{{Vec3(0.0, 0.0, 0.95), 1.0, 0}};
  const std::vector<Triangle> floor{
      {{Vec3(-9.0, -9.0, 0.0), Vec3(9.0, -9.0, 0.0), Vec3(0.0, 9.0, 0.0)}, 1}};
  const Tracer tracer(spheres, floor);
  const Hit hit = tracer.follow({1, Vec3(0.1, 0.0, 0.0), Vec3::UnitZ(), Vec3::UnitZ()});
  CHECK(hit.node == 0);
  CHECK(hit.distance == 0.0);
}

TEST_CASE("a triangle is hit from both sides and its normal meets the ray") {
  const std::vector<Triangle> plate{
      {{Vec3(-1.0, -1.0, 0.0), Vec3(1.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0)}, 4}};
  const Scene scene({}, plate);
  CHECK(scene.nearest({Vec3::UnitZ(), -Vec3::UnitZ()}).normal.z() == 1.0);
  CHECK(scene.nearest({-Vec3::UnitZ(), Vec3::UnitZ()}).normal.z() == -1.0);
}

// Embree is the truth for rays that start outside of every other sphere; where two spheres are
// grazed within single precision the two may differ.
TEST_CASE("a ray meets first what Embree finds first, in a bed with walls and two sizes") {
  auto spheres = jittered_lattice(8);
  for (std::size_t i = 0; i < spheres.size(); i += 3) spheres[i].radius = 0.5e-3;
  const auto walls = inward_box(Vec3::Constant(-1.1e-3), Vec3::Constant(16.2e-3), 512);
  const Tracer tracer(spheres, walls);
  const Scene& scene = tracer.scene();
  std::size_t flown = 0, far = 0, differ = 0;
  for (std::uint32_t i = 0; i < spheres.size(); ++i)
    for (std::uint64_t k = 0; k < 400; ++k) {
      const Departure d = emit(scene, i, QuasiPoints(1, i, 0).point(k));
      const Vec3 start = spheres[i].centre + 1.0001 * spheres[i].radius * d.normal;
      const Hit plain = scene.nearest({start, d.direction}, i), hit = tracer.follow(d);
      if (hit.distance == 0.0) continue;  // within a neighbour
      ++flown;
      far += hit.distance > 2e-3 ? 1 : 0;
      differ += hit.primitive != plain.primitive ||
                        std::abs(hit.distance - plain.distance) > 1e-5 * scene.unit()
                    ? 1
                    : 0;
    }
  CHECK(flown > 190000);
  CHECK(far > 5000);  // past the lists
  CHECK(differ < flown / 10000);
}

TEST_CASE("cells know the sphere that covers a point as deepest") {
  auto spheres = jittered_lattice(9);
  for (std::size_t i = 0; i < spheres.size(); i += 5) spheres[i].radius = 2.2e-3;
  spheres.push_back({Vec3(0.5, 0.5, 0.5), 1e-3, 0});  // far out
  const Scene scene(spheres, {});
  const Cells cells(scene);
  Random random(5, Purpose::test, 1);
  std::size_t covered = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 across(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const Vec3 point = spheres[static_cast<std::size_t>(k) % spheres.size()].centre + 8e-3 * across;
    std::uint32_t expected = none;
    double deepest = 0.0;
    for (std::uint32_t j = 0; j < spheres.size(); ++j) {
      const double depth = spheres[j].radius - (point - spheres[j].centre).norm();
      if (depth > deepest) {
        deepest = depth;
        expected = j;
      }
    }
    covered += expected != none ? 1 : 0;
    CHECK(cells.covering(point) == expected);
  }
  CHECK(covered > 2000);
}

TEST_CASE("a turn is the library's cosine and sine to 1e-8") {
  for (int k = 0; k <= 4096; ++k) {
    const double v = k / 4096.0;
    const Turn at = turn(v);
    CHECK(std::abs(at.cosine - std::cos(2.0 * pi * v)) < 1e-8);
    CHECK(std::abs(at.sine - std::sin(2.0 * pi * v)) < 1e-8);
  }
}

TEST_CASE("diffuse directions have Lambert's moments about any normal") {
  // E cos = 2/3, E cos^2 = 1/2; variance of cos 1/2 - 4/9 = 1/18; 4 standard errors.
  const int n = 100000;
  for (const Vec3& normal :
       {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.6, -0.8, 0), Vec3(0.48, 0.6, -0.64)}) {
    Random random(3, Purpose::test, 1);
    Vec3 mean = Vec3::Zero();
    for (int k = 0; k < n; ++k) {
      const double u = random.uniform();
      mean += diffuse(normal, u, random.uniform()) / n;
    }
    CHECK(mean.dot(normal) == Approx(2.0 / 3.0).margin(4.0 * std::sqrt(1.0 / 18.0 / n)));
    // across: each component has variance 1/4, so the length of the mean is below 5 of its errors
    CHECK((mean - mean.dot(normal) * normal).norm() < 5.0 * std::sqrt(0.25 / n));
  }
}

TEST_CASE("Eight departures at a time are those of one at a time, bit for bit") {
  const std::vector<Sphere> spheres{{Vec3(0.1, -0.2, 0.3), 1e-3, 0}};
  const Scene scene(spheres, {});
  for (std::uint64_t node = 0; node < 200; ++node) {
    const QuasiPoints quasi(7, node, 3);
    for (const std::uint64_t first :
         {std::uint64_t{0}, std::uint64_t{4096}, std::uint64_t{81920}}) {
      const SphereDepartures eight = leave_sphere(quasi, first);
      for (int lane = 0; lane < lanes; ++lane) {
        const Departure one = emit(scene, 0, quasi.point(first + static_cast<std::uint64_t>(lane)));
        const Departure same = departure_of(scene, 0, eight, lane);
        REQUIRE(same.normal == one.normal);
        REQUIRE(same.direction == one.direction);
        REQUIRE(same.point == one.point);
      }
    }
  }
}
