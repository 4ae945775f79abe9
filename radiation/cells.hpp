// Cells over the spheres of a scene: what a ray in a dense bed meets first stands nearly always in
// the cell where it starts or the next, tested eight spheres at a time, without a search tree.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "radiation/scene.hpp"

namespace pmr::radiation {

// Each cell lists the spheres and the triangles that reach into it; the spheres in single
// precision, seen from the cell's middle: finer than the search tree, whose origin is far away. A
// ray walks from cell to cell (Amanatides & Woo, Eurographics 1987) until it has met something in
// the part that it has walked.
class Cells {
 public:
  explicit Cells(const Scene& scene);

  // The first primitive that a ray meets, and its distance [m]; 0 if the start lies within that
  // sphere (the deepest, if there are several). Nothing where that cannot be told: outside of the
  // cells, or after a long way through empty ones. A ray that leaves a sphere just above its
  // surface does not meet that sphere; a triangle that is left is passed through.
  struct Meeting {
    std::uint32_t primitive;
    double distance;
  };
  std::optional<Meeting> first(const Vec3& start, const Vec3& direction,
                               std::uint32_t left_triangle = none) const;

  // The sphere whose surface is farthest above the point; `none` if none is.
  std::uint32_t covering(const Vec3& point) const;

  // A wall that stands between a sphere's centre and a point on it; `none` if none does.
  std::uint32_t wall_within(std::uint32_t sphere, const Vec3& point) const;

 private:
  static constexpr std::size_t lanes = 8;
  using Cell = Eigen::Array3i;
  // Spheres seen from the cell's middle, in cell edges.
  struct alignas(32) Packet {
    float x[lanes], y[lanes], z[lanes], radius[lanes];
    std::uint32_t sphere[lanes];
  };
  struct Nearest {
    float distance;  // [edges]
    std::uint32_t primitive;
  };
  struct Walk;

  Cell cell_of(const Vec3& point) const;  // may lie outside
  bool holds(const Cell& cell) const { return (cell >= 0).all() && (cell < count_).all(); }
  std::size_t number(const Cell& cell) const;
  Vec3 middle(const Cell& cell) const {
    return low_ + edge_ * (cell.cast<double>() + 0.5).matrix();
  }
  template <class Visit>
  void for_each_cell_of(const Sphere& sphere, const Visit& visit) const;
  template <class Visit>
  void for_each_cell_of(const Triangle& triangle, const Visit& visit) const;
  void sort_spheres();
  void sort_triangles();
  void find_cut_spheres();
  void meet_spheres(std::size_t cell, const Eigen::Vector3f& from, const Eigen::Vector3f& direction,
                    Nearest& nearest) const;
  void meet_walls(std::size_t cell, const Walk& walk, std::uint32_t left, Nearest& nearest) const;

  const Scene* scene_;
  Vec3 low_ = Vec3::Zero();  // [m] corner
  double edge_ = 1.0;        // [m] of a cell
  Cell count_ = Cell::Zero();
  std::vector<std::uint32_t> packet_start_, wall_start_;  // [cells + 1]
  std::vector<Packet> packet_;
  std::vector<std::uint32_t> wall_;  // primitives
  // Spheres that walls cut, ascending, and the walls of each.
  std::vector<std::uint32_t> cut_sphere_, cut_start_, cut_wall_;
};

}  // namespace pmr::radiation
