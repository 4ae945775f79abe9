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

WideSearch::WideSearch(const Spheres& spheres, const std::vector<Block>& blocks, double skin)
    : spheres_(spheres), blocks_(blocks), skin_(skin), box_(blocks.size()), reach_(blocks.size()) {
  parallel_for(
      blocks.size(),
      [&](std::size_t b) {
        Box box{spheres.sphere[blocks[b].first].position, spheres.sphere[blocks[b].first].position};
        double largest = 0.0;
        for (std::uint32_t i = blocks[b].first; i < blocks[b].last; ++i) {
          box.low = box.low.cwiseMin(spheres.sphere[i].position);
          box.high = box.high.cwiseMax(spheres.sphere[i].position);
          largest = std::max(largest, spheres.sphere[i].radius);
        }
        box_[b] = box;
        reach_[b] = largest;
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
  for (std::uint32_t c = 0; c < blocks_.size(); ++c) {
    const Box near = grown(box_[block], (reach_[block] + reach_[c] + skin_) * (1.0 + 1e-9));
    if (!overlap(near, box_[c])) continue;
    list.neighbours.push_back(c);
    const FastBox box(near);
    for (std::uint32_t j = blocks_[c].first; j < blocks_[c].last; ++j) {
      const Sphere& s = spheres_.sphere[j];
      if (c != block && !box.holds(s)) continue;
      const std::size_t size = class_of(s.radius);
      found.sphere[size].push_back(s);
      found.index[size].push_back(j);
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
