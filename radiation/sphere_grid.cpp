#include "radiation/sphere_grid.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>

namespace pmr::radiation {
namespace {

constexpr double single_precision = 1e-6;  // [1] error of a distance, of all lengths

}  // namespace

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
    size_ = largest_;
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
  const double rounding = single_precision * (box.isEmpty() ? 0.0 : box.sizes().sum() + largest_);
  for (auto& field : field_) field.assign(spheres.size() + lanes, 0.0F);
  for (std::size_t k = 0; k < sphere_.size(); ++k) {
    const Sphere& s = spheres[sphere_[k]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<int>(axis);
      field_[axis][k] = static_cast<float>(s.centre[a] - low_[a]);
    }
    field_[3][k] = static_cast<float>(s.radius + rounding);
  }
}

SphereGrid::Cell SphereGrid::cell_of(const Vec3& point) const {
  const Eigen::Array3d at = ((point - low_) / size_).array().floor();
  return at.max(0.0).min((cells_ - 1).cast<double>()).cast<int>();
}

std::size_t SphereGrid::number(const Cell& cell) const {
  const auto wide = [](int k) { return static_cast<std::size_t>(k); };
  return (wide(cell.z()) * wide(cells_.y()) + wide(cell.y())) * wide(cells_.x()) + wide(cell.x());
}

// Bits of those of the next `lanes` spheres that may be nearer than the radius.
unsigned SphereGrid::perhaps_near(std::size_t first, const std::array<float, 3>& at,
                                  float radius) const {
  const auto field = [&](std::size_t f) { return _mm256_loadu_ps(&field_[f][first]); };
  const __m256 x = field(0) - _mm256_set1_ps(at[0]), y = field(1) - _mm256_set1_ps(at[1]),
               z = field(2) - _mm256_set1_ps(at[2]);
  const __m256 within = field(3) + _mm256_set1_ps(radius);
  const __m256 is_near = _mm256_cmp_ps(x * x + y * y + z * z, within * within, _CMP_LT_OQ);
  return static_cast<unsigned>(_mm256_movemask_ps(is_near));
}

void SphereGrid::find(const std::vector<Sphere>& spheres, const Vec3& point, double radius,
                      std::vector<std::uint32_t>& found) const {
  const Vec3 reach = Vec3::Constant(radius + largest_);  // [m]
  const Cell from = cell_of(point - reach), to = cell_of(point + reach);
  const Eigen::Vector3f at = (point - low_).cast<float>();
  const auto wide = static_cast<float>(radius * (1.0 + single_precision));
  for (int z = from.z(); z <= to.z(); ++z)
    for (int y = from.y(); y <= to.y(); ++y) {
      const std::uint32_t last = start_[number({to.x(), y, z}) + 1];  // cells along x are adjacent
      for (std::uint32_t k = start_[number({from.x(), y, z})]; k < last; k += lanes) {
        unsigned left = perhaps_near(k, {at.x(), at.y(), at.z()}, wide);
        if (last - k < lanes) left &= (1U << (last - k)) - 1U;
        for (; left != 0; left &= left - 1) {
          const std::uint32_t i = sphere_[k + static_cast<unsigned>(__builtin_ctz(left))];
          const double within = radius + spheres[i].radius;  // [m]
          if ((spheres[i].centre - point).squaredNorm() < within * within) found.push_back(i);
        }
      }
    }
}

}  // namespace pmr::radiation
