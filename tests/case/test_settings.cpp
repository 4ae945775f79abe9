#include <catch2/catch.hpp>

#include "case/node.hpp"
#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

TEST_CASE("a setting changes a value, nested or in a list") {
  const Case made =
      load(small_case, {"species.bead.diameter = \"3 mm\"", "walls.floor.normal.0=1.0",
                        "contacts.\"Al2O3|Al2O3\".friction=0.9"});
  CHECK(made.species[0].diameter == Approx(3e-3).epsilon(1e-15));
  const auto& plane = std::get<Plane>(made.walls.surfaces.at(0).shape);
  CHECK(plane.normal.isApprox(Vec3(1, 0, 1).normalized()));
  const std::uint32_t bead = made.species[0].material;
  CHECK(made.materials.pair(bead, bead).friction == 0.9);
  CHECK(made.materials.pair(bead, bead).restitution == 0.75);  // the shipped one stays
}

TEST_CASE("a setting with an unknown key is a fault that names the setting") {
  const auto faults = faults_of(small_case, {"species.bead.diametr=\"3 mm\""});
  REQUIRE(faults.size() == 1);
  CHECK(faults[0] ==
        "--set species.bead.diametr=\"3 mm\": species.bead.diametr: key 'diametr' is unknown; did "
        "you mean 'diameter'?");
}

TEST_CASE("a setting that is not TOML says how to write one") {
  const auto faults = faults_of(small_case, {"species.bead.diameter=3 mm"});
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0],
             Contains("--set species.bead.diameter=3 mm") && Contains("dotted.key=VALUE"));
  CHECK_THAT(faults_of(small_case, {"walls.floor.normal.7=1.0"}).at(0),
             Contains("no index into a list of 3"));
}

TEST_CASE("the text of a case with settings reads back to the same case") {
  const Case first = load(small_case, {"species.bead.mass=\"20 g\"", "seed=7"});
  const Case second = load(first.text);
  CHECK(second.species[0].count == first.species[0].count);
  CHECK(second.species[0].requested_mass == Approx(0.02).epsilon(1e-15));
  CHECK(second.seed == 7);
  CHECK(second.text == first.text);
}

TEST_CASE("written TOML holds the values it was made from") {
  const std::string text =
      "a = [1, 2.5, {b = \"q\\\"\\\\\\n\", c = true}]\nbig = 1e300\n\n"
      "[\"odd|key\".inner]\nx = -0.1\n";
  const casefile::Node node = casefile::parse_toml(text, "x");
  const std::string written = casefile::write_toml(node);
  CHECK(casefile::write_toml(casefile::parse_toml(written, "y")) == written);
  CHECK_THAT(written, Contains("-0.1") && Contains("1e+300") && Contains("[\"odd|key\".inner]"));
}

TEST_CASE("A time step is automatic unless given, and no longer than 40 % of Rayleigh") {
  CHECK_FALSE(load(small_case).models.mechanics.time_step);
  CHECK_FALSE(load(small_case, {"models.mechanics.time_step=\"auto\""}).models.mechanics.time_step);
  CHECK(load(small_case).models.mechanics.fraction_of_rayleigh == 0.189);  // Richter et al.
  const std::string step = "models.mechanics.time_step=\"0.1 ms\"";  // 45 % for beads of 2.99 mm
  const auto faults = faults_of(small_case, {step});
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Contains("models.mechanics.time_step") &&
                            Contains("Rayleigh step of bead") && Contains("allow_long_time_step"));
  CHECK(faults_of(small_case, {step, "models.mechanics.allow_long_time_step=true"}).empty());
}
