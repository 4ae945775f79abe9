// A region to be filled, seen from above.
#pragma once
#include <cmath>

#include "pmr/state/case.hpp"

namespace pmr::physics {

struct Ground {
  Vec3 centre;                 // [m] of its lowest level
  double reach;                // [m] radius of a circle about the centre that holds it
  double height;               // [m]
  double inner = 0.0;          // [m] cylinder: radius kept free
  Eigen::Vector2d half{0, 0};  // [m] box: half sides, else 0

  // True when a sphere at x [m] stands over the region without its sides cutting it.
  bool holds(const Vec3& x, double radius) const {
    const Eigen::Vector2d d = (x - centre).head<2>();
    if (half[0] > 0.0)
      return std::abs(d[0]) + radius <= half[0] && std::abs(d[1]) + radius <= half[1];
    return d.norm() + radius <= reach && (inner == 0.0 || d.norm() - radius >= inner);
  }
};

inline Ground ground(const CylinderRegion& r) {
  return {r.base, r.radius, r.height, r.inner_radius};
}

inline Ground ground(const BoxRegion& r) {
  Ground g;
  g.centre = 0.5 * (r.low + r.high);
  g.centre[2] = r.low[2];
  g.half = 0.5 * (r.high - r.low).head<2>();
  g.reach = g.half.norm();
  g.height = r.high[2] - r.low[2];
  return g;
}

inline Ground ground(const Region& region) {
  return std::visit([](const auto& r) { return ground(r); }, region);
}

}  // namespace pmr::physics
