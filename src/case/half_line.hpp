// Where a half line meets flat things.
#pragma once
#include <limits>

#include "case/stl.hpp"
#include "pmr/base/vec3.hpp"

namespace pmr::casefile {

struct HalfLine {
  Vec3 start;      // [m]
  Vec3 direction;  // [1] of any length
};

// How often its direction a half line goes until it meets the plane; infinite where it does not.
inline double way_to_plane(const HalfLine& line, const Vec3& point, const Vec3& normal) {
  const double approach = line.direction.dot(normal);
  const double way = approach == 0.0 ? -1.0 : (point - line.start).dot(normal) / approach;
  return way > 0.0 ? way : std::numeric_limits<double>::infinity();
}

// The same of a triangle, edges included (Moeller and Trumbore 1997).
inline double way_to_triangle(const HalfLine& line, const Triangle& t) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], h = line.direction.cross(v), s = line.start - t[0];
  const double scale = u.dot(h);
  if (scale == 0.0) return nowhere;
  const double a = s.dot(h) / scale;
  const Vec3 q = s.cross(u);
  const double b = line.direction.dot(q) / scale, way = v.dot(q) / scale;
  if (a >= 0.0 && b >= 0.0 && a + b <= 1.0 && way > 0.0) return way;
  return nowhere;
}

}  // namespace pmr::casefile
