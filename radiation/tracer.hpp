// Rays that leave a surface: the one step of exchange, reflections included. Soft spheres overlap
// each other and the walls; what leaves from inside a neighbour hits that neighbour at once.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "radiation/scene.hpp"
#include "radiation/sphere_grid.hpp"

namespace pmr::radiation {

struct Departure {
  std::uint32_t primitive;  // left; never hit again by the same flight
  Vec3 point;               // [m] on it (spheres: only the normal counts)
  Vec3 normal;              // [1] unit, of the side left
  Vec3 direction;           // [1] unit, within the hemisphere of the normal
};

class Tracer {
 public:
  Tracer(std::span<const Sphere> spheres, std::span<const Triangle> triangles);

  const Scene& scene() const { return scene_; }
  Hit follow(const Departure& departure) const;

 private:
  std::span<const std::uint32_t> touching(std::uint32_t sphere) const;
  Hit obstacle(std::uint32_t sphere, const Vec3& start) const;
  Hit deepest(std::span<const std::uint32_t> candidates, const Vec3& point) const;

  Scene scene_;
  SphereGrid grid_;
  std::vector<std::uint64_t> start_;    // [spheres + 1] into partner_
  std::vector<std::uint32_t> partner_;  // primitives that reach into each sphere, ascending
};

}  // namespace pmr::radiation
