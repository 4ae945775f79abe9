// A run from another run's bed stands on its own once it has begun.
#include <catch2/catch.hpp>
#include <fstream>

#include "program.hpp"

TEST_CASE("A run from a bed says where it came from, and no longer needs it") {
  const Scratch scratch("bed");
  const std::string source = (scratch.path / "source").string();
  const std::string out = (scratch.path / "out").string();
  const std::string quick = " --set 'react.end = \"0.5 s\"'";
  REQUIRE(pmr_says("run " + tiny + quick + " -o " + source).status == 0);
  const Said checked = pmr_says("check " + tiny + " --bed " + source);
  CHECK(checked.status == 0);
  CHECK(checked.text.find("140 particles of the run " + source) != std::string::npos);
  const Said said = pmr_says("run " + tiny + quick + " --bed " + source + " -o " + out);
  INFO(said.text);
  REQUIRE(said.status == 0);
  std::ifstream in(out + "/report.html");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  CHECK(page.find("bed taken from") != std::string::npos);
  CHECK(page.find("hash of that file") != std::string::npos);
  std::filesystem::remove_all(source);
  CHECK(pmr_says("analyse " + out).status == 0);
  CHECK(pmr_says("resume " + out).status == 0);
}

TEST_CASE("A bed that is not there is refused, and nothing is written") {
  const Scratch scratch("nobed");
  const Said said =
      pmr_says("run " + tiny + " --bed /nowhere/bed -o " + (scratch.path / "out").string());
  CHECK(said.status == 2);
  CHECK(said.text.find("/nowhere/bed: bed: does not exist") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch.path / "out"));
}
