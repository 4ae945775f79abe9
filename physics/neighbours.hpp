// Who is near whom.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/spheres.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::physics {

// Spheres binned into cubic cells; cells of one x-row lie behind each other in memory, so that a
// search runs through a few contiguous spans.
class CellGrid {
 public:
  // Cells of at least `cell` [m]; larger where that would make more than 8 cells a sphere.
  CellGrid(std::span<const Sphere> spheres, double cell);

  // Calls visit(index, sphere) for every sphere with its centre in the cube x +- reach [m], and
  // for some around it.
  template <class Visit>
  void for_each_near(const Vec3& x, double reach, const Visit& visit) const {
    std::array<std::size_t, 3> low, high;
    for (int k = 0; k < 3; ++k) {
      low[static_cast<std::size_t>(k)] = place(x[k] - reach, k);
      high[static_cast<std::size_t>(k)] = place(x[k] + reach, k);
    }
    for (std::size_t z = low[2]; z <= high[2]; ++z)
      for (std::size_t y = low[1]; y <= high[1]; ++y) {
        const std::size_t row = (z * cells_[1] + y) * cells_[0];
        for (std::uint32_t k = start_[row + low[0]]; k < start_[row + high[0] + 1]; ++k)
          visit(index_[k], sorted_[k]);
      }
  }

 private:
  std::size_t place(double x, int axis) const {  // cell along an axis, clamped to the grid
    const auto k = static_cast<std::size_t>(axis);
    const double cell = (x - low_[axis]) * inverse_;
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells_[k] - 1)));
  }
  std::size_t cell_of(const Vec3& x) const {
    return (place(x[2], 2) * cells_[1] + place(x[1], 1)) * cells_[0] + place(x[0], 0);
  }

  Vec3 low_;                          // [m] lower corner
  double inverse_;                    // [1/m] one over the side of a cell
  std::array<std::size_t, 3> cells_;  // [1] along each axis
  std::vector<std::uint32_t> start_;  // [cells + 1]
  std::vector<std::uint32_t> index_;  // [spheres] by cell
  std::vector<Sphere> sorted_;        // [spheres] by cell
};

struct NeighbourPair {
  std::uint32_t i, j;  // indices, i < j
  double gap;          // [m] between the surfaces, negative where they overlap
};

// All pairs whose surfaces are closer than reach [1] times the smaller radius, sorted by (i, j).
std::vector<NeighbourPair> pairs_within(const Particles& particles, double reach);

// Places of the particles in spatial order: along the Morton curve through cells of `cell` [m],
// by id within a cell.
std::vector<std::uint32_t> spatial_order(const Particles& particles, double cell);

}  // namespace pmr::physics
