#include "case/polytope.hpp"

#include <algorithm>

namespace pmr::casefile {
namespace {

constexpr double huge = 100.0;    // [m] half side of the square that clipping starts from
constexpr double same = 1.0e-12;  // [m] corners closer than this are one

// Sutherland & Hodgman (1974): the part of a convex polygon on the inner side of a plane.
std::vector<Vec3> clipped(const std::vector<Vec3>& corners, const HalfSpace& space) {
  std::vector<Vec3> kept;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3& a = corners[k];
    const Vec3& b = corners[(k + 1) % corners.size()];
    const double ha = (a - space.point).dot(space.inward);
    const double hb = (b - space.point).dot(space.inward);
    if (ha >= 0.0) kept.push_back(a);
    if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0))
      kept.push_back(a + (b - a) * (ha / (ha - hb)));
  }
  return kept;
}

std::vector<Vec3> without_repeats(const std::vector<Vec3>& corners) {
  std::vector<Vec3> kept;
  for (const Vec3& corner : corners)
    if (kept.empty() || (corner - kept.back()).norm() > same) kept.push_back(corner);
  while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= same) kept.pop_back();
  return kept;
}

// A large square in the plane of a half space, counter-clockwise about its inward normal.
std::vector<Vec3> square_in(const HalfSpace& space) {
  const Vec3& n = space.inward;
  const Vec3 u = (std::abs(n.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX()).cross(n).normalized();
  const Vec3 v = n.cross(u);
  return {space.point + huge * (u + v), space.point + huge * (v - u), space.point - huge * (u + v),
          space.point + huge * (u - v)};
}

}  // namespace

std::vector<Polygon> faces_of(std::span<const HalfSpace> half_spaces) {
  std::vector<Polygon> faces;
  for (std::size_t k = 0; k < half_spaces.size(); ++k) {
    std::vector<Vec3> corners = square_in(half_spaces[k]);
    for (std::size_t other = 0; other < half_spaces.size(); ++other)
      if (other != k) corners = clipped(corners, half_spaces[other]);
    corners = without_repeats(corners);
    if (corners.size() >= 3)
      faces.push_back({half_spaces[k].name, half_spaces[k].inward, std::move(corners)});
  }
  return faces;
}

std::vector<HalfSpace> box_half_spaces(const Vec3& low, const Vec3& high) {
  return {{"x-", low, Vec3::UnitX()},   {"x+", high, -Vec3::UnitX()}, {"y-", low, Vec3::UnitY()},
          {"y+", high, -Vec3::UnitY()}, {"z-", low, Vec3::UnitZ()},   {"z+", high, -Vec3::UnitZ()}};
}

Facet triangulated(const Polygon& polygon) {
  Facet facet{{}, polygon.normal};
  for (std::size_t k = 2; k < polygon.corners.size(); ++k)
    facet.triangles.push_back({polygon.corners[0], polygon.corners[k - 1], polygon.corners[k]});
  return facet;
}

}  // namespace pmr::casefile
