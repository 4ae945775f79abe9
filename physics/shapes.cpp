#include "physics/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace pmr::physics {
namespace {

Vec3 closest(const Plane& plane, const Vec3& x) {
  return x - (x - plane.point).dot(plane.normal) * plane.normal;
}

// In the half plane of x: nearest point of the segment (r, z).
Vec3 closest(const Revolved& shape, const Vec3& x) {
  const Vec3 d = x - shape.origin;
  const double z = d.dot(shape.axis);
  const Vec3 radial = d - z * shape.axis;
  const double r = radial.norm();
  const Vec3 outwards = r > 0.0 ? Vec3(radial / r) : Vec3(shape.axis.unitOrthogonal());
  const double dr = shape.r1 - shape.r0, dz = shape.z1 - shape.z0;
  const double along = ((r - shape.r0) * dr + (z - shape.z0) * dz) / (dr * dr + dz * dz);
  const double t = std::clamp(along, 0.0, 1.0);
  return shape.origin + (shape.z0 + t * dz) * shape.axis + (shape.r0 + t * dr) * outwards;
}

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Vec3 ab = b - a;
  return a + std::clamp((x - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab;
}

// Foot of x in the triangle's plane if inside, else the nearest of the three edges' points.
Vec3 closest_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& n, const Vec3& x) {
  Vec3 best = Vec3::Zero();
  double best_squared = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = triangle[k];
    const Vec3& b = triangle[(k + 1) % 3];
    if ((b - a).cross(x - a).dot(n) >= 0.0) continue;  // inside of this edge
    const Vec3 q = closest_on_segment(a, b, x);
    const double squared = (x - q).squaredNorm();
    if (best_squared < 0.0 || squared < best_squared) {
      best = q;
      best_squared = squared;
    }
  }
  return best_squared < 0.0 ? Vec3(x - (x - triangle[0]).dot(n) * n) : best;
}

// Nearest point of `count` triangles of a facet, the k-th of which is number(k).
template <class Number>
Vec3 closest_of(const Facet& facet, std::size_t count, const Number& number, const Vec3& x) {
  Vec3 best = facet.triangles[number(0)][0];
  double best_squared = (x - best).squaredNorm();
  const double height = (x - best).dot(facet.normal);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 q = closest_on_triangle(facet.triangles[number(k)], facet.normal, x);
    const double squared = (x - q).squaredNorm();
    if (squared >= best_squared) continue;
    best = q;
    best_squared = squared;
    if (best_squared <= height * height) break;  // the foot itself: nothing is nearer
  }
  return best;
}

Vec3 closest(const Facet& facet, const Vec3& x) {
  return closest_of(
      facet, facet.triangles.size(), [](std::size_t k) { return k; }, x);
}

Box box_of(const Plane&) {
  const Vec3 far = Vec3::Constant(std::numeric_limits<double>::infinity());
  return {-far, far};
}

// A ring of radius r about unit axis a reaches r sqrt(1 - a_k^2) along axis k.
Box box_of(const Revolved& shape) {
  const Vec3 reach = (Vec3::Ones() - shape.axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  const Vec3 c0 = shape.origin + shape.z0 * shape.axis, c1 = shape.origin + shape.z1 * shape.axis;
  return {(c0 - shape.r0 * reach).cwiseMin(c1 - shape.r1 * reach),
          (c0 + shape.r0 * reach).cwiseMax(c1 + shape.r1 * reach)};
}

Box box_of(const Facet& facet) {
  Box box{facet.triangles.front()[0], facet.triangles.front()[0]};
  for (const auto& triangle : facet.triangles)
    for (const Vec3& corner : triangle) {
      box.low = box.low.cwiseMin(corner);
      box.high = box.high.cwiseMax(corner);
    }
  return box;
}

bool is_beyond(const Plane& plane, const Vec3& x, double reach) {
  return std::abs((x - plane.point).dot(plane.normal)) > reach;
}
bool is_beyond(const Revolved&, const Vec3&, double) { return false; }  // its box tells enough
bool is_beyond(const Facet& facet, const Vec3& x, double reach) {
  return std::abs((x - facet.triangles.front()[0]).dot(facet.normal)) > reach;
}

}  // namespace

Vec3 closest_point(const Shape& shape, const Vec3& x) {
  return std::visit([&](const auto& s) { return closest(s, x); }, shape);
}

Vec3 closest_point(const Facet& facet, std::span<const std::uint32_t> triangles, const Vec3& x) {
  return closest_of(
      facet, triangles.size(), [&](std::size_t k) { return triangles[k]; }, x);
}

bool is_surely_beyond(const Shape& shape, const Vec3& x, double reach) {
  return std::visit([&](const auto& s) { return is_beyond(s, x, reach); }, shape);
}

Box bounding_box(const Shape& shape) {
  return std::visit([](const auto& s) { return box_of(s); }, shape);
}

}  // namespace pmr::physics
