// Particles that rain into a run, in fill and in mix, with heat.
#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

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

const std::atomic<bool> runs_on{false};

// Beads pour into the tiny cup while it mixes; the granules lie there already.
std::string rainy_text() {
  std::ifstream in(fs::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::string region = "region = {low = \"-4.5 -4.5 26 mm\", high = \"4.5 4.5 50 mm\"}";
  text.replace(
      text.find(region), region.size(),
      "pour = {base = \"0 0 40 mm\", radius = \"5 mm\", height = \"8 mm\", particle_rate = "
      "\"400 Hz\", velocity = \"0 0 -0.3 m/s\"}");
  return text;
}

Case rainy() {
  return casefile::load_case_text(rainy_text(), "rainy", {},
                                  std::vector<std::string>{"react.end=\"2 s\""});
}

}  // namespace

TEST_CASE("Poured particles are booked at every step: alive, lost or yet to come") {
  const Folder folder("books");
  const Case c = rainy();
  sim::Simulation simulation(c, folder.path);
  CHECK(simulation.state().particles.size() == 120);
  CHECK(simulation.state().waiting.size() == 20);
  std::size_t partly = 0;
  simulation.run(runs_on, [&](const sim::Simulation& now) {
    const sim::Balance books = sim::close_books(c, now.state());
    CHECK(books.inserted == 140);
    CHECK(books.closes());
    partly += books.waiting > 0 && books.waiting < 20 ? 1 : 0;
  });
  CHECK(partly > 0);
  CHECK(simulation.state().particles.size() == 140);
}

TEST_CASE("A run that is stopped while it rains, and resumed on one thread, has the same bits") {
  const Case c = rainy();
  const Folder whole("whole"), cut("cut");
  sim::Simulation first(c, whole.path);
  first.run(runs_on, [](const auto&) {});
  {
    std::atomic<bool> stop{false};
    sim::Simulation second(c, cut.path);
    second.run(stop, [&](const sim::Simulation& now) { stop = now.state().interval >= 2; });
    REQUIRE(second.state().waiting.size() > 0);
    REQUIRE(second.state().waiting.size() < 20);
  }
  const ThreadLimit limit(1);
  sim::Simulation third(c, cut.path, io::load_checkpoint(cut.path));
  third.run(runs_on, [](const auto&) {});
  CHECK(io::state_hash(third.state()) == io::state_hash(first.state()));
}

TEST_CASE("A fill that rains into an empty cup ends at rest, after the last particle") {
  std::string text = rainy_text();
  const std::string mix = "[mix]\nduration = \"80 ms\"\nnot_before = \"60 ms\"";
  text.replace(text.find(mix), mix.size(), "[fill]\nduration = \"600 ms\"");
  const std::string region = "region = {low = \"-4.5 -4.5 2 mm\", high = \"4.5 4.5 25 mm\"}";
  text.replace(
      text.find(region), region.size(),
      "pour = {low = \"-4.5 -4.5 40 mm\", high = \"4.5 4.5 48 mm\", mass_rate = \"10 g/s\", "
      "begin = \"-0.55 s\"}");
  const Case c = casefile::load_case_text(
      text, "fill", {},
      std::vector<std::string>{"react.end=\"1 s\"", "fill.rest_speed=\"5 mm/s\""});
  const Folder folder("fill");
  sim::Simulation simulation(c, folder.path);
  CHECK(simulation.state().particles.size() == 0);
  while (simulation.state().phase == Phase::fill) simulation.step();
  CHECK(simulation.state().waiting.size() == 0);
  CHECK(simulation.state().particles.size() == 140);
  CHECK(simulation.state().phase == Phase::react);
}

TEST_CASE("What is wrong with a source is said with its key") {
  std::string text = rainy_text();
  const auto load = [&](const std::string& set) {
    return casefile::load_case_text(text, "x", {}, std::vector<std::string>{set});
  };
  using Catch::Contains;
  CHECK_THROWS_WITH(load("species.Al2O3.pour.mass_rate=\"1 g/s\""),
                    Contains("mass_rate or particle_rate, not both"));
  CHECK_THROWS_WITH(load("species.Al2O3.pour.particle_rate=\"1 m\""),
                    Contains("wanted a number per time"));
  CHECK_THROWS_WITH(load("species.Al2O3.region={low=\"-4.5 -4.5 26 mm\",high=\"4.5 4.5 50 mm\"}"),
                    Contains("region or pour, not both"));
}
