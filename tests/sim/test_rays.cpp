// What a tracing costs is known before it is done, and told where it had to be bounded.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "case/case.hpp"
#include "coupling/ray_count.hpp"
#include "folder.hpp"
#include "sim/forecast.hpp"
#include "sim/simulation.hpp"
#include "sim/summary.hpp"

using namespace pmr;

namespace {

// One grain in the middle of a lined box of 0.4 m.
Case grain(const std::string& diameter) {
  return casefile::load_case_text(R"(
title = "Grain"
gravity = "none"
[domain]
low = "-0.4 -0.4 -0.4 m"
high = "0.4 0.4 0.4 m"
[species.grain]
material = "Al2O3"
diameter = ")" + diameter + R"("
temperature = "1200 K"
[[particles]]
species = "grain"
position = "0 0 0 m"
[walls.box]
kind = "box"
material = "coated-wall"
low = "-0.2 -0.2 -0.2 m"
high = "0.2 0.2 0.2 m"
[walls.box.thermal]
kind = "lining"
layers = [{material = "fibre-board", thickness = "2 mm"}]
initial_temperature = "300 K"
outside_film_coefficient = "10 W/m2/K"
outside_temperature = "300 K"
[react]
end = "20 ms"
[models]
conduction = false
[models.radiation]
surroundings = "300 K"
rays_settled = 100
)",
                                  "grain.toml", ".");
}

}  // namespace

TEST_CASE("The forecast counts the rays that a tracing sends") {
  const Case c = grain("10 mm");
  const test::Folder folder("rays");
  sim::Simulation simulation(c, folder.path);
  simulation.step();
  const coupling::RayCount count = coupling::count_rays(c, c.models.radiation->rays_settled);
  CHECK(count.sent == simulation.state().exchange.rays);
  CHECK(count.wanted == count.sent);
  CHECK(count.sent > 1e5);
}

TEST_CASE("A grain that is small beside its walls asks for a bounded number of rays, and is told") {
  const Case c = grain("0.1 mm");
  const coupling::RayCount count = coupling::count_rays(c, c.models.radiation->rays_settled);
  CHECK(count.wanted > 1e9);
  CHECK(count.sent <= 1e7);
  const sim::UnitCosts second_a_ray{.ray = 1.0};
  CHECK(sim::forecast(c, second_a_ray).react.tracing == count.sent);
  State state;
  state.exchange.rays = count.sent;
  std::string all;
  for (const std::string& limit : sim::limits_touched(c, state)) all += limit;
  CHECK_THAT(all, Catch::Contains("rays of equal power would be"));
}
