// Surfaces as flat triangles, for the ray tracer and the pictures. In the frame of the body.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pmr/state/walls.hpp"

namespace pmr::coupling {

struct FlatTriangle {
  std::array<Vec3, 3> corner;  // [m], counter-clockwise seen from the facing side
  std::uint32_t patch;         // local: index along the segment * patches[1] + index round the axis
};

// Patches of a surface: patches[0] * patches[1] of a Revolved, else 1.
std::uint32_t patch_count(const Surface& surface);

// A Revolved becomes `segments` facets round the axis that circumscribe its circles, all surfaces
// of one axis in the same phase, so that a shared rim is shared exactly; `segments` is rounded up
// to a multiple of patches[1], so let patches[1] divide it (240: 1 2 3 4 5 6 8 10 12 15 16 ...).
// Patch 0 round the axis begins at `first_direction`. A Plane is cut to the domain's box.
std::vector<FlatTriangle> tessellate(const Surface& surface, const Vec3& domain_low,
                                     const Vec3& domain_high, int segments = 240);

// Unit vector across the axis from which angles are counted: +x if the axis is +-z [1].
Vec3 first_direction(const Vec3& axis);

// Area of each patch [m2], of the triangles.
std::vector<double> patch_areas(const std::vector<FlatTriangle>& triangles, std::uint32_t patches);

}  // namespace pmr::coupling
