// Which parts of the walls are near a place: an R-tree per body, in the body's frame, so that walls
// may move without being sorted anew.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "physics/motion.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::physics {

// A triangle of a facet, or the whole of another shape.
struct WallPart {
  static constexpr std::uint32_t whole = 0xffffffff;
  std::uint32_t surface;
  std::uint32_t triangle;  // of the surface's facet, or `whole`
};

class WallTree {
 public:
  // Surfaces that hold no particles are left out. Keeps references to shapes.
  explicit WallTree(const Walls& walls);
  ~WallTree();
  WallTree(const WallTree&) = delete;
  WallTree& operator=(const WallTree&) = delete;

  // Parts that may come within reach [m] of x [m], by surface, then triangle; bodies stand at
  // `poses`.
  std::vector<WallPart> near(const Vec3& x, double reach, const std::vector<Pose>& poses) const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace pmr::physics
