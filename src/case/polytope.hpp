// Convex bodies from half spaces, and flat surfaces from polygons.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pmr/state/walls.hpp"

namespace pmr::casefile {

// Points x with (x - point) . inward >= 0.
struct HalfSpace {
  std::string name;
  Vec3 point;   // [m]
  Vec3 inward;  // [1] unit
};

struct Polygon {
  std::string name;
  Vec3 normal;                // [1] unit, inwards
  std::vector<Vec3> corners;  // [m] counter-clockwise seen from the inside
};

// The faces of the intersection, one for each half space that bounds it, inwards.
std::vector<Polygon> faces_of(std::span<const HalfSpace> half_spaces);

std::vector<HalfSpace> box_half_spaces(const Vec3& low, const Vec3& high);  // [m]

// Fan of triangles of a convex polygon.
Facet triangulated(const Polygon& polygon);

}  // namespace pmr::casefile
