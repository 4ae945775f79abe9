#include "physics/wide_list.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>

#include "physics/local_grid.hpp"

namespace pmr::physics {
namespace {

constexpr double outwards = 1.0 + 1e-9;  // of reaches, safe against rounding [1]

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

WideSearch::WideSearch(const Spheres& spheres, const std::vector<Block>& blocks)
    : blocks_(blocks), block_radius_(blocks.size(), 0.0), run_radius_(spheres.run_box.size(), 0.0) {
  if (spheres.size() == 0) return;
  smallest_ = spheres.sphere[0].radius;
  for (const Sphere& s : spheres.sphere) smallest_ = std::min(smallest_, s.radius);
  for (const Block& block : blocks)
    for (std::uint32_t i = block.first; i < block.last; ++i) {
      const double radius = spheres.sphere[i].radius;
      const std::size_t c = class_of(radius);
      if (c >= largest_.size()) largest_.resize(c + 1, 0.0);
      for (double* most :
           {&largest_[c], &block_radius_[block.number], &run_radius_[i / run_length]})
        *most = std::max(*most, radius);
    }
}

// A class spans a factor of two in radius.
std::size_t WideSearch::class_of(double radius) const {
  return radius < 2.0 * smallest_ ? 0 : static_cast<std::size_t>(std::ilogb(radius / smallest_));
}

WideSearch::Candidates WideSearch::candidates(const Spheres& spheres, std::uint32_t block,
                                              double skin,
                                              const std::vector<std::uint32_t>& neighbours) const {
  Candidates found{std::vector<std::vector<Sphere>>(largest_.size()),
                   std::vector<std::vector<std::uint32_t>>(largest_.size())};
  for (const std::uint32_t c : neighbours)
    for (std::uint32_t first = blocks_[c].first; first < blocks_[c].last; first += run_length) {
      const std::size_t run = first / run_length;
      const Box near = grown(spheres.block_box[block],
                             (block_radius_[block] + run_radius_[run] + skin) * outwards);
      if (!overlap(near, spheres.run_box[run])) continue;
      const FastBox box(near);
      const std::uint32_t last = std::min<std::uint32_t>(first + run_length, blocks_[c].last);
      for (std::uint32_t j = first; j < last; ++j) {
        const Sphere& s = spheres.sphere[j];
        if (!box.holds(s)) continue;
        const std::size_t size = class_of(s.radius);
        found.sphere[size].push_back(s);
        found.index[size].push_back(j);
      }
    }
  return found;
}

void WideSearch::find(const Spheres& spheres, std::uint32_t b, double skin, double horizon,
                      WideList& list) const {
  list.neighbours.clear();
  for (std::uint32_t c = 0; c < blocks_.size(); ++c) {
    const double reach = (block_radius_[b] + block_radius_[c] + horizon) * outwards;
    if (overlap(grown(spheres.block_box[b], reach), spheres.block_box[c]))
      list.neighbours.push_back(c);
  }
  const Candidates near = candidates(spheres, b, skin, list.neighbours);
  std::vector<LocalGrid> grids;
  for (std::size_t c = 0; c < largest_.size(); ++c)
    grids.emplace_back(near.sphere[c], near.index[c], 2.0 * largest_[c] + 0.5 * skin);
  const Block& block = blocks_[b];
  list.start.assign(block.size() + 1, 0);
  list.partner.clear();
  for (std::uint32_t i = block.first; i < block.last; ++i) {
    const auto row = static_cast<std::ptrdiff_t>(list.partner.size());
    for (const LocalGrid& grid : grids) grid.append_near(spheres.sphere[i], skin, list.partner);
    const auto is_elsewhere = [&](std::uint32_t j) { return j == i || (block.holds(j) && j < i); };
    list.partner.erase(std::remove_if(list.partner.begin() + row, list.partner.end(), is_elsewhere),
                       list.partner.end());
    list.start[i - block.first + 1] = static_cast<std::uint32_t>(list.partner.size());
  }
}

}  // namespace pmr::physics
