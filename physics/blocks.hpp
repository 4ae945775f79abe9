// Blocks: runs of particles that stand behind each other and, in spatial order, beside each other.
// They are the unit of parallel work, of lists and of bounds on motion.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr::physics {

struct Block {
  std::uint32_t number;       // its place among the blocks
  std::uint32_t first, last;  // particles [first, last)
  bool holds(std::uint32_t i) const { return i >= first && i < last; }
  std::uint32_t size() const { return last - first; }
};

inline constexpr std::uint32_t largest_block = 1024;  // [particles]
// Runs: the unit of bounds and of wide lists; blocks start at multiples of it.
inline constexpr std::uint32_t run_length = 32;  // [particles]

// Cuts n particles into blocks; their size depends on n only: small enough for threads to share
// the work evenly, large enough that few pairs cross (one in ten of a cube of 10 x 10 x 10).
std::vector<Block> cut(std::size_t n);

// The velocities of some particles lie in this box. Fourth components are 0, so that a range is
// taken in by two vector operations.
struct VelocityRange {
  Eigen::Array4d low = {1e300, 1e300, 1e300, 0.0};      // [m/s]
  Eigen::Array4d high = {-1e300, -1e300, -1e300, 0.0};  // [m/s]

  void include(const VelocityRange& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  void include(const Vec3& v) {
    low.head<3>() = low.head<3>().min(v.array());
    high.head<3>() = high.head<3>().max(v.array());
  }
  // Bound on the relative speed of any two [m/s].
  double spread() const { return low[0] > high[0] ? 0.0 : (high - low).matrix().norm(); }
};

}  // namespace pmr::physics
