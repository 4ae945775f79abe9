// Rays that leave a surface: the one step of exchange, reflections included. Soft spheres overlap
// each other and the walls; what leaves from inside a neighbour hits that neighbour at once.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "radiation/cells.hpp"
#include "radiation/scene.hpp"

namespace pmr::radiation {

struct Departure {
  std::uint32_t primitive;  // left; never hit again by the same flight
  Vec3 point;               // [m] on it (spheres: only the normal counts)
  Vec3 normal;              // [1] unit, of the side left
  Vec3 direction;           // [1] unit, within the hemisphere of the normal
};

// Where a flight ends; its point and normal are worked out only for rays that are reflected.
struct Landing {
  std::uint32_t primitive = none;  // `none`: the ray left the scene
  double distance = 0.0;           // [m] along the ray
  Ray ray;

  bool is_empty() const { return primitive == none; }
};

class Tracer {
 public:
  Tracer(std::span<const Sphere> spheres, std::span<const Triangle> triangles);

  const Scene& scene() const { return scene_; }
  Landing land(const Departure& departure) const;
  Hit follow(const Departure& departure) const { return hit_of(land(departure)); }
  Hit hit_of(const Landing& landing) const;

 private:
  Landing land_from_sphere(const Departure& departure) const;
  Landing land_from_wall(const Departure& departure) const;

  Scene scene_;
  Cells cells_;
};

}  // namespace pmr::radiation
