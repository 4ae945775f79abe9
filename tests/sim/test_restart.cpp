// Same bits on any number of threads, and over stop and resume, with moving walls and all physics.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "case/case.hpp"
#include "folder.hpp"
#include "io/run_file.hpp"
#include "pmr/base/parallel.hpp"
#include "sim/ledger.hpp"
#include "sim/simulation.hpp"

namespace fs = std::filesystem;
using namespace pmr;
using pmr::test::Folder;

namespace {

const std::atomic<bool> no_stop{false};

Case whole_case() { return casefile::load_case(fs::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml"); }

std::uint64_t hash_of_whole_run(int threads, const std::string& name) {
  const ThreadLimit limit(threads);
  const Folder folder(name);
  const Case c = whole_case();
  sim::Simulation simulation(c, folder.path);
  REQUIRE(simulation.run(no_stop, [](const auto&) {}) == sim::Ending::completed);
  return io::state_hash(simulation.state());
}

}  // namespace

TEST_CASE("A run has the same bits on one and on two threads") {
  CHECK(hash_of_whole_run(1, "one") == hash_of_whole_run(2, "two"));
}

TEST_CASE("A run that is stopped in any phase and resumed has the bits of one that is not") {
  const std::uint64_t whole = hash_of_whole_run(2, "whole");
  const Case c = whole_case();
  for (const std::uint64_t stop_after : {3U, 15U, 30U, 60U}) {
    const Folder folder("stopped");
    {
      std::atomic<bool> stop{false};
      sim::Simulation first(c, folder.path);
      const auto ending = first.run(
          stop, [&](const sim::Simulation& now) { stop = now.state().interval >= stop_after; });
      REQUIRE(ending == sim::Ending::stopped);
    }
    State state = io::load_checkpoint(folder.path);
    INFO("stopped at interval " << state.interval << ", t = " << state.time << " s");
    sim::Simulation second(c, folder.path, std::move(state));
    REQUIRE(second.run(no_stop, [](const auto&) {}) == sim::Ending::completed);
    CHECK(io::state_hash(second.state()) == whole);
  }
}

TEST_CASE("A run that is stopped within an interval is that of the last complete one") {
  const std::uint64_t whole = hash_of_whole_run(2, "uncut");
  const Case c = whole_case();
  for (int k = 0; k < 8; ++k) {
    const Folder folder("cut");
    {
      std::atomic<bool> stop{false};
      std::atomic<int> interval{0};
      sim::Simulation first(c, folder.path);
      // Asks once some interval has begun: two in the mixing, the others in the react phase.
      const int wanted = k < 2 ? 1 + k : 8 * k;
      std::thread asks([&] {
        while (interval < wanted) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        stop = true;
      });
      first.run(stop, [&](const sim::Simulation& now) {
        interval = static_cast<int>(now.state().interval);
      });
      interval = wanted;
      asks.join();
    }
    State state = io::load_checkpoint(folder.path);
    INFO("stopped at interval " << state.interval << ", t = " << state.time << " s");
    const io::Series series = io::read_series(folder.path);
    CHECK(series.values("time").back() == state.time);
    sim::Simulation second(c, folder.path, std::move(state));
    REQUIRE(second.run(no_stop, [](const auto&) {}) == sim::Ending::completed);
    CHECK(io::state_hash(second.state()) == whole);
  }
}

TEST_CASE("An interval that fails leaves the last complete one, saved") {
  Case c = whole_case();
  const Folder folder("fails");
  sim::Simulation simulation(c, folder.path);
  std::uint64_t last = 0;
  CHECK_THROWS_AS(simulation.run(no_stop,
                                 [&](const sim::Simulation& now) {
                                   last = io::state_hash(now.state());
                                   // Nobody's heat can be computed from here on.
                                   if (now.state().interval == 20)
                                     c.models.network.relative_tolerance = std::nan("");
                                 }),
                  std::exception);
  CHECK(io::state_hash(simulation.state()) == last);
  CHECK(io::state_hash(io::load_checkpoint(folder.path)) == last);
}

TEST_CASE("A run that ends in motion records the kinetic energy that it ends with") {
  Case c = whole_case();
  c.react.reset();
  c.mix->duration = 0.03;
  c.mix->not_before = 1.0;
  const Folder folder("moving");
  sim::Simulation simulation(c, folder.path);
  REQUIRE(simulation.run(no_stop, [](const auto&) {}) == sim::Ending::completed);
  const double energy = physics::kinetic_energy(simulation.state().particles);
  CHECK(energy > 1e-6);  // [J] 6 g that fell for 30 ms
  CHECK(io::read_series(folder.path).values("kinetic_energy").back() == energy);
}

TEST_CASE("The books of a whole run close, and no particle is lost") {
  const Folder folder("books");
  const Case c = whole_case();
  sim::Simulation simulation(c, folder.path);
  simulation.run(no_stop, [](const auto&) {});
  const sim::Balance balance = sim::close_books(c, simulation.state());
  CHECK(balance.energy_relative < sim::energy_limit);
  CHECK(balance.oxygen_relative < sim::oxygen_limit);
  CHECK(balance.alive == 140);
  CHECK(balance.lost == 0);
  CHECK(std::abs(balance.nitrogen_residual) < 1e-9 * simulation.state().fluxes.nitrogen_leaked);
  CHECK(simulation.state().fluxes.oxygen_leaked > 0.0);  // by the vent
  const io::Series series = io::read_series(folder.path);
  const auto& released = series.values("oxygen_released");
  CHECK(*std::max_element(released.begin(), released.end()) > 0.0);
  CHECK(io::read_series(folder.path).rows() > 50);
}

TEST_CASE(
    "With shells in the particles the books close, and a stopped run goes on with the same bits") {
  const std::vector<std::string> sets{"models.conduction={shells=3}"};
  const Case c = casefile::load_case(fs::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml", sets);
  const Folder whole("shells"), stopped("shells_stopped");
  sim::Simulation simulation(c, whole.path);
  REQUIRE(simulation.run(no_stop, [](const auto&) {}) == sim::Ending::completed);
  const sim::Balance balance = sim::close_books(c, simulation.state());
  CHECK(balance.energy_relative < sim::energy_limit);
  CHECK(balance.oxygen_relative < sim::oxygen_limit);
  const Shells& shells = simulation.state().shells;
  REQUIRE(shells.enthalpy.size() == 3UL * 140);
  CHECK(shells.enthalpy[0] != shells.enthalpy[140]);  // the outer shell is not the next one
  {
    std::atomic<bool> stop{false};
    sim::Simulation first(c, stopped.path);
    first.run(stop, [&](const sim::Simulation& now) { stop = now.state().interval >= 30; });
  }
  sim::Simulation second(c, stopped.path, io::load_checkpoint(stopped.path));
  REQUIRE(second.run(no_stop, [](const auto&) {}) == sim::Ending::completed);
  CHECK(io::state_hash(second.state()) == io::state_hash(simulation.state()));
}
