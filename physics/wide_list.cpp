#include "physics/wide_list.hpp"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <memory>

namespace pmr::physics {
namespace {

constexpr double outwards = 1.0 + 1e-9;  // of reaches, safe against rounding [1]
// Candidates stand in single precision, relative to their run: error of a gap [1] of all lengths.
constexpr double single_precision = 1e-6;
constexpr std::size_t lanes = 8;  // of single precision

Box grown(const Box& box, double by) {
  return {box.low - Vec3::Constant(by), box.high + Vec3::Constant(by)};
}
bool overlap(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}
// A box whose inside is told by two comparisons.
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

// For each set of lanes: their numbers, in order, in front.
constexpr std::array<std::array<std::int32_t, lanes>, 256> in_front = [] {
  std::array<std::array<std::int32_t, lanes>, 256> table{};
  for (std::size_t set = 0; set < table.size(); ++set)
    for (std::size_t l = 0, place = 0; l < lanes; ++l)
      if ((set >> l & 1U) != 0) table[set][place++] = static_cast<std::int32_t>(l);
  return table;
}();

}  // namespace

// Spheres seen from `origin`; the run's own first, in order. Behind them follow `lanes` that are
// near nobody.
struct WideSearch::Candidates {
  explicit Candidates(std::size_t most)
      : field(std::make_unique_for_overwrite<float[]>(4 * (most + lanes))),
        index(std::make_unique_for_overwrite<std::uint32_t[]>(most + lanes)),
        stride(most + lanes) {}

  float* x(std::size_t axis) const { return &field[axis * stride]; }
  float* radius() const { return &field[3 * stride]; }
  void add(const Sphere& s, std::uint32_t i, const Vec3& origin) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<int>(k);
      x(k)[count] = static_cast<float>(s.position[axis] - origin[axis]);
    }
    radius()[count] = static_cast<float>(s.radius);
    index[count++] = i;
  }
  void close() {
    std::fill_n(&x(0)[count], lanes, 1e18F);
    for (const std::size_t f : {1U, 2U, 3U}) std::fill_n(&field[f * stride + count], lanes, 0.0F);
    std::fill_n(&index[count], lanes, 0U);
  }
  std::uint32_t* append_near(std::size_t own, std::size_t from, float skin,
                             std::uint32_t* to) const;

  std::unique_ptr<float[]> field;
  std::unique_ptr<std::uint32_t[]> index;
  std::size_t stride, count = 0;
};

// Writes to `to` the indices of those at `from` and behind, closer to `own` than the skin; up to
// lanes places behind the last one are overwritten. Returns where the last one ends.
std::uint32_t* WideSearch::Candidates::append_near(std::size_t own, std::size_t from, float skin,
                                                   std::uint32_t* to) const {
  const auto all = [](float a) { return _mm256_set1_ps(a); };
  const __m256 x = all(this->x(0)[own]), y = all(this->x(1)[own]), z = all(this->x(2)[own]);
  const __m256 reach = all(radius()[own] + skin);
  for (std::size_t k = from; k < count; k += lanes) {
    const __m256 dx = x - _mm256_loadu_ps(this->x(0) + k), dy = y - _mm256_loadu_ps(this->x(1) + k),
                 dz = z - _mm256_loadu_ps(this->x(2) + k);
    const __m256 sum = reach + _mm256_loadu_ps(radius() + k);
    const __m256 is_near = _mm256_cmp_ps(dx * dx + dy * dy + dz * dz, sum * sum, _CMP_LT_OQ);
    const auto set = static_cast<unsigned>(_mm256_movemask_ps(is_near));
    if (set == 0) continue;
    const auto* const order = reinterpret_cast<const __m256i*>(in_front[set].data());
    const auto* const indices = reinterpret_cast<const __m256i*>(&index[k]);
    _mm256_storeu_si256(
        reinterpret_cast<__m256i*>(to),
        _mm256_permutevar8x32_epi32(_mm256_loadu_si256(indices), _mm256_loadu_si256(order)));
    to += __builtin_popcount(set);
  }
  return to;
}

WideSearch::WideSearch(const Spheres& spheres, const std::vector<Block>& blocks)
    : blocks_(blocks),
      block_radius_(blocks.size(), 0.0),
      run_radius_(spheres.run_box.size(), 0.0),
      run_size_(spheres.run_box.size(), 0),
      adhered_from_(spheres.adhered_from) {
  for (const Block& block : blocks)
    for (std::uint32_t i = block.first; i < block.last; ++i) {
      ++run_size_[i / run_length];
      for (double* most : {&largest_, &block_radius_[block.number], &run_radius_[i / run_length]})
        *most = std::max(*most, spheres.sphere[i].radius);
    }
}

std::vector<std::uint32_t> WideSearch::blocks_around(const Spheres& spheres, std::uint32_t block,
                                                     double horizon) const {
  std::vector<std::uint32_t> around;
  for (std::uint32_t c = 0; c < blocks_.size(); ++c) {
    const double reach = (block_radius_[block] + block_radius_[c] + horizon) * outwards;
    if (overlap(grown(spheres.block_box[block], reach), spheres.block_box[c])) around.push_back(c);
  }
  return around;
}

void WideSearch::look_around(const Spheres& spheres, std::uint32_t run,
                             std::span<const std::uint32_t> blocks, double horizon,
                             WideList& list) const {
  list.around.clear();
  const auto is_within = [&](const Box& box, double radius) {
    const double reach = (run_radius_[run] + radius + horizon) * outwards;
    return overlap(grown(spheres.run_box[run], reach), box);
  };
  const std::uint32_t first = run * run_length;
  for (const std::uint32_t b : blocks) {
    const Block& block = blocks_[b];
    if (adheres(first) && adheres(block.first)) continue;
    if (!is_within(spheres.block_box[block.number], block_radius_[block.number])) continue;
    const std::uint32_t begin = block.holds(first) ? first : block.first;
    for (std::uint32_t r = begin / run_length; r * run_length < block.last; ++r)
      if (is_within(spheres.run_box[r], run_radius_[r])) list.around.push_back(r);
  }
  if (adheres(first)) list.around.push_back(run);
  // the run itself in front
  std::iter_swap(list.around.begin(), std::find(list.around.begin(), list.around.end(), run));
}

WideSearch::Candidates WideSearch::candidates(const Spheres& spheres, std::uint32_t run,
                                              double skin, const WideList& list) const {
  Candidates found(list.around.size() * run_length);
  const Vec3 origin = 0.5 * (spheres.run_box[run].low + spheres.run_box[run].high);
  for (const std::uint32_t r : list.around) {
    const Box near =
        grown(spheres.run_box[run], (run_radius_[run] + run_radius_[r] + skin) * outwards);
    if (!overlap(near, spheres.run_box[r])) continue;
    const FastBox box(near);
    const std::uint32_t last = r * run_length + run_size_[r];
    for (std::uint32_t j = r * run_length; j < last; ++j)
      if (box.holds(spheres.sphere[j])) found.add(spheres.sphere[j], j, origin);
  }
  found.close();
  return found;
}

void WideSearch::find(const Spheres& spheres, std::uint32_t run,
                      std::span<const std::uint32_t> blocks, double skin, double horizon,
                      WideList& list) const {
  look_around(spheres, run, blocks, horizon, list);
  const Candidates near = candidates(spheres, run, skin, list);
  const std::size_t own = run_size_[run];
  const double size = (spheres.run_box[run].high - spheres.run_box[run].low).norm();
  const auto reach = static_cast<float>(skin + single_precision * (size + 2.0 * largest_ + skin));
  list.start.assign(own + 1, 0);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < own; ++i) {
    list.partner.resize(count + near.count + lanes);
    const std::size_t from = adheres(std::size_t{run} * run_length) ? own : i + 1;
    const std::uint32_t* const end = near.append_near(i, from, reach, &list.partner[count]);
    count = static_cast<std::uint32_t>(end - list.partner.data());
    list.start[i + 1] = count;
  }
  list.partner.resize(count);
}

}  // namespace pmr::physics
