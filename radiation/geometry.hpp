// Small geometry of triangles and hemispheres.
#pragma once
#include <optional>

#include "radiation/scene.hpp"

namespace pmr::radiation {

// Unit normal of the facing side [1].
Vec3 normal_of(const Triangle& triangle);

// [m2]
double area_of(const Triangle& triangle);

// Distance of a point from the triangle, interior included [m].
double distance_to(const Triangle& triangle, const Vec3& point);

// Where on the way from a to b the triangle is crossed, as a fraction in [0, 1].
std::optional<double> crossing(const Triangle& triangle, const Vec3& a, const Vec3& b);

// The point of the triangle nearest to `point`, kept off its edges by a thousandth of its size, so
// that rounding never carries a start point past a neighbouring wall [m].
Vec3 inside(const Triangle& triangle, const Vec3& point);

}  // namespace pmr::radiation
