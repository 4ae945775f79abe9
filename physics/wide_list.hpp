// The wide list of a run of particles: all of its pairs that are closer than a skin.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/spheres.hpp"

namespace pmr::physics {

// A pair of two blocks stands in both, one within a block in the row of the earlier particle alone.
struct WideList {
  std::vector<std::uint32_t> start;    // [own + 1] rows of the run's particles
  std::vector<std::uint32_t> partner;  // of other blocks: any; of its own: those that come later
  std::vector<std::uint32_t> around;   // runs within the horizon that pairs may be formed with
  std::span<const std::uint32_t> row(std::uint32_t own) const {
    return {&partner[start[own]], start[own + 1] - start[own]};
  }
};

// Searches one run: every particle of the runs nearby that is near the box of this one is tested
// against all of its particles, eight at a time (clusters of particles instead of cells, as in Páll
// and Hess, Comput. Phys. Commun. 184 (2013) 2641): what is empty costs nothing, and only particles
// near a large one are tested with its reach. Runs may be searched concurrently. Pairs of grains
// that adhere to walls are left out.
class WideSearch {
 public:
  WideSearch() = default;
  WideSearch(const Spheres& spheres, const std::vector<Block>& blocks);  // radii are kept

  // Blocks with boxes (of whole spheres) closer than `horizon` [m] to that of one.
  std::vector<std::uint32_t> blocks_around(const Spheres& spheres, std::uint32_t block,
                                           double horizon) const;

  // Pairs of the run with surfaces closer than `skin` [m] as the spheres and their boxes stand, and
  // perhaps some that are farther apart by 1e-6 of the run's box, skin and largest diameter;
  // `around` are the runs with boxes (of whole spheres) closer than `horizon` >= skin [m], of those
  // of `blocks`.
  void find(const Spheres& spheres, std::uint32_t run, std::span<const std::uint32_t> blocks,
            double skin, double horizon, WideList& list) const;

  double largest_radius() const { return largest_; }  // [m]

 private:
  struct Candidates;
  // True of a sphere that adheres to a wall; two of them are no pair.
  bool adheres(std::size_t sphere) const { return sphere >= adhered_from_; }
  void look_around(const Spheres& spheres, std::uint32_t run, std::span<const std::uint32_t> blocks,
                   double horizon, WideList& list) const;
  Candidates candidates(const Spheres& spheres, std::uint32_t run, double skin,
                        const WideList& list) const;

  std::vector<Block> blocks_;
  std::vector<double> block_radius_, run_radius_;  // [m] largest in each
  std::vector<std::uint32_t> run_size_;            // [spheres]
  std::size_t adhered_from_ = SIZE_MAX;            // spheres from here on adhere to walls
  double largest_ = 0.0;                           // [m] radius
};

}  // namespace pmr::physics
