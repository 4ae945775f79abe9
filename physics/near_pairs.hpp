// Thinning out: the pairs of a wide list that are closer than a smaller skin.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/spheres.hpp"
#include "physics/wide_list.hpp"

namespace pmr::physics {

struct NearPair {
  std::uint32_t own, partner;  // own: whose row it stands in
  std::uint32_t kind;          // twice the index of its law, one more if it does not touch
};

// What a run of the block's particles brings in.
struct NearRun {
  const WideList* wide;
  double skin;  // [m] at most that of the wide list
};

// Pairs of the block closer than their run's skin, by kind; the law of kinds a and b has the
// index min(a, b) * kinds + max(a, b).
std::vector<NearPair> near_pairs(const Spheres& spheres, const Block& block,
                                 std::span<const NearRun> runs, std::uint32_t kinds);

}  // namespace pmr::physics
