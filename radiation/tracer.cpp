#include "radiation/tracer.hpp"

#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

// Rays start this far above the surface, in radii (walls: in scene units): above the rounding of
// single precision over a hundred diameters (4e-6 radii), below every error that is looked at.
constexpr double lift = 1e-4;

}  // namespace

Tracer::Tracer(std::span<const Sphere> spheres, std::span<const Triangle> triangles)
    : scene_(spheres, triangles), grid_(scene_.spheres()), near_(scene_, grid_) {}

// The sphere whose surface is farthest above the point; `none` if none is.
std::uint32_t Tracer::covering(const Vec3& point) const {
  std::vector<std::uint32_t> around;
  grid_.find(scene_.spheres(), point, 0.0, around);
  std::uint32_t covers = none;
  double deepest = 0.0;  // [m]
  for (const std::uint32_t p : around) {
    const Sphere& sphere = scene_.spheres()[p];
    const double depth = sphere.radius - (point - sphere.centre).norm();
    if (depth <= deepest) continue;
    deepest = depth;
    covers = p;
  }
  return covers;
}

Hit Tracer::follow(const Departure& departure) const {
  const Vec3& direction = departure.direction;
  if (scene_.is_sphere(departure.primitive)) {
    const Sphere& sphere = scene_.spheres()[departure.primitive];
    const Vec3 start = sphere.centre + (1.0 + lift) * sphere.radius * departure.normal;
    if (const auto met = near_.first(departure.primitive, start, direction)) {
      const bool is_cut =
          met->distance == 0.0;  // then the wall's side that faces the centre counts
      return scene_.hit_at(met->primitive, met->distance,
                           {start, is_cut ? departure.normal : direction});
    }
    return scene_.nearest({start, direction}, departure.primitive);
  }
  const Vec3 start = inside(scene_.triangle(departure.primitive), departure.point) +
                     lift * scene_.unit() * departure.normal;
  const std::uint32_t cover = covering(start);
  if (cover != none) return scene_.hit_at(cover, 0.0, {start, direction});
  return scene_.nearest({start, direction}, departure.primitive);
}

}  // namespace pmr::radiation
