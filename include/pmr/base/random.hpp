// Counter-based random numbers: a number depends only on (seed, purpose, id, step, draw), never on
// who asked before. Mixing function: SplitMix64 finaliser (Steele, Lea & Flood, OOPSLA 2014).
#pragma once
#include <cstdint>

namespace pmr {

enum class Purpose : std::uint64_t {
  insertion = 1,
  rays = 2,
  quasi_shift = 3,
  sizes = 4,
  pouring = 5,
  bootstrap = 6,
  adhesion = 7,
  test = 99
};

constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// A stream of uniform numbers for one (seed, purpose, id, step).
class Random {
 public:
  constexpr Random(std::uint64_t seed, Purpose purpose, std::uint64_t id, std::uint64_t step = 0)
      : key_(mix64(mix64(mix64(mix64(seed) ^ static_cast<std::uint64_t>(purpose)) ^ id) ^ step)) {}

  constexpr std::uint64_t bits() { return mix64(key_ + 0x9e3779b97f4a7c15ULL * ++draw_); }
  // Uniform in [0, 1) with 53 bits [1].
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t key_;
  std::uint64_t draw_ = 0;
};

}  // namespace pmr
