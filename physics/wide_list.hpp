// The wide list of a block: all pairs of its particles that are closer than a skin.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/shapes.hpp"
#include "physics/spheres.hpp"

namespace pmr::physics {

struct WideList {
  std::vector<std::uint32_t> start;    // [own + 1] rows of the block's particles
  std::vector<std::uint32_t> partner;  // of other blocks: any; of its own: those that come later
  std::span<const std::uint32_t> row(std::uint32_t own) const {
    return {&partner[start[own]], start[own + 1] - start[own]};
  }
  std::vector<std::uint32_t> neighbours;  // blocks that may hold partners, itself among them
};

// Searches block by block: particles of the blocks whose boxes come near are binned into one local
// grid per class of size, so that empty space costs nothing and small particles are not searched
// for with the reach of large ones (the hierarchical grid of Ogarko and Luding, Comput. Phys.
// Commun. 183 (2012) 931). Const after construction: blocks may be searched concurrently.
class WideSearch {
 public:
  WideSearch(const Spheres& spheres, const std::vector<Block>& blocks, double skin);  // skin [m]
  void find(std::size_t block, WideList& list) const;

 private:
  struct Candidates;
  std::size_t class_of(double radius) const;
  Candidates candidates(std::size_t block, WideList& list) const;

  const Spheres& spheres_;
  const std::vector<Block>& blocks_;
  double skin_;                  // [m]
  double smallest_ = 0.0;        // [m] radius
  std::vector<double> largest_;  // [classes] radius [m]
  // Bounds of a few particles that stand behind each other.
  struct Bounds {
    Box box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};  // of the centres [m]
    double largest = 0.0;                                    // radius [m]
    void include(const Bounds& other);
  };
  static constexpr std::uint32_t run_length = 32;  // [particles] of a run
  std::vector<Bounds> bounds_;                     // [blocks]
  std::vector<std::vector<Bounds>> runs_;          // [blocks][runs]
};

}  // namespace pmr::physics
