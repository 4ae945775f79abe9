#include "radiation/tracer.hpp"

#include <algorithm>

#include "pmr/base/parallel.hpp"
#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

// Rays start this far above the surface, in radii (walls: in scene units): above the rounding of
// single precision over a hundred diameters (4e-6 radii), below every error that is looked at.
constexpr double lift = 1e-4;

}  // namespace

Tracer::Tracer(std::span<const Sphere> spheres, std::span<const Triangle> triangles)
    : scene_(spheres, triangles), grid_(scene_.spheres()) {
  std::vector<std::vector<std::uint32_t>> partners(spheres.size());
  parallel_blocks(spheres.size(), [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> found;
    for (std::size_t i = first; i < last; ++i) {
      const Sphere& s = spheres[i];
      const double reach = (1.0 + 2.0 * lift) * s.radius;  // [m]
      found.clear();
      grid_.find(scene_.spheres(), s.centre, reach, found);
      scene_.find_triangles(s.centre, reach, found);
      std::erase(found, static_cast<std::uint32_t>(i));
      std::sort(found.begin(), found.end());
      partners[i] = found;
    }
  });
  start_.assign(1, 0);
  for (const auto& list : partners) {
    partner_.insert(partner_.end(), list.begin(), list.end());
    start_.push_back(partner_.size());
  }
}

std::span<const std::uint32_t> Tracer::touching(std::uint32_t sphere) const {
  return {partner_.data() + start_[sphere], partner_.data() + start_[sphere + 1]};
}

// The sphere among the candidates whose surface is farthest above the point; empty if none is.
Hit Tracer::deepest(std::span<const std::uint32_t> candidates, const Vec3& point) const {
  Hit hit;
  double deepest = 0.0;  // [m]
  for (const std::uint32_t p : candidates) {
    if (!scene_.is_sphere(p)) continue;
    const Sphere& sphere = scene_.spheres()[p];
    const double depth = sphere.radius - (point - sphere.centre).norm();
    if (depth <= deepest) continue;
    deepest = depth;
    hit = {p, sphere.node, 0.0, point, (point - sphere.centre).normalized()};
  }
  return hit;
}

// What covers a start point of a sphere: a wall that cuts it off from the sphere's centre, or a
// neighbour that contains it.
Hit Tracer::obstacle(std::uint32_t sphere, const Vec3& start) const {
  const Vec3& centre = scene_.spheres()[sphere].centre;
  Hit hit;
  double nearest = 2.0;  // [1] of the way from the centre to the start
  for (const std::uint32_t p : touching(sphere)) {
    if (scene_.is_sphere(p)) continue;
    const Triangle& wall = scene_.triangle(p);
    const auto fraction = crossing(wall, centre, start);
    if (!fraction || *fraction >= nearest) continue;
    nearest = *fraction;
    const Vec3 n = normal_of(wall);
    const bool faces = n.dot(start - centre) < 0.0;
    hit = {p, wall.node, 0.0, centre + nearest * (start - centre), faces ? n : Vec3(-n)};
  }
  return hit.is_empty() ? deepest(touching(sphere), start) : hit;
}

Hit Tracer::follow(const Departure& departure) const {
  Hit hit;
  Vec3 start;  // [m]
  if (scene_.is_sphere(departure.primitive)) {
    const Sphere& sphere = scene_.spheres()[departure.primitive];
    start = sphere.centre + (1.0 + lift) * sphere.radius * departure.normal;
    if (!touching(departure.primitive).empty()) hit = obstacle(departure.primitive, start);
  } else {
    std::vector<std::uint32_t> around;
    start = inside(scene_.triangle(departure.primitive), departure.point) +
            lift * scene_.unit() * departure.normal;
    grid_.find(scene_.spheres(), start, 0.0, around);
    hit = deepest(around, start);
  }
  if (!hit.is_empty()) return hit;
  return scene_.nearest({start, departure.direction}, departure.primitive);
}

}  // namespace pmr::radiation
