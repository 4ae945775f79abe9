#include "physics/neighbours.hpp"

#include <cmath>

#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // [m] of the centres
};

template <class Position>
Bounds bounds(std::size_t count, const Position& position) {
  if (count == 0) return {};
  Bounds b{position(0), position(0)};
  for (std::size_t i = 1; i < count; ++i) {
    b.low = b.low.cwiseMin(position(i));
    b.high = b.high.cwiseMax(position(i));
  }
  return b;
}

// Spreads the lower 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

}  // namespace

CellGrid::CellGrid(std::span<const Sphere> spheres, double cell) {
  const Bounds b = bounds(spheres.size(), [&](std::size_t i) { return spheres[i].position; });
  low_ = b.low;
  const double most = std::max(4096.0, 8.0 * static_cast<double>(spheres.size()));
  std::array<double, 3> sides;
  for (;; cell *= 1.25) {
    for (int k = 0; k < 3; ++k)
      sides[static_cast<std::size_t>(k)] = std::floor((b.high[k] - b.low[k]) / cell) + 1.0;
    if (sides[0] * sides[1] * sides[2] <= most) break;
  }
  inverse_ = 1.0 / cell;
  for (std::size_t k = 0; k < 3; ++k) cells_[k] = static_cast<std::size_t>(sides[k]);

  std::vector<std::uint32_t> cell_of_sphere(spheres.size());
  parallel_for(spheres.size(), [&](std::size_t i) {
    cell_of_sphere[i] = static_cast<std::uint32_t>(cell_of(spheres[i].position));
  });
  start_.assign(cells_[0] * cells_[1] * cells_[2] + 1, 0);
  for (const std::uint32_t c : cell_of_sphere) ++start_[c + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  index_.resize(spheres.size());
  sorted_.resize(spheres.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::uint32_t i = 0; i < spheres.size(); ++i) {
    const std::uint32_t k = next[cell_of_sphere[i]]++;
    index_[k] = i;
    sorted_[k] = spheres[i];
  }
}

std::vector<NeighbourPair> pairs_within(const Particles& particles, double reach) {
  const std::vector<Sphere> spheres = gather_spheres(particles).sphere;
  double largest = 0.0;
  for (const Sphere& s : spheres) largest = std::max(largest, s.radius);
  if (spheres.empty()) return {};
  const CellGrid grid(spheres, (1.0 + 0.5 * reach) * largest);
  std::vector<std::vector<NeighbourPair>> blocks((spheres.size() + block_size - 1) / block_size);
  parallel_blocks(spheres.size(), [&](std::size_t first, std::size_t last) {
    std::vector<NeighbourPair>& pairs = blocks[first / block_size];
    for (std::size_t i = first; i < last; ++i) {
      const auto row = pairs.size();
      const Sphere& a = spheres[i];
      grid.for_each_near(
          a.position, (1.0 + reach) * a.radius + largest, [&](std::uint32_t j, const Sphere& b) {
            if (j <= i) return;
            const double gap = (a.position - b.position).norm() - (a.radius + b.radius);
            if (gap < reach * std::min(a.radius, b.radius))
              pairs.push_back({static_cast<std::uint32_t>(i), j, gap});
          });
      std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(row), pairs.end(),
                [](const NeighbourPair& p, const NeighbourPair& q) { return p.j < q.j; });
    }
  });
  std::vector<NeighbourPair> all;
  for (const auto& pairs : blocks) all.insert(all.end(), pairs.begin(), pairs.end());
  return all;
}

std::vector<std::uint32_t> spatial_order(const Particles& particles, double cell) {
  const Bounds b = bounds(particles.size(), [&](std::size_t i) { return particles.position[i]; });
  struct Key {
    std::uint64_t curve;
    ParticleId id;
    std::uint32_t index;
  };
  std::vector<Key> keys(particles.size());
  parallel_for(particles.size(), [&](std::size_t i) {
    const Vec3 p = (particles.position[i] - b.low) / cell;
    const auto along = [&](int k) { return spread(static_cast<std::uint64_t>(p[k])); };
    keys[i] = {along(0) | along(1) << 1 | along(2) << 2, particles.id[i],
               static_cast<std::uint32_t>(i)};
  });
  std::sort(keys.begin(), keys.end(), [](const Key& p, const Key& q) {
    return p.curve != q.curve ? p.curve < q.curve : p.id < q.id;
  });
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const Key& key : keys) order.push_back(key.index);
  return order;
}

}  // namespace pmr::physics
