// Small scenes for the tests of radiation.
#pragma once
#include <vector>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"
#include "radiation/scene.hpp"

namespace pmr::radiation {

// Closed box that faces inwards; face k (low x, high x, low y, ...) has node first_node + k.
inline std::vector<Triangle> inward_box(const Vec3& low, const Vec3& high,
                                        std::uint32_t first_node) {
  std::vector<Triangle> triangles;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto corner = [&](int at_u, int at_v) {
        Vec3 p;
        p[axis] = side == 0 ? low[axis] : high[axis];
        p[u] = at_u == 0 ? low[u] : high[u];
        p[v] = at_v == 0 ? low[v] : high[v];
        return p;
      };
      const Vec3 a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      const std::uint32_t node = first_node + static_cast<std::uint32_t>(2 * axis + side);
      // a b c turns about +axis: right for the low side, to be mirrored for the high one.
      if (side == 0) {
        triangles.push_back({{a, b, c}, node});
        triangles.push_back({{a, c, d}, node});
      } else {
        triangles.push_back({{a, c, b}, node});
        triangles.push_back({{a, d, c}, node});
      }
    }
  return triangles;
}

// n^3 spheres of radius 1 mm, about 2.03 mm apart, a few overlap, nodes from 0.
inline std::vector<Sphere> jittered_lattice(int n) {
  std::vector<Sphere> spheres;
  Random random(7, Purpose::test, 0);
  for (int i = 0; i < n * n * n; ++i) {
    const int row = i / n, layer = row / n;
    const Vec3 place(i % n, row % n, layer);
    const Vec3 jitter(random.uniform(), random.uniform(), random.uniform());
    spheres.push_back({2.03e-3 * place + 1e-4 * jitter, 1e-3, static_cast<std::uint32_t>(i)});
  }
  return spheres;
}

inline double sphere_area(double radius) { return 4.0 * pi * radius * radius; }  // [m2]

}  // namespace pmr::radiation
