// Geometry of wall shapes, in the frame of their body.
#pragma once
#include <cstdint>
#include <span>

#include "pmr/state/walls.hpp"

namespace pmr::physics {

// Point of the shape nearest to x [m]; on the axis of a revolved shape, one of the nearest.
Vec3 closest_point(const Shape& shape, const Vec3& x);

// The same of some triangles of a facet, of which there must be one at least.
Vec3 closest_point(const Facet& facet, std::span<const std::uint32_t> triangles, const Vec3& x);

// True when the shape is surely farther from x than reach [m]; cheap, may be false nevertheless.
bool is_surely_beyond(const Shape& shape, const Vec3& x, double reach);

struct Box {
  Vec3 low, high;  // [m]
};

// Smallest box with sides along the frame's axes that holds the shape; a plane's is infinite.
Box bounding_box(const Shape& shape);

}  // namespace pmr::physics
