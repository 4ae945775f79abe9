// Walls that come in while a run goes on.
#include <atomic>
#include <catch2/catch.hpp>

#include "case/case.hpp"
#include "folder.hpp"
#include "pmr/base/errors.hpp"
#include "sim/simulation.hpp"
#include "sim/verdict.hpp"

using namespace pmr;
using Catch::Contains;
using pmr::test::Folder;

namespace {

const std::atomic<bool> no_stop_wished{false};

// One bead of 1.5 mm radius that lies on the floor.
const std::string lying = R"(
title = "a bead lies"
gravity = "0 0 -9.80665 m/s2"
domain = {low = "-20 -20 -10 mm", high = "20 20 20 mm"}
species.bead = {material = "Al2O3", diameter = "3 mm", temperature = "20 degC"}
particles = [{species = "bead", position = "0 0 1.5 mm"}]
walls.floor = {kind = "plane", material = "coated-wall", point = "0 0 0 m", normal = [0, 0, 1]}
mix = {duration = "50 ms", not_before = "50 ms", rest_speed = "2 mm/s", rest_hold = "20 ms"}
models.mechanics = {time_step = "20 us"}
)";

// A lid that comes in at this height and time.
std::string lid(const std::string& height, const std::string& from) {
  return "walls.lid={kind=\"plane\",material=\"coated-wall\",point=\"0 0 " + height +
         "\",normal=[0,0,-1],from=\"" + from + "\"}";
}

std::string ending(const std::vector<std::string>& sets) {
  const Case c = casefile::load_case_text(lying, "lying", {}, sets);
  const Folder folder("lid");
  sim::Simulation simulation(c, folder.path);
  try {
    simulation.run(no_stop_wished, [](const auto&) {});
  } catch (const NumericsError& error) {
    return error.what();
  }
  return "completed";
}

}  // namespace

TEST_CASE("A wall that comes in inside particles fails the run with their number and depth") {
  CHECK(ending({lid("3.1 mm", "30 ms")}) == "completed");
  CHECK(ending({lid("2.9 mm", "30 ms")}) == "completed");  // by 6.7 % of the radius
  CHECK_THAT(ending({lid("2.52 mm", "30.01 ms")}),         // within a sub-step
             Contains("a wall comes in where particles are: 1 particles overlap wall 'lid'") &&
                 Contains("particle 0 of radius 1.5 mm") && Contains("by 31.8"));
}

TEST_CASE("A wall that comes in after the motion is looked at, too") {
  CHECK_THAT(ending({"react={end=\"1 s\"}", "models.conduction={gap=false}",
                     "walls.floor.thermal={kind=\"adiabatic\"}", lid("2.5 mm", "0.5 s"),
                     "walls.lid.thermal={kind=\"adiabatic\"}"}),
             Contains("t = 0.5 s: a wall comes in where particles are"));
}

TEST_CASE("A run that loses more particles than its case allows is no good run") {
  const auto reasons = [](const std::vector<std::string>& sets) {
    const Case c = casefile::load_case_text(lying, "lost", {}, sets);
    const Folder folder("lost");
    sim::Simulation simulation(c, folder.path);
    CHECK(simulation.run(no_stop_wished, [](const auto&) {}) == sim::Ending::completed);
    return sim::reasons_to_fail(c, simulation.state());
  };
  CHECK(reasons({}).empty());
  const std::string away = "particles.0.velocity=\"1 0 0.3 m/s\"";
  const auto lost = reasons({away});
  REQUIRE(lost.size() == 1);
  CHECK_THAT(lost[0], Contains("1 particles left the domain, and 0 may; the first, particle 0, at "
                               "t = 0.02") &&
                          Contains("models.mechanics.allowed_losses"));
  CHECK(reasons({away, "models.mechanics.allowed_losses=1"}).empty());
}
