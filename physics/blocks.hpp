// Blocks: runs of particles that stand behind each other and, in spatial order, beside each other.
// They are the unit of parallel work, of lists and of bounds on motion.
#pragma once
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

inline constexpr std::size_t largest_block = 512;  // [particles]
inline constexpr std::size_t run_length = 32;      // [particles] blocks start at multiples of it

// Cuts n particles into blocks; their size depends on n only: small enough for threads to share
// the work evenly, large enough that few pairs cross (one in eight of a cube of 8 x 8 x 8).
std::vector<Block> cut(std::size_t n);

// The velocities of some particles lie in this box.
struct VelocityRange {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);  // [m/s]

  void include(const Vec3& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  void include(const VelocityRange& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool is_empty() const { return low[0] > high[0]; }
  // Bound on the relative speed of any two [m/s].
  double spread() const { return is_empty() ? 0.0 : (high - low).norm(); }
};

}  // namespace pmr::physics
