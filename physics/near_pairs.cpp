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

}  // namespace

// Every pair is written, and only those that are near are stepped over: no branch to mispredict.
std::vector<NearPair> near_pairs(const Spheres& s, const Block& block, const WideList& wide,
                                 double skin, std::uint32_t species) {
  std::vector<NearPair> found(wide.partner.size() + Lanes::count);
  std::size_t count = 0;
  for (std::uint32_t row = 0; row < block.size(); ++row) {
    const std::uint32_t i = block.first + row, of_i = s.label[i].species;
    const Sphere& a = s.sphere[i];
    const Lanes x{a.position[0]}, y{a.position[1]}, z{a.position[2]}, radius{a.radius};
    const std::uint32_t last = wide.start[row + 1];
    for (std::uint32_t k = wide.start[row]; k < last; k += Lanes::count) {
      const auto partner = [&](std::size_t l) {
        return wide.partner[std::min(k + static_cast<std::uint32_t>(l), last - 1)];
      };
      Lanes b[4];
      gather([&](std::size_t l) { return s.sphere[partner(l)].position.data(); }, b);
      const Lanes dx = x - b[0], dy = y - b[1], dz = z - b[2], sum = radius + b[3];
      const Lanes squared = dx * dx + dy * dy + dz * dz, reach = sum + Lanes{skin};
      const std::uint32_t is_near = bits(reach * reach > squared);
      const std::uint32_t touches = bits(sum * sum > squared);
      for (std::uint32_t l = 0; l < Lanes::count; ++l) {
        const std::uint32_t j = partner(l), of_j = s.label[j].species;
        const std::uint32_t law = std::min(of_i, of_j) * species + std::max(of_i, of_j);
        found[count] = {i, j, 2 * law + 1 - ((touches >> l) & 1U)};
        count += k + l < last ? (is_near >> l) & 1U : 0U;
      }
    }
  }
  found.resize(count);
  return sorted(found, 2 * species * species);
}

}  // namespace pmr::physics
