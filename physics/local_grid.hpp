// Spheres of like size binned into cubic cells; cells of one x-row lie behind each other, so that a
// search runs through a few contiguous spans, four spheres at a time.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/spheres.hpp"

namespace pmr::physics {

class LocalGrid {
 public:
  // Cells of at least `cell` [m]; larger where that would make more than 16 cells a sphere. Spheres
  // are reported by `index`.
  LocalGrid(std::span<const Sphere> spheres, std::span<const std::uint32_t> index, double cell);

  // Appends the index of every sphere whose surface is closer than `skin` [m] to that of `a`.
  void append_near(const Sphere& a, double skin, std::vector<std::uint32_t>& found) const;

 private:
  static constexpr std::size_t lanes = 4;
  std::size_t place(double x, std::size_t axis) const;  // cell along an axis, clamped to the grid
  void append_span(const Sphere& a, double skin, std::size_t first, std::size_t last,
                   std::vector<std::uint32_t>& found) const;

  std::array<double, 3> low_{};                // [m] lower corner
  double inverse_ = 1.0;                       // [1/m] one over the side of a cell
  std::array<std::size_t, 3> cells_{};         // [1] along each axis
  double largest_ = 0.0;                       // [m] radius
  std::vector<std::uint32_t> start_;           // [cells + 1]
  std::vector<std::uint32_t> index_;           // [spheres + lanes] by cell
  std::array<std::vector<double>, 4> sorted_;  // [spheres + lanes] by cell: x, y, z, radius [m]
};

}  // namespace pmr::physics
