#include "radiation/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace pmr::radiation {
namespace {

// Barycentric weights [1] of the foot of `point` in the plane of the triangle.
Vec3 weights_of(const Triangle& triangle, const Vec3& point) {
  const auto& [a, b, c] = triangle.corner;
  const Vec3 n = (b - a).cross(c - a);
  const double u = (c - b).cross(point - b).dot(n) / n.squaredNorm();
  const double v = (a - c).cross(point - c).dot(n) / n.squaredNorm();
  return {u, v, 1.0 - u - v};
}

double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 edge = b - a;
  const double along = std::clamp((point - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (point - a - along * edge).norm();
}

}  // namespace

Vec3 normal_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corner;
  return (b - a).cross(c - a).normalized();
}

double area_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corner;
  return 0.5 * (b - a).cross(c - a).norm();
}

double distance_to(const Triangle& triangle, const Vec3& point) {
  const auto& [a, b, c] = triangle.corner;
  if (weights_of(triangle, point).minCoeff() >= 0.0)
    return std::abs((point - a).dot(normal_of(triangle)));
  return std::min({distance_to_segment(a, b, point), distance_to_segment(b, c, point),
                   distance_to_segment(c, a, point)});
}

std::optional<double> crossing(const Triangle& triangle, const Vec3& a, const Vec3& b) {
  const auto& [p, q, r] = triangle.corner;
  const Vec3 n = (q - p).cross(r - p);  // of any length: only ratios count
  const double before = (a - p).dot(n), after = (b - p).dot(n);
  if (before * after > 0.0 || before == after) return std::nullopt;
  const double fraction = before / (before - after);
  // A little wider than the triangle: segments through a shared edge must not slip between two.
  if (weights_of(triangle, a + fraction * (b - a)).minCoeff() < -1e-9) return std::nullopt;
  return fraction;
}

Vec3 inside(const Triangle& triangle, const Vec3& point) {
  constexpr double margin = 1e-3;  // [1] of the triangle's size
  Vec3 w = weights_of(triangle, point).cwiseMax(margin);
  w /= w.sum();
  return w[0] * triangle.corner[0] + w[1] * triangle.corner[1] + w[2] * triangle.corner[2];
}

}  // namespace pmr::radiation
