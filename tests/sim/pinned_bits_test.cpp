// The bits of a whole run with all physics, pinned: the same from each vector width, from any
// number of threads, and from GCC 12 and clang 14.
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>

#include "case/case.hpp"
#include "folder.hpp"
#include "io/run_file.hpp"
#include "pmr/base/parallel.hpp"
#include "pmr/base/stop.hpp"
#include "sim/simulation.hpp"

using namespace pmr;

namespace {

// Of tests/sim/tiny.toml: mechanics, conduction, radiation, reaction, pump, vent, gas in the bed.
// Whoever changes what the physics computes puts the new hash here, in the same commit; whoever
// does not, and sees another hash, has found a change that was not meant.
constexpr std::uint64_t pinned = 0x17bfb5815f0a24f5;

std::uint64_t hash_of_run(int threads) {
  const ThreadLimit limit(threads);
  const test::Folder folder("pinned");
  const Case c = casefile::load_case(std::filesystem::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml");
  sim::Simulation simulation(c, folder.path);
  REQUIRE(simulation.run(StopToken{}, [](const auto&) {}) == sim::Ending::completed);
  return io::state_hash(simulation.state());
}

}  // namespace

TEST_CASE("A tiny run with all physics ends in the pinned bits") {
  for (const int threads : {1, 2}) {
    INFO(threads << " threads");
    CHECK(hash_of_run(threads) == pinned);
  }
}
