// Rays that leave a surface: the one step of exchange, reflections included. Soft spheres overlap
// each other and the walls; what leaves from inside a neighbour hits that neighbour at once.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "radiation/near_field.hpp"
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
  std::uint32_t covering(const Vec3& point) const;

  Scene scene_;
  SphereGrid grid_;
  NearField near_;
};

}  // namespace pmr::radiation
