// The geometry that radiation sees: opaque spheres and triangles, asked for the nearest hit.
// Embree 3.13 (Wald et al., ACM TOG 33, 2014) stands behind it, in single precision; positions are
// therefore taken from the middle of the scene and in units of the mean sphere diameter.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr::radiation {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

struct Sphere {
  Vec3 centre;         // [m]
  double radius;       // [m]
  std::uint32_t node;  // of the heat network
};

struct Triangle {
  std::array<Vec3, 3> corner;  // [m], counter-clockwise seen from the facing side
  std::uint32_t node;          // of the heat network
};

struct Ray {
  Vec3 origin;        // [m]
  Vec3 direction;     // [1] unit
  double from = 0.0;  // [m] along the ray: nearer things are not seen
};

// Primitives are numbered through: spheres in their order, then triangles in theirs.
struct Hit {
  std::uint32_t primitive = none;  // `none`: the ray left the scene
  std::uint32_t node = none;
  double distance = std::numeric_limits<double>::infinity();  // [m] from the origin
  Vec3 point = Vec3::Zero();                                  // [m] on the primitive
  Vec3 normal = Vec3::Zero();  // [1] unit, of a sphere outwards, of a triangle against the ray

  bool is_empty() const { return primitive == none; }
};

// Owns copies of its primitives and the search tree. Built by one thread, so that the same input
// gives the same tree, and the same hit where two primitives tie; asking it is safe on any thread.
class Scene {
 public:
  Scene(std::span<const Sphere> spheres, std::span<const Triangle> triangles);
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  const std::vector<Sphere>& spheres() const { return spheres_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  std::size_t primitives() const { return spheres_.size() + triangles_.size(); }
  bool is_sphere(std::uint32_t primitive) const { return primitive < spheres_.size(); }
  const Triangle& triangle(std::uint32_t primitive) const {
    return triangles_[primitive - spheres_.size()];
  }
  std::uint32_t node_of(std::uint32_t primitive) const {
    return is_sphere(primitive) ? spheres_[primitive].node : triangle(primitive).node;
  }
  double unit() const { return unit_; }  // [m] mean diameter (extent of the scene if no spheres)

  // Nearest hit along the ray; the primitive `excluded` is passed through.
  Hit nearest(const Ray& ray, std::uint32_t excluded = none) const;

  // The hit of a primitive known to be met at a distance [m] along the ray.
  Hit hit_at(std::uint32_t primitive, double distance, const Ray& ray) const;

 private:
  struct Tree;
  std::vector<Sphere> spheres_;
  std::vector<Triangle> triangles_;
  Vec3 middle_ = Vec3::Zero();  // [m] origin of the tree's coordinates
  double unit_ = 1.0;           // [m] their unit
  std::unique_ptr<Tree> tree_;
};

}  // namespace pmr::radiation
