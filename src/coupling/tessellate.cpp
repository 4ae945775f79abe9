#include "coupling/tessellate.hpp"

#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::coupling {
namespace {

using Polygon = std::vector<Vec3>;  // [m] convex, flat

// The part of the polygon where side(p) >= 0 (Sutherland & Hodgman, CACM 17, 1974).
template <class Side>
Polygon cut(const Polygon& polygon, const Side& side) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3& p = polygon[k];
    const Vec3& q = polygon[(k + 1) % polygon.size()];
    const double at_p = side(p), at_q = side(q);  // [m]
    if (at_p >= 0.0) kept.push_back(p);
    if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
      kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

// What a shape is cut by.
struct Cutting {
  Vec3 low, high;                        // [m] an endless shape ends at this box
  std::array<std::uint32_t, 2> patches;  // of a turned shape: along the segment, round the axis
  std::uint32_t least_segments;          // round the axis
};

std::vector<FlatTriangle> triangles_of(const Plane& plane, const Cutting& by) {
  const Vec3 &low = by.low, &high = by.high;
  const Vec3 s = first_direction(plane.normal);
  const Vec3 t = plane.normal.cross(s);
  const Vec3 middle = 0.5 * (low + high);
  const Vec3 foot = middle - (middle - plane.point).dot(plane.normal) * plane.normal;
  const double reach = (high - low).norm();  // [m] half width of a square that spans the box
  Polygon polygon{foot - reach * s - reach * t, foot + reach * s - reach * t,
                  foot + reach * s + reach * t, foot - reach * s + reach * t};
  for (int k = 0; k < 3; ++k) {
    polygon = cut(polygon, [&](const Vec3& p) { return p[k] - low[k]; });
    polygon = cut(polygon, [&](const Vec3& p) { return high[k] - p[k]; });
  }
  std::vector<FlatTriangle> triangles;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    triangles.push_back({{polygon[0], polygon[k - 1], polygon[k]}, 0});
  return triangles;
}

// The circles' corner points: `segments` directions, longer than 1 so that edges touch the circle.
std::vector<Vec3> corners_round(const Vec3& axis, std::uint32_t segments) {
  const Vec3 s = first_direction(axis);
  const Vec3 t = axis.cross(s);
  const double stretch = 1.0 / std::cos(pi / segments);  // [1]
  std::vector<Vec3> corners;
  for (std::uint32_t k = 0; k < segments; ++k) {
    const double angle = 2.0 * pi * k / segments;  // [rad]
    corners.push_back(stretch * (std::cos(angle) * s + std::sin(angle) * t));
  }
  return corners;
}

std::vector<FlatTriangle> triangles_of(const Revolved& shape, const Cutting& by) {
  const auto& patches = by.patches;
  const std::uint32_t per_patch = (by.least_segments + patches[1] - 1) / patches[1];
  const std::uint32_t segments = per_patch * patches[1];
  const std::vector<Vec3> corners = corners_round(shape.axis, segments);
  const auto at = [&](std::uint32_t ring, std::uint32_t k) -> Vec3 {
    const double f = static_cast<double>(ring) / patches[0];
    const double r = ring == patches[0] ? shape.r1 : shape.r0 + f * (shape.r1 - shape.r0);
    const double z = ring == patches[0] ? shape.z1 : shape.z0 + f * (shape.z1 - shape.z0);
    return shape.origin + z * shape.axis + r * corners[k % segments];
  };
  std::vector<FlatTriangle> triangles;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t patch) {
    if ((b - a).cross(c - a).squaredNorm() == 0.0) return;  // at a tip or centre
    if (shape.facing > 0.0)
      triangles.push_back({{a, c, b}, patch});
    else
      triangles.push_back({{a, b, c}, patch});
  };
  for (std::uint32_t ring = 0; ring < patches[0]; ++ring)
    for (std::uint32_t k = 0; k < segments; ++k) {
      const std::uint32_t patch = ring * patches[1] + k / per_patch;
      add(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), patch);
      add(at(ring, k), at(ring + 1, k + 1), at(ring, k + 1), patch);
    }
  return triangles;
}

std::vector<FlatTriangle> triangles_of(const Facet& facet, const Cutting&) {
  std::vector<FlatTriangle> triangles;
  for (const auto& corner : facet.triangles) triangles.push_back({corner, 0});
  return triangles;
}

bool has_patches(const Plane&) { return false; }
bool has_patches(const Revolved&) { return true; }
bool has_patches(const Facet&) { return false; }

}  // namespace

std::uint32_t patch_count(const Surface& surface) {
  const bool divides = std::visit([](const auto& s) { return has_patches(s); }, surface.shape);
  return divides ? surface.patches[0] * surface.patches[1] : 1;
}

Vec3 first_direction(const Vec3& axis) {
  const bool upright = std::abs(axis.x()) < 0.9;
  const Vec3 across = upright ? Vec3::UnitX() : Vec3::UnitY();
  return (across - across.dot(axis) * axis).normalized();
}

std::vector<FlatTriangle> tessellate(const Surface& surface, const Vec3& domain_low,
                                     const Vec3& domain_high, int segments) {
  const Cutting by{domain_low, domain_high, surface.patches, static_cast<std::uint32_t>(segments)};
  return std::visit([&](const auto& s) { return triangles_of(s, by); }, surface.shape);
}

std::vector<double> patch_areas(const std::vector<FlatTriangle>& triangles, std::uint32_t patches) {
  std::vector<double> areas(patches, 0.0);
  for (const FlatTriangle& t : triangles)
    areas[t.patch] += 0.5 * (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm();
  return areas;
}

}  // namespace pmr::coupling
