// The wide list of a block: all pairs of its particles that are closer than a skin.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/spheres.hpp"

namespace pmr::physics {

struct WideList {
  std::vector<std::uint32_t> start;    // [own + 1] rows of the block's particles
  std::vector<std::uint32_t> partner;  // of other blocks: any; of its own: those that come later
  std::span<const std::uint32_t> row(std::uint32_t own) const {
    return {&partner[start[own]], start[own + 1] - start[own]};
  }
  std::vector<std::uint32_t> neighbours;  // blocks within the horizon, itself among them
};

// Searches one block: particles of the runs whose boxes come near are binned into a local grid per
// class of size, so that empty space costs nothing and small particles are not searched for with
// the reach of large ones (the hierarchical grid of Ogarko and Luding, Comput. Phys. Commun. 183
// (2012) 931). Blocks may be searched concurrently.
class WideSearch {
 public:
  WideSearch() = default;
  WideSearch(const Spheres& spheres, const std::vector<Block>& blocks);  // radii are kept

  // Pairs of the block with surfaces closer than `skin` [m] as the spheres and their boxes stand;
  // neighbours are the blocks with boxes (of whole spheres) closer than `horizon` >= skin [m].
  void find(const Spheres& spheres, std::uint32_t block, double skin, double horizon,
            WideList& list) const;

  double largest_radius() const { return largest_.empty() ? 0.0 : largest_.back(); }  // [m]

 private:
  struct Candidates;
  std::size_t class_of(double radius) const;
  Candidates candidates(const Spheres& spheres, std::uint32_t block, double skin,
                        const std::vector<std::uint32_t>& neighbours) const;

  std::vector<Block> blocks_;
  std::vector<double> block_radius_, run_radius_;  // [m] largest in each
  std::vector<double> largest_;                    // [classes] radius [m]
  double smallest_ = 0.0;                          // [m] radius
};

}  // namespace pmr::physics
