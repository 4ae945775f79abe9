#include "physics/near_pairs.hpp"

#include <algorithm>

#include "physics/lanes.hpp"

namespace pmr::physics {
namespace {

// By kind, in the order in which they were found.
std::vector<NearPair> sorted(const std::vector<NearPair>& pairs, std::uint32_t kinds) {
  std::vector<std::uint32_t> next(kinds + 1, 0);
  for (const NearPair& pair : pairs) ++next[pair.kind + 1];
  for (std::uint32_t k = 0; k < kinds; ++k) next[k + 1] += next[k];
  std::vector<NearPair> result(pairs.size());
  for (const NearPair& pair : pairs) result[next[pair.kind]++] = pair;
  return result;
}

// Pairs of one row closer than the skin go to `to`; returns where they end. Every pair is written,
// and only those that are near are stepped over: no branch to mispredict.
NearPair* thin_row(const Spheres& s, std::uint32_t i, std::span<const std::uint32_t> row,
                   double skin, std::uint32_t kinds, NearPair* to) {
  const std::uint32_t of_i = s.label[i].kind;
  const Sphere& a = s.sphere[i];
  const Lanes x{a.position[0]}, y{a.position[1]}, z{a.position[2]}, radius{a.radius};
  for (std::size_t k = 0; k < row.size(); k += Lanes::count) {
    const auto partner = [&](std::size_t l) { return row[std::min(k + l, row.size() - 1)]; };
    Lanes b[4];
    gather([&](std::size_t l) { return s.sphere[partner(l)].position.data(); }, b);
    const Lanes dx = x - b[0], dy = y - b[1], dz = z - b[2], sum = radius + b[3];
    const Lanes squared = dx * dx + dy * dy + dz * dz, reach = sum + Lanes{skin};
    const std::uint32_t is_near = bits(reach * reach > squared);
    const std::uint32_t touches = bits(sum * sum > squared);
    for (std::uint32_t l = 0; l < Lanes::count; ++l) {
      const std::uint32_t j = partner(l), of_j = s.label[j].kind;
      const std::uint32_t law = std::min(of_i, of_j) * kinds + std::max(of_i, of_j);
      *to = {i, j, 2 * law + 1 - ((touches >> l) & 1U)};
      to += k + l < row.size() ? (is_near >> l) & 1U : 0U;
    }
  }
  return to;
}

}  // namespace

std::vector<NearPair> near_pairs(const Spheres& s, const Block& block,
                                 std::span<const NearRun> runs, std::uint32_t kinds) {
  std::size_t most = 1;
  for (const NearRun& run : runs) most += run.wide->partner.size();
  std::vector<NearPair> found(most);
  NearPair* end = found.data();
  for (std::uint32_t row = 0; row < block.size(); ++row) {
    const NearRun& run = runs[row / run_length];
    end = thin_row(s, block.first + row, run.wide->row(row % run_length), run.skin, kinds, end);
  }
  found.resize(static_cast<std::size_t>(end - found.data()));
  return sorted(found, 2 * kinds * kinds);
}

}  // namespace pmr::physics
