#include "physics/wide_list.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>

#include "physics/local_grid.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

Box grown(const Box& box, double by) {
  return {box.low - Vec3::Constant(by), box.high + Vec3::Constant(by)};
}
bool overlap(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}
// A box whose inside is told by three comparisons.
class FastBox {
 public:
  explicit FastBox(const Box& box)
      : low_(_mm256_setr_pd(box.low[0], box.low[1], box.low[2], 0.0)),
        high_(_mm256_setr_pd(box.high[0], box.high[1], box.high[2], 0.0)) {}
  bool holds(const Sphere& s) const {
    const __m256d x = _mm256_loadu_pd(s.position.data());
    const __m256d inside =
        _mm256_and_pd(_mm256_cmp_pd(x, low_, _CMP_GE_OQ), _mm256_cmp_pd(x, high_, _CMP_LE_OQ));
    return (_mm256_movemask_pd(inside) & 7) == 7;
  }

 private:
  __m256d low_, high_;
};

}  // namespace

// By class of size.
struct WideSearch::Candidates {
  std::vector<std::vector<Sphere>> sphere;
  std::vector<std::vector<std::uint32_t>> index;
};

void WideSearch::Bounds::include(const Bounds& other) {
  box.low = box.low.cwiseMin(other.box.low);
  box.high = box.high.cwiseMax(other.box.high);
  largest = std::max(largest, other.largest);
}

WideSearch::WideSearch(const Spheres& spheres, const std::vector<Block>& blocks, double skin)
    : spheres_(spheres),
      blocks_(blocks),
      skin_(skin),
      bounds_(blocks.size()),
      runs_(blocks.size()) {
  parallel_for(
      blocks.size(),
      [&](std::size_t b) {
        for (std::uint32_t i = blocks[b].first; i < blocks[b].last; ++i) {
          if ((i - blocks[b].first) % run_length == 0) runs_[b].emplace_back();
          const Sphere& s = spheres.sphere[i];
          runs_[b].back().include({{s.position, s.position}, s.radius});
        }
        for (const Bounds& run : runs_[b]) bounds_[b].include(run);
      },
      1);
  if (spheres.size() == 0) return;
  smallest_ = spheres.sphere[0].radius;
  for (const Sphere& s : spheres.sphere) smallest_ = std::min(smallest_, s.radius);
  for (const Sphere& s : spheres.sphere) {
    const std::size_t c = class_of(s.radius);
    if (c >= largest_.size()) largest_.resize(c + 1, 0.0);
    largest_[c] = std::max(largest_[c], s.radius);
  }
}

// A class spans a factor of two in radius.
std::size_t WideSearch::class_of(double radius) const {
  return radius < 2.0 * smallest_ ? 0 : static_cast<std::size_t>(std::ilogb(radius / smallest_));
}

WideSearch::Candidates WideSearch::candidates(std::size_t block, WideList& list) const {
  Candidates found{std::vector<std::vector<Sphere>>(largest_.size()),
                   std::vector<std::vector<std::uint32_t>>(largest_.size())};
  list.neighbours.clear();
  const Bounds& own = bounds_[block];
  const auto near_of = [&](const Bounds& other) {
    return grown(own.box, (own.largest + other.largest + skin_) * (1.0 + 1e-9));
  };
  for (std::uint32_t c = 0; c < blocks_.size(); ++c) {
    if (!overlap(near_of(bounds_[c]), bounds_[c].box)) continue;
    list.neighbours.push_back(c);
    for (std::uint32_t r = 0; r < runs_[c].size(); ++r) {
      const Box near = near_of(runs_[c][r]);
      if (!overlap(near, runs_[c][r].box)) continue;
      const FastBox box(near);
      const std::uint32_t first = blocks_[c].first + r * run_length;
      for (std::uint32_t j = first; j < std::min(first + run_length, blocks_[c].last); ++j) {
        const Sphere& s = spheres_.sphere[j];
        if (!box.holds(s)) continue;
        const std::size_t size = class_of(s.radius);
        found.sphere[size].push_back(s);
        found.index[size].push_back(j);
      }
    }
  }
  return found;
}

void WideSearch::find(std::size_t b, WideList& list) const {
  const Block& block = blocks_[b];
  const Candidates near = candidates(b, list);
  std::vector<LocalGrid> grids;
  for (std::size_t c = 0; c < largest_.size(); ++c)
    grids.emplace_back(near.sphere[c], near.index[c], 2.0 * largest_[c] + 0.5 * skin_);
  list.start.assign(block.size() + 1, 0);
  list.partner.clear();
  for (std::uint32_t i = block.first; i < block.last; ++i) {
    const auto row = static_cast<std::ptrdiff_t>(list.partner.size());
    for (const LocalGrid& grid : grids) grid.append_near(spheres_.sphere[i], skin_, list.partner);
    const auto is_elsewhere = [&](std::uint32_t j) { return j == i || (block.holds(j) && j < i); };
    list.partner.erase(std::remove_if(list.partner.begin() + row, list.partner.end(), is_elsewhere),
                       list.partner.end());
    list.start[i - block.first + 1] = static_cast<std::uint32_t>(list.partner.size());
  }
}

}  // namespace pmr::physics
