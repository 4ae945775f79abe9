#include "physics/wall_feet.hpp"

#include <span>

namespace pmr::physics {
namespace {

// Parts of one surface: its only one, or triangles of a facet.
Vec3 closest_among(const Shape& shape, std::span<const WallPart> parts, const Vec3& x) {
  if (parts[0].triangle == WallPart::whole) return closest_point(shape, x);
  std::vector<std::uint32_t> triangles;
  for (const WallPart& part : parts) triangles.push_back(part.triangle);
  return closest_point(std::get<Facet>(shape), triangles, x);
}

}  // namespace

WallFeet::WallFeet(const Walls& walls, double t) : walls_(walls), tree_(walls) {
  for (const Body& body : walls.bodies) pose_.push_back(pose(body.motion, t));
  for (const Surface& surface : walls.surfaces) present_.push_back(is_present(surface, t));
}

std::vector<Foot> WallFeet::near(const Vec3& x, double radius, double reach) const {
  const std::vector<WallPart> parts = tree_.near(x, reach, pose_);
  const auto surface_of = [&](std::uint32_t first) {
    std::uint32_t last = first;
    while (last < parts.size() && parts[last].surface == parts[first].surface) ++last;
    return std::span(parts).subspan(first, last - first);
  };
  const auto closest = [&](std::span<const WallPart> of, const Vec3& to) {
    const Surface& surface = walls_.surfaces[of[0].surface];
    const Pose& p = pose_[surface.body];
    return p.to_world(closest_among(surface.shape, of, p.to_body(to)));
  };
  std::vector<Foot> feet;
  for (std::uint32_t first = 0; first < parts.size();) {
    const auto of = surface_of(first);
    const std::uint32_t place = first;
    first += static_cast<std::uint32_t>(of.size());
    if (!present_[of[0].surface]) continue;
    const Vec3 point = closest(of, x);
    const double distance = (point - x).norm();
    if (distance < reach && distance > 0.0)
      feet.push_back({of[0].surface, place, point, (point - x) / distance, distance});
  }
  keep_one_per_surface(feet, radius, [&](const Foot& foot, const Vec3& q) {
    return (closest(surface_of(foot.place), q) - q).norm();
  });
  return feet;
}

}  // namespace pmr::physics
