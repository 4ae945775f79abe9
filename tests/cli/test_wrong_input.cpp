// Each wrong input: one clear line, exit status 2, nothing left behind.
#include <catch2/catch.hpp>
#include <fstream>

#include "program.hpp"

namespace fs = std::filesystem;

namespace {

// Runs the tiny case with a change; the output folder must not come to be.
void refuses(const std::string& arguments, const std::string& wanted, int faults = 1) {
  const Scratch scratch("refused");
  const fs::path out = scratch.path / "out";
  const Said said = pmr_says("run " + arguments + " -o " + out.string());
  INFO(arguments << " -> " << said.text);
  CHECK(said.status == 2);
  CHECK(said.text.find(wanted) != std::string::npos);
  CHECK(std::count(said.text.begin(), said.text.end(), '\n') == faults);
  CHECK_FALSE(fs::exists(out));
}

std::string with(const std::string& set) { return tiny + " --set '" + set + "'"; }

}  // namespace

TEST_CASE("A mistyped key is named with the nearest valid one") {
  refuses(with("species.Al2O3.diametre = \"3 mm\""), "diameter");
}
TEST_CASE("A number without its unit is refused") {
  refuses(with("species.Al2O3.diameter = 2.99"), "unit");
}
TEST_CASE("A unit of another dimension is refused") {
  refuses(with("species.Al2O3.diameter = \"2.99 kg\""), "species.Al2O3.diameter");
}
TEST_CASE("A negative mass is refused") {
  const Scratch scratch("negative");
  std::ifstream in(tiny);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  text.replace(text.find("count = 20"), 10, "mass = \"-1 g\"");
  std::ofstream(scratch.path / "case.toml") << text;
  refuses((scratch.path / "case.toml").string(), "species.Al2O3.mass");
}
TEST_CASE("An unknown material is named with the nearest one") {
  refuses(with("species.Al2O3.material = \"Al203\""), "Al2O3");
}
TEST_CASE("A missing STL file is named") {
  refuses(with("walls.part = {kind = \"stl\", file = \"nowhere.stl\", scale = \"1 mm\", material = "
               "\"coated-wall\", thermal = {kind = \"adiabatic\"}}"),
          "nowhere.stl");
}
TEST_CASE("Not-a-number is refused") {
  refuses(with("chamber.oxygen_fraction = nan"), "chamber.oxygen_fraction");
}
TEST_CASE("An empty case file is named as empty") {
  const Scratch scratch("empty");
  std::ofstream(scratch.path / "case.toml").close();
  refuses((scratch.path / "case.toml").string(), "empty");
}
TEST_CASE("Particles that do not fit their region are counted") {
  refuses(with("species.SrFeO3.count = 5000"), "SrFeO3");
}
TEST_CASE("A case file that is not there is named") {
  refuses("/nowhere/case.toml", "/nowhere/case.toml");
}
TEST_CASE("An output folder that cannot be made is named") {
  const Said said = pmr_says("run " + tiny + " -o /proc/nowhere/out");
  CHECK(said.status == 2);
  CHECK(said.text.find("/proc/nowhere/out") != std::string::npos);
}
TEST_CASE("A folder of the user's own files is not overwritten") {
  const Scratch scratch("precious");
  std::ofstream(scratch.path / "thesis.tex") << "all my work";
  const Said said = pmr_says("run " + tiny + " -o " + scratch.path.string());
  CHECK(said.status == 2);
  CHECK(fs::exists(scratch.path / "thesis.tex"));
  CHECK_FALSE(fs::exists(scratch.path / "run.h5"));
}
TEST_CASE("Particles that begin in a wall are refused") {
  refuses(with("walls.floor.centre = \"0 0 3 mm\""), "overlap wall 'floor'");
}
TEST_CASE("A gas colder than any law of heat is refused") {
  refuses(with("chamber.gas_temperature = \"-150 degC\""), "chamber.gas_temperature");
}
TEST_CASE("A run that loses its particles fails and leaves what it computed") {
  const Scratch scratch("lost");
  const std::string shallow =
      " --set 'walls.side.height = \"1 mm\"' --set 'walls.floor.radius = "
      "\"3 mm\"' --mechanics -o " +
      (scratch.path / "out").string();
  const Said said = pmr_says("run " + tiny + shallow);
  INFO(said.text);
  CHECK(said.status == 3);
  CHECK(said.text.find("particles left the domain") != std::string::npos);
  CHECK(said.text.find("models.mechanics.allowed_losses") != std::string::npos);
  CHECK(fs::exists(scratch.path / "out/summary.json"));
  CHECK(pmr_says("run " + tiny + " --set models.mechanics.allowed_losses=140" + shallow).status ==
        0);
}
TEST_CASE("Several faults are told together") {
  refuses(with("species.Al2O3.diametre = \"3 mm\"") + " --set 'chamber.volume = 3'", "volume", 2);
}
TEST_CASE("An unknown verb is refused with the usage") {
  CHECK(pmr_says("fly").status == 2);
  const Said said = pmr_says("rum --help");
  CHECK(said.status == 2);
  CHECK(said.text == "pmr: verb 'rum' is unknown; did you mean 'run'?\n");
  for (const char* wrong :
       {"run", "run a.toml b.toml", "run a.toml --nothing", "run a.toml --threads x", "resume",
        "render out", "render out -o p.png --colour heat", "sweep", "sweep a.toml --engine cloud",
        "report out --frames soon", "verify x"})
    CHECK(pmr_says(wrong).status == 2);
  CHECK(pmr_says("").status == 2);
  CHECK(pmr_says("--help").status == 0);
}
