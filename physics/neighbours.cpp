#include "physics/neighbours.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "physics/wide_list.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

struct Place {
  Vec3 position;  // [m]
  ParticleId id;
  std::uint32_t index;
};

int longest_side(std::span<const Place> places) {
  Vec3 low = places[0].position, high = low;
  for (const Place& p : places) {
    low = low.cwiseMin(p.position);
    high = high.cwiseMax(p.position);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

// Halves until runs are left; `block` is the number of particles in a block.
void bisect(std::span<Place> places, std::size_t block) {
  if (places.size() <= run_length) return;
  const std::size_t unit = places.size() > block ? block : run_length;
  const std::size_t units = (places.size() + unit - 1) / unit;
  const std::size_t half = (units / 2) * unit;
  const int axis = longest_side(places);
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(half), places.end(),
                   [axis](const Place& p, const Place& q) {
                     const double x = p.position[axis], y = q.position[axis];
                     return x != y ? x < y : p.id < q.id;
                   });
  bisect(places.first(half), block);
  bisect(places.subspan(half), block);
}

Spheres in_order(const Spheres& spheres, const std::vector<std::uint32_t>& order) {
  Spheres sorted;
  for (const std::uint32_t i : order) {
    sorted.sphere.push_back(spheres.sphere[i]);
    sorted.kinetics.push_back(spheres.kinetics[i]);
    sorted.label.push_back(spheres.label[i]);
  }
  bound(sorted, cut(sorted.size()));
  return sorted;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(const Particles& particles) {
  std::vector<Place> places;
  places.reserve(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
    places.push_back({particles.position[i], particles.id[i], static_cast<std::uint32_t>(i)});
  const std::vector<Block> blocks = cut(places.size());
  if (!blocks.empty()) bisect(places, blocks[0].size());
  std::vector<std::uint32_t> order;
  order.reserve(places.size());
  for (const Place& place : places) order.push_back(place.index);
  return order;
}

std::vector<NeighbourPair> pairs_within(const Particles& particles, double reach) {
  const std::vector<std::uint32_t> order = spatial_order(particles);
  const Spheres spheres = in_order(gather_spheres(particles), order);
  const std::vector<Block> blocks = cut(spheres.size());
  const WideSearch search(spheres, blocks);
  const double skin = reach * search.largest_radius();
  std::vector<std::uint32_t> everywhere(blocks.size());
  std::iota(everywhere.begin(), everywhere.end(), 0U);
  std::vector<std::vector<NeighbourPair>> found(spheres.run_box.size());
  parallel_for(
      found.size(),
      [&](std::size_t run) {
        WideList list;
        search.find(spheres, static_cast<std::uint32_t>(run), everywhere, skin, skin, list);
        for (std::uint32_t own = 0; own + 1 < list.start.size(); ++own) {
          const auto i = static_cast<std::uint32_t>(run * run_length) + own;
          const Sphere& a = spheres.sphere[i];
          for (const std::uint32_t j : list.row(own)) {
            const Sphere& s = spheres.sphere[j];
            const double gap = (a.position - s.position).norm() - (a.radius + s.radius);
            if (j > i && gap < reach * std::min(a.radius, s.radius))
              found[run].push_back(
                  {std::min(order[i], order[j]), std::max(order[i], order[j]), gap});
          }
        }
      },
      1);
  std::vector<NeighbourPair> all;
  for (const auto& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  std::sort(all.begin(), all.end(), [](const NeighbourPair& p, const NeighbourPair& q) {
    return p.i != q.i ? p.i < q.i : p.j < q.j;
  });
  return all;
}

}  // namespace pmr::physics
