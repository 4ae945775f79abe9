#include "physics/local_grid.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>

namespace pmr::physics {

LocalGrid::LocalGrid(std::span<const Sphere> spheres, std::span<const std::uint32_t> index,
                     double cell) {
  if (spheres.empty()) return;
  Vec3 low = spheres[0].position, high = low;
  for (const Sphere& s : spheres) {
    low = low.cwiseMin(s.position);
    high = high.cwiseMax(s.position);
    largest_ = std::max(largest_, s.radius);
  }
  const double most = std::max(64.0, 16.0 * static_cast<double>(spheres.size()));
  std::array<double, 3> sides;
  for (;; cell *= 1.25) {
    for (int k = 0; k < 3; ++k)
      sides[static_cast<std::size_t>(k)] = std::floor((high[k] - low[k]) / cell) + 1.0;
    if (sides[0] * sides[1] * sides[2] <= most) break;
  }
  inverse_ = 1.0 / cell;
  for (std::size_t k = 0; k < 3; ++k) {
    low_[k] = low[static_cast<int>(k)];
    cells_[k] = static_cast<std::size_t>(sides[k]);
  }
  start_.assign(cells_[0] * cells_[1] * cells_[2] + 1, 0);
  std::vector<std::uint32_t> cell_of(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Vec3& x = spheres[i].position;
    cell_of[i] = static_cast<std::uint32_t>(
        (place(x[2], 2) * cells_[1] + place(x[1], 1)) * cells_[0] + place(x[0], 0));
    ++start_[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  index_.resize(spheres.size() + lanes);
  for (auto& field : sorted_) field.resize(spheres.size() + lanes);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const std::uint32_t k = next[cell_of[i]]++;
    index_[k] = index[i];
    for (int axis = 0; axis < 3; ++axis)
      sorted_[static_cast<std::size_t>(axis)][k] = spheres[i].position[axis];
    sorted_[3][k] = spheres[i].radius;
  }
}

std::size_t LocalGrid::place(double x, std::size_t axis) const {
  const double cell = (x - low_[axis]) * inverse_;
  const auto most = static_cast<double>(static_cast<std::int64_t>(cells_[axis]) - 1);
  return static_cast<std::size_t>(static_cast<std::int64_t>(std::clamp(cell, 0.0, most)));
}

void LocalGrid::append_near(const Sphere& a, double skin, std::vector<std::uint32_t>& found) const {
  if (start_.empty()) return;
  const double cube = (a.radius + largest_ + skin) * (1.0 + 1e-9);  // safe against rounding
  std::array<std::size_t, 3> low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = a.position[static_cast<int>(k)];
    low[k] = place(x - cube, k);
    high[k] = place(x + cube, k);
  }
  for (std::size_t z = low[2]; z <= high[2]; ++z)
    for (std::size_t y = low[1]; y <= high[1]; ++y) {
      const std::size_t row = (z * cells_[1] + y) * cells_[0];
      append_span(a, skin, start_[row + low[0]], start_[row + high[0] + 1], found);
    }
}

// Every index is written, and only those that are near are stepped over: no branch to mispredict.
void LocalGrid::append_span(const Sphere& a, double skin, std::size_t first, std::size_t last,
                            std::vector<std::uint32_t>& found) const {
  const auto all = [](double x) { return _mm256_set1_pd(x); };
  std::size_t count = found.size();
  found.resize(count + (last - first) + 2 * lanes);
  for (std::size_t k = first; k < last; k += lanes) {
    const auto field = [&](std::size_t f) { return _mm256_loadu_pd(&sorted_[f][k]); };
    const __m256d x = all(a.position[0]) - field(0), y = all(a.position[1]) - field(1),
                  z = all(a.position[2]) - field(2);
    const __m256d reach = (all(a.radius) + field(3)) + all(skin);
    const __m256d is_near = _mm256_cmp_pd(x * x + y * y + z * z, reach * reach, _CMP_LT_OQ);
    auto bits = static_cast<unsigned>(_mm256_movemask_pd(is_near));
    if (last - k < lanes) bits &= (1U << (last - k)) - 1U;
    for (std::size_t l = 0; l < lanes; ++l) {
      found[count] = index_[k + l];
      count += (bits >> l) & 1U;
    }
  }
  found.resize(count);
}

}  // namespace pmr::physics
