#include "physics/blocks.hpp"

#include <algorithm>

namespace pmr::physics {
namespace {

constexpr std::size_t smallest_block = 128;  // [particles]
constexpr std::size_t wanted_blocks = 32;

}  // namespace

std::vector<Block> cut(std::size_t n) {
  const std::size_t even = n / wanted_blocks / run_length * run_length;
  const std::size_t size = std::clamp<std::size_t>(even, smallest_block, largest_block);
  std::vector<Block> blocks;
  for (std::size_t first = 0; first < n; first += size)
    blocks.push_back({.number = static_cast<std::uint32_t>(blocks.size()),
                      .first = static_cast<std::uint32_t>(first),
                      .last = static_cast<std::uint32_t>(std::min(n, first + size))});
  return blocks;
}

}  // namespace pmr::physics
