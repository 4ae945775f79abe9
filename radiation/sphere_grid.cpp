#include "radiation/sphere_grid.hpp"

#include <algorithm>
#include <cmath>

namespace pmr::radiation {

SphereGrid::SphereGrid(const std::vector<Sphere>& spheres) {
  Eigen::AlignedBox3d box;
  for (const Sphere& s : spheres) {
    box.extend(s.centre);
    largest_ = std::max(largest_, s.radius);
  }
  if (!box.isEmpty()) {
    low_ = box.min();
    const Vec3 extent = box.sizes();
    // A few scattered spheres must not cost millions of empty cells: at most about 8 a sphere.
    const double most = 8.0 * static_cast<double>(spheres.size()) + 64.0;
    size_ = 2.0 * largest_;
    const auto count = [&] { return ((extent / size_).array().floor() + 1.0).prod(); };
    while (count() > most) size_ *= 1.25;
    cells_ = (extent / size_).array().floor().cast<int>() + 1;
  }
  start_.assign(static_cast<std::size_t>(cells_.prod()) + 1, 0);
  for (const Sphere& s : spheres) ++start_[number(cell_of(s.centre)) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  sphere_.resize(spheres.size());
  for (std::uint32_t i = 0; i < spheres.size(); ++i)
    sphere_[next[number(cell_of(spheres[i].centre))]++] = i;
}

SphereGrid::Cell SphereGrid::cell_of(const Vec3& point) const {
  const Eigen::Array3d at = ((point - low_) / size_).array().floor();
  return at.max(0.0).min((cells_ - 1).cast<double>()).cast<int>();
}

std::size_t SphereGrid::number(const Cell& cell) const {
  const auto wide = [](int k) { return static_cast<std::size_t>(k); };
  return (wide(cell.z()) * wide(cells_.y()) + wide(cell.y())) * wide(cells_.x()) + wide(cell.x());
}

void SphereGrid::find(const std::vector<Sphere>& spheres, const Vec3& point, double radius,
                      std::vector<std::uint32_t>& found) const {
  const Vec3 reach = Vec3::Constant(radius + largest_);  // [m]
  const Cell from = cell_of(point - reach), to = cell_of(point + reach);
  for (int z = from.z(); z <= to.z(); ++z)
    for (int y = from.y(); y <= to.y(); ++y) {
      const std::uint32_t first = start_[number({from.x(), y, z})];
      const std::uint32_t last = start_[number({to.x(), y, z}) + 1];  // cells along x are adjacent
      for (std::uint32_t k = first; k < last; ++k) {
        const Sphere& s = spheres[sphere_[k]];
        const double within = radius + s.radius;  // [m]
        if ((s.centre - point).squaredNorm() < within * within) found.push_back(sphere_[k]);
      }
    }
}

}  // namespace pmr::radiation
