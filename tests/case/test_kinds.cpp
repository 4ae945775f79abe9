// What keys say of themselves: files, and what moves no particle.
#include <catch2/catch.hpp>
#include <fstream>

#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

std::string mechanical(const std::vector<std::string>& sets = {}) {
  return load(small_case, sets).mechanical_text;
}

}  // namespace

TEST_CASE("cases that differ in what moves no particle have one mechanical text") {
  const std::string plain = mechanical();
  CHECK_THAT(plain, Contains("diameter") && !Contains("temperature") && !Contains("title"));
  for (const char* set :
       {"title=\"another\"", "description=\"x\"", "species.bead.temperature=\"90 degC\"",
        "materials.Al2O3.emissivity=0.5", "materials.Al2O3.accommodation=0.5",
        "walls.floor.thermal={kind = \"fixed\", temperature = \"90 degC\"}",
        "models.mechanics_only=true", "models.mechanics.allowed_losses=3",
        "output.snapshot_times=\"1 s\"", "output.cut_normal=[1, 0, 0]",
        "thermocouples.tip={position = \"0 0 0 m\", radius = \"1 mm\"}"}) {
    INFO(set);
    CHECK(mechanical({set}) == plain);
  }
}

TEST_CASE("what moves particles, and a key that says nothing, stay in the mechanical text") {
  const std::string plain = mechanical();
  for (const char* set : {"species.bead.diameter=\"3 mm\"", "materials.Al2O3.density=\"1 g/cm3\"",
                          "fill.rest_speed=\"1 mm/s\"", "seed=2", "models.mechanics.skin=0.4",
                          "output.snapshot_interval=\"1 s\""}) {
    INFO(set);
    CHECK(mechanical({set}) != plain);
  }
}

TEST_CASE("a file's name starts from the folder of the file that names it") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "pmr_test_kinds";
  fs::create_directories(folder / "base");
  std::ofstream(folder / "base/beads.csv") << "species, x [mm], y [mm], z [mm]\nbead, 0, 0, 5\n";
  std::string base = replaced(small_case, "mass = \"10 g\"\n", "");
  base =
      replaced(base, "region = {base = \"0 0 0 m\", radius = \"20 mm\", height = \"80 mm\"}", "");
  std::ofstream(folder / "base/case.toml") << "particles = {csv = \"beads.csv\"}\n" << base;
  std::ofstream(folder / "case.toml") << "extends = \"base/case.toml\"\n";
  const Case made = casefile::load_case(folder / "case.toml");
  CHECK(made.particles.size() == 1);
  CHECK_THAT(made.text, Contains("csv = \"" + (folder / "base/beads.csv").string() + "\""));
  CHECK(load(made.text).particles.size() == 1);
  fs::remove_all(folder);
}
