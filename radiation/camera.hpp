// Orthographic pictures of spheres and walls, cut open at a plane: which node each pixel shows.
//   const auto pixels = photograph(spheres, triangles, camera);   // row by row from the top left
//   shade = 0.4 + 0.6 * max(0, pixel.normal.dot(light)); colour by pixel.node; node == none: sky.
// Smooth edges: ask for twice the pixels each way and average four.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pmr/base/vec3.hpp"
#include "radiation/scene.hpp"

namespace pmr::radiation {

struct Camera {
  Vec3 eye;         // [m] middle of the picture's plane, from where the rays start
  Vec3 target;      // [m] looked at; only its direction from the eye matters
  Vec3 up;          // [1] shown upwards, not along the view
  double width;     // [m] of the picture, left to right
  int pixels_x;     // [1]
  int pixels_y;     // [1] square pixels: the height is width * pixels_y / pixels_x
  Vec3 cut_point;   // [m] on the cutting plane
  Vec3 cut_normal;  // [1] towards the half space that is taken away; zero: nothing is cut
};

struct PixelHit {
  std::uint32_t node = none;       // `none`: nothing there
  std::uint32_t primitive = none;  // index of the sphere, or number of spheres + triangle
  double distance = std::numeric_limits<double>::infinity();  // [m] from the picture's plane
  Vec3 normal = Vec3::Zero();                                 // [1] unit, towards the viewer's side

  bool is_empty() const { return node == none; }
};

// Walls are cut at the plane; spheres stay whole, those with their centre on the cut-away side are
// left out. [pixels_x * pixels_y], rows from the top, each from the left.
std::vector<PixelHit> photograph(std::span<const Sphere> spheres,
                                 std::span<const Triangle> triangles, const Camera& camera);

}  // namespace pmr::radiation
