#include "coupling/tessellate.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "pmr/base/constants.hpp"
#include "radiation/exchange.hpp"

using namespace pmr;
using namespace pmr::coupling;
using radiation::Triangle;

namespace {

const Vec3 low = Vec3::Constant(-1.0), high = Vec3::Constant(1.0);

Surface revolved(double r0, double z0, double r1, double z1, double facing,
                 std::array<std::uint32_t, 2> patches = {1, 1}) {
  Surface surface;
  surface.shape = Revolved{Vec3(0.01, -0.02, 0.03), Vec3::UnitZ(), r0, z0, r1, z1, facing};
  surface.patches = patches;
  return surface;
}

double total_area(const Surface& surface, int segments) {
  const auto areas = patch_areas(tessellate(surface, low, high, segments), patch_count(surface));
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::vector<Triangle> mesh(const std::vector<Surface>& surfaces) {
  std::vector<Triangle> triangles;
  for (std::uint32_t node = 0; node < surfaces.size(); ++node)
    for (const FlatTriangle& t : tessellate(surfaces[node], low, high))
      triangles.push_back({t.corner, node});
  return triangles;
}

// Rays from every triangle; those that leave the scene.
std::uint64_t leaks(const std::vector<Triangle>& triangles, std::uint64_t rays_each) {
  const radiation::Tracer tracer({}, triangles);
  std::uint64_t sum = 0;
  for (std::uint32_t k = 0; k < triangles.size(); ++k)
    sum += radiation::view_counts(tracer, k, rays_each, 1, 99)[98];
  return sum;
}

}  // namespace

TEST_CASE("facets that circumscribe have the area of the circle times (n/pi) tan(pi/n)") {
  // A regular n-gon about a circle of radius r has area n r^2 tan(pi/n) and side 2 r tan(pi/n).
  const double excess = 240.0 / pi * std::tan(pi / 240.0);
  CHECK(total_area(revolved(0.0, 0.0, 0.05, 0.0, -1.0), 240) ==
        Approx(pi * 0.05 * 0.05 * excess).epsilon(1e-12));
  CHECK(total_area(revolved(0.05, 0.0, 0.05, 0.1, -1.0, {4, 8}), 240) ==
        Approx(2.0 * pi * 0.05 * 0.1 * excess).epsilon(1e-12));
  // cone: with slant height l of the facets' middle lines, area n tan(pi/n) (r0 + r1) l
  CHECK(total_area(revolved(0.02, 0.0, 0.05, 0.04, 1.0, {3, 5}), 240) ==
        Approx(pi * 0.07 * 0.05 * excess).epsilon(1e-12));
  CHECK(excess - 1.0 < 1e-4);
}

TEST_CASE("patches share a cylinder equally, in any number") {
  const Surface cylinder = revolved(0.05, 0.0, 0.05, 0.1, -1.0, {3, 7});
  REQUIRE(patch_count(cylinder) == 21);
  const auto areas = patch_areas(tessellate(cylinder, low, high), 21);
  for (const double area : areas) CHECK(area == Approx(areas[0]).epsilon(1e-12));
}

TEST_CASE("patches are numbered along the segment first, from the first direction round") {
  const Surface cylinder = revolved(0.05, 0.0, 0.05, 0.1, -1.0, {2, 4});
  for (const FlatTriangle& t : tessellate(cylinder, low, high)) {
    const Vec3 middle = (t.corner[0] + t.corner[1] + t.corner[2]) / 3.0 - Vec3(0.01, -0.02, 0.03);
    const double turn = std::atan2(middle.y(), middle.x()) / (2.0 * pi);
    const int round = static_cast<int>(4.0 * (turn < 0.0 ? turn + 1.0 : turn));
    const int along = middle.z() < 0.05 ? 0 : 1;
    if (static_cast<int>(t.patch) != 4 * along + round) FAIL("patch " << t.patch);
  }
}

TEST_CASE("triangles turn counter-clockwise on the facing side") {
  const auto normal = [](const Surface& surface) -> Vec3 {
    const auto corner = tessellate(surface, low, high).front().corner;
    return (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
  };
  CHECK(normal(revolved(0.05, 0.0, 0.05, 0.1, -1.0)).x() < -0.99);  // inwards
  CHECK(normal(revolved(0.05, 0.0, 0.05, 0.1, 1.0)).x() > 0.99);
  CHECK(normal(revolved(0.0, 0.0, 0.05, 0.0, -1.0)).z() > 0.99);  // up
  CHECK(normal(revolved(0.0, 0.0, 0.05, 0.0, 1.0)).z() < -0.99);
  Surface plane;
  plane.shape = Plane{Vec3(0.0, 0.0, 0.2), -Vec3::UnitZ()};
  CHECK(normal(plane).z() == Approx(-1.0));
}

TEST_CASE("a plane is cut to the box of the domain") {
  Surface plane;
  plane.shape = Plane{Vec3(0.3, 0.1, 0.2), Vec3::UnitZ()};
  CHECK(total_area(plane, 240) == Approx(4.0).epsilon(1e-12));
  // across a diagonal of the cube: sides 2 and 2 sqrt(2)
  plane.shape = Plane{Vec3::Zero(), Vec3(1.0, 1.0, 0.0).normalized()};
  CHECK(total_area(plane, 240) == Approx(4.0 * std::sqrt(2.0)).epsilon(1e-12));
}

TEST_CASE("cylinder, disc and cone with shared rims let no ray out") {
  const std::vector<Surface> bin{
      revolved(0.0, 0.0, 0.05, 0.0, -1.0, {4, 1}), revolved(0.05, 0.0, 0.05, 0.06, -1.0, {3, 8}),
      revolved(0.05, 0.06, 0.02, 0.10, -1.0, {2, 12}), revolved(0.02, 0.10, 0.0, 0.10, -1.0)};
  const auto triangles = mesh(bin);
  CHECK(leaks(triangles, 1000000 / triangles.size() + 1) == 0);
}

TEST_CASE("a plug of cone, skirt and disc is closed to rays from its inside") {
  const std::vector<Surface> plug{revolved(0.0, 0.03, 0.02, 0.01, -1.0, {1, 6}),
                                  revolved(0.02, 0.0, 0.02, 0.01, -1.0),
                                  revolved(0.0, 0.0, 0.02, 0.0, -1.0)};
  auto triangles = mesh(plug);
  for (Triangle& t : triangles) {  // all inwards: the facing side of a plug is its outside
    const Vec3 n = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
    if (n.dot(Vec3(0.01, -0.02, 0.04) - t.corner[0]) < 0.0) std::swap(t.corner[1], t.corner[2]);
  }
  CHECK(leaks(triangles, 1000000 / triangles.size() + 1) == 0);
}
