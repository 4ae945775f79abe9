#include "physics/neighbours.hpp"

#include <algorithm>

#include "physics/wide_list.hpp"
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

std::vector<NeighbourPair> pairs_within(const Particles& particles, double reach) {
  Spheres spheres = gather_spheres(particles);
  const std::vector<Block> blocks = cut(spheres.size());
  bound(spheres, blocks);
  const WideSearch search(spheres, blocks);
  const double skin = reach * search.largest_radius();
  std::vector<std::vector<NeighbourPair>> found(blocks.size());
  parallel_for(
      blocks.size(),
      [&](std::size_t b) {
        WideList list;
        search.find(spheres, static_cast<std::uint32_t>(b), skin, skin, list);
        for (std::uint32_t i = blocks[b].first; i < blocks[b].last; ++i) {
          const Sphere& a = spheres.sphere[i];
          const std::size_t row = found[b].size();
          for (const std::uint32_t j : list.row(i - blocks[b].first)) {
            const Sphere& s = spheres.sphere[j];
            const double gap = (a.position - s.position).norm() - (a.radius + s.radius);
            if (j > i && gap < reach * std::min(a.radius, s.radius))
              found[b].push_back({i, j, gap});
          }
          std::sort(found[b].begin() + static_cast<std::ptrdiff_t>(row), found[b].end(),
                    [](const NeighbourPair& p, const NeighbourPair& q) { return p.j < q.j; });
        }
      },
      1);
  std::vector<NeighbourPair> all;
  for (const auto& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
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
