// Which spheres come near a point: a grid of cells over their centres, eight of which are looked at
// together in single precision, and those that pass again in double precision.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "radiation/scene.hpp"

namespace pmr::radiation {

class SphereGrid {
 public:
  explicit SphereGrid(const std::vector<Sphere>& spheres);

  // Adds the indices of spheres whose surface or inside is nearer than `radius` [m] to the point;
  // `spheres` are those the grid was made of.
  void find(const std::vector<Sphere>& spheres, const Vec3& point, double radius,
            std::vector<std::uint32_t>& found) const;

 private:
  using Cell = Eigen::Array3i;
  static constexpr std::size_t lanes = 8;
  Cell cell_of(const Vec3& point) const;  // clamped to the grid
  std::size_t number(const Cell& cell) const;
  unsigned perhaps_near(std::size_t first, const std::array<float, 3>& at, float radius) const;

  Vec3 low_ = Vec3::Zero();            // [m] corner
  double size_ = 1.0;                  // [m] of a cell
  double largest_ = 0.0;               // [m] radius
  Cell cells_ = Cell::Ones();          // [1] each way
  std::vector<std::uint32_t> start_;   // [cells + 1]
  std::vector<std::uint32_t> sphere_;  // by cell, ascending within each
  // [spheres + lanes] by cell: centre from the corner and radius, a little too large [m]
  std::array<std::vector<float>, 4> field_;
};

}  // namespace pmr::radiation
