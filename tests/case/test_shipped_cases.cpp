#include <catch2/catch.hpp>
#include <filesystem>

#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;

namespace {
Case shipped(const std::string& name) {
  return casefile::load_case(PMR_SOURCE_DIR "/cases/" + name + ".toml");
}
}  // namespace

TEST_CASE("every shipped case loads, and loads again from its text") {
  int count = 0;
  std::vector<std::filesystem::directory_entry> entries;
  for (const char* folder : {"/cases", "/cases/lab", "/cases/validation/base"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(PMR_SOURCE_DIR) + folder))
      entries.push_back(entry);
  for (const auto& entry : entries) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    const Case made = casefile::load_case(entry.path());
    const Case again = load(made.text);
    CHECK(again.walls.surfaces.size() == made.walls.surfaces.size());
    CHECK(again.species.size() == made.species.size());
    CHECK(again.text == made.text);
    CHECK(made.text.front() == '#');  // opens with a comment
    ++count;
  }
  CHECK(count >= 24);
}

// 1 kg of each: 19,363 beads of 5.165e-5 kg and 173,769 granules of 5.755e-6 kg, by diameter and
// density of the study (rho pi d^3 / 6).
TEST_CASE("a kilogram is 19363 beads and 173769 granules") {
  const Case made = shipped("demonstrator");
  REQUIRE(made.species.size() == 2);
  CHECK(made.species[0].name == "Al2O3");
  CHECK(made.species[0].count == 19363);
  CHECK(made.species[1].count == 173769);
  CHECK(*made.models.mechanics.time_step == Approx(2e-5).epsilon(1e-15));
}

// The plan's points mix as the hot one does: the same particles, the same walls.
TEST_CASE("the temperature plan changes temperatures and no particle") {
  const Case hot = shipped("demonstrator");
  for (const char* name : {"plan-700-400", "plan-400-200", "plan-ambient", "adiabatic"}) {
    const Case made = shipped(name);
    CHECK(made.title != hot.title);
    CHECK(made.species.at(0).count == hot.species.at(0).count);
    CHECK(made.species.at(1).count == hot.species.at(1).count);
    CHECK(made.walls.surfaces.size() == hot.walls.surfaces.size());
    CHECK(made.chamber->volume == hot.chamber->volume);
  }
  CHECK(shipped("plan-400-200").species.at(1).initial_temperature == Approx(473.15));
}

TEST_CASE("the small cases hold the same 3862 spheres, hot or ambient") {
  for (const char* name : {"demonstrator-small", "demonstrator-small-ambient", "adiabatic-small"}) {
    const Case made = shipped(name);
    CHECK(made.species.at(0).count == 387);
    CHECK(made.species.at(1).count == 3475);
    CHECK(made.react->end >= 1800.0);
  }
}

TEST_CASE("mechanics alone keeps particles, walls and their phases, and no heat, gas or reaction") {
  const std::string file = PMR_SOURCE_DIR "/cases/demonstrator-small.toml";
  const std::vector<std::string> sets{"models.mechanics_only=true"};
  const Case made = casefile::load_case(file, sets), whole = shipped("demonstrator-small");
  CHECK(made.walls.surfaces.size() == whole.walls.surfaces.size());
  CHECK(made.species.at(0).count == 387);
  CHECK((made.fill && made.mix && !made.react && !made.chamber));
  CHECK((!made.models.conduction && !made.models.radiation && !made.models.reaction));
  CHECK(load(made.text).text == made.text);
}

TEST_CASE("the heat network of the small rig stays below 120 wall patches") {
  std::size_t patches = 0;
  for (const Surface& surface : shipped("demonstrator-small").walls.surfaces)
    patches += std::size_t{surface.patches[0]} * surface.patches[1];
  CHECK(patches < 120);
}

TEST_CASE("the adiabatic case has no wall that takes heat") {
  for (const Surface& surface : shipped("adiabatic-small").walls.surfaces)
    CHECK(std::holds_alternative<Adiabatic>(surface.thermal));
}

TEST_CASE("layers of the decomposition add up to the bed without the residuum") {
  const Case made = shipped("demonstrator");
  double sum = 0.0;
  for (const double fraction : made.decomposition->layer_fraction) sum += fraction;
  CHECK(sum == Approx(1.0 - 197.02 / 1999.03).epsilon(1e-4));  // residuum over the mean total, g
  CHECK_FALSE(made.decomposition->reference);
}

// Samples of 150, 120, 100 g of granules (5.755 mg) and 400, 120, 100 g of beads (51.65 mg).
TEST_CASE("the lab tests hold the spheres of their samples, under the study's parameters") {
  const std::vector<std::pair<const char*, std::size_t>> tests{
      {"repose-SS", 26065},  {"repose-Sw", 26065},   {"repose-AA", 7745},    {"repose-Aw", 7745},
      {"repose-AS", 7745},   {"conveyor-SS", 20852}, {"conveyor-Sw", 20852}, {"conveyor-AA", 2324},
      {"conveyor-Aw", 2324}, {"conveyor-AS", 2324},  {"impact-S", 17377},    {"impact-A", 1936}};
  for (const auto& [name, count] : tests) {
    INFO(name);
    const Case made = shipped(std::string("lab/") + name);
    REQUIRE(made.species.size() == 1);
    CHECK(made.species[0].count == count);
    CHECK(made.walls.grains.empty() == (std::string(name).back() == 'w' || name[0] == 'i'));
    CHECK((made.heap.has_value() || !made.catches.empty()));
    CHECK(*made.models.mechanics.time_step == Approx(2e-5).epsilon(1e-15));
  }
  const Case across = shipped("lab/conveyor-AS");
  const PairContact& pair =
      across.materials.pair(across.species[0].material, across.walls.grains.front().material);
  CHECK(pair.friction == Approx(0.30));
  CHECK(pair.rolling_friction == Approx(0.13));
  const auto motion_of = [&](const char* wall) {
    for (const Body& body : across.walls.bodies)
      if (body.name == wall) return std::get<Oscillate>(body.motion);
    throw std::runtime_error(wall);
  };
  CHECK(motion_of("back").amplitude == motion_of("floor").amplitude);
  CHECK(motion_of("floor").amplitude.x() == Approx(7.16e-3));
}
