#include "radiation/emission.hpp"

#include <algorithm>

#include "pmr/base/constants.hpp"
#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

double area(const Scene& scene, std::uint32_t primitive) {
  if (!scene.is_sphere(primitive)) return area_of(scene.triangle(primitive));
  const double r = scene.spheres()[primitive].radius;
  return 4.0 * pi * r * r;
}

}  // namespace

Emitters::Emitters(const Scene& scene, std::uint32_t nodes) : start_(nodes + 1, 0) {
  const auto count = static_cast<std::uint32_t>(scene.primitives());
  for (std::uint32_t p = 0; p < count; ++p) ++start_[scene.node_of(p) + 1];
  for (std::uint32_t node = 0; node < nodes; ++node) start_[node + 1] += start_[node];
  std::vector<std::uint64_t> next(start_.begin(), start_.end() - 1);
  primitive_.resize(count);
  for (std::uint32_t p = 0; p < count; ++p) primitive_[next[scene.node_of(p)]++] = p;
  area_until_.resize(count);
  for (std::uint32_t node = 0; node < nodes; ++node) {
    double sum = 0.0;  // [m2]
    for (std::uint64_t k = start_[node]; k < start_[node + 1]; ++k)
      area_until_[k] = sum += area(scene, primitive_[k]);
  }
}

std::vector<std::uint32_t> Emitters::in_order() const {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node + 1 < start_.size(); ++node)
    if (has_surface(node)) nodes.push_back(node);
  const auto first = [&](std::uint32_t node) { return primitive_[start_[node]]; };
  std::sort(nodes.begin(), nodes.end(),
            [&](std::uint32_t a, std::uint32_t b) { return first(a) < first(b); });
  return nodes;
}

std::uint32_t Emitters::pick(std::uint32_t node, double fraction) const {
  const std::uint64_t first = start_[node], last = start_[node + 1] - 1;
  if (first == last) return primitive_[first];
  const auto begin = area_until_.begin();
  const auto at =
      std::upper_bound(begin + static_cast<std::ptrdiff_t>(first),
                       begin + static_cast<std::ptrdiff_t>(last), fraction * area_until_[last]);
  return primitive_[static_cast<std::size_t>(at - begin)];
}

std::optional<std::uint32_t> Emitters::only_sphere(const Scene& scene, std::uint32_t node) const {
  const bool is_one = start_[node + 1] == start_[node] + 1;
  if (!is_one || !scene.is_sphere(primitive_[start_[node]])) return std::nullopt;
  return primitive_[start_[node]];
}

Departure departure_of(const Scene& scene, std::uint32_t sphere, const SphereDepartures& eight,
                       int lane) {
  const Sphere& ball = scene.spheres()[sphere];
  const Vec3 normal(eight.normal[0][lane], eight.normal[1][lane], eight.normal[2][lane]);
  return {sphere, ball.centre + ball.radius * normal, normal,
          Vec3(eight.direction[0][lane], eight.direction[1][lane], eight.direction[2][lane])};
}

Departure emit(const Scene& scene, std::uint32_t primitive, const std::array<double, 4>& u) {
  if (scene.is_sphere(primitive)) {
    const Sphere& sphere = scene.spheres()[primitive];
    const Vec3 normal = on_sphere(u[0], u[1]);
    return {primitive, sphere.centre + sphere.radius * normal, normal, diffuse(normal, u[2], u[3])};
  }
  const Triangle& wall = scene.triangle(primitive);
  const Vec3 w = in_triangle(u[0], u[1]);
  const Vec3 normal = normal_of(wall);
  const Vec3 point = w[0] * wall.corner[0] + w[1] * wall.corner[1] + w[2] * wall.corner[2];
  return {primitive, point, normal, diffuse(normal, u[2], u[3])};
}

}  // namespace pmr::radiation
