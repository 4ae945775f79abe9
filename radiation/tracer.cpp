#include "radiation/tracer.hpp"

#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

// Rays start this far above the surface, in radii (walls: in scene units): above the rounding of
// single precision over a hundred diameters (4e-6 radii), below every error that is looked at.
constexpr double lift = 1e-4;

Landing landing_of(const Hit& hit, const Ray& ray) { return {hit.primitive, hit.distance, ray}; }

}  // namespace

Tracer::Tracer(std::span<const Sphere> spheres, std::span<const Triangle> triangles)
    : scene_(spheres, triangles), cells_(scene_) {}

Landing Tracer::land(const Departure& departure) const {
  return scene_.is_sphere(departure.primitive) ? land_from_sphere(departure)
                                               : land_from_wall(departure);
}

Landing Tracer::land_from_sphere(const Departure& departure) const {
  const Sphere& sphere = scene_.spheres()[departure.primitive];
  const Vec3 start = sphere.centre + (1.0 + lift) * sphere.radius * departure.normal;
  const Ray ray{start, departure.direction};
  const std::uint32_t wall = cells_.wall_within(departure.primitive, start);
  if (wall != none) return {wall, 0.0, {start, departure.normal}};  // its side towards the centre
  if (const auto met = cells_.first(start, departure.direction))
    return {met->primitive, met->distance, ray};
  return landing_of(scene_.nearest(ray, departure.primitive), ray);
}

Landing Tracer::land_from_wall(const Departure& departure) const {
  const Vec3 start = inside(scene_.triangle(departure.primitive), departure.point) +
                     lift * scene_.unit() * departure.normal;
  const Ray ray{start, departure.direction};
  const std::uint32_t cover = cells_.covering(start);
  if (cover != none) return {cover, 0.0, ray};
  if (const auto met = cells_.first(start, departure.direction, departure.primitive))
    return {met->primitive, met->distance, ray};
  return landing_of(scene_.nearest(ray, departure.primitive), ray);
}

Hit Tracer::hit_of(const Landing& landing) const {
  return landing.is_empty() ? Hit{}
                            : scene_.hit_at(landing.primitive, landing.distance, landing.ray);
}

}  // namespace pmr::radiation
