// Shipped cases from any folder: by name, from the build folder and from an installed copy.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "program.hpp"

namespace fs = std::filesystem;

namespace {

// What `program` says when started in `folder`.
Said says(const fs::path& folder, const std::string& program, const std::string& arguments) {
  const fs::path log = folder / "said.txt";
  const std::string command = "cd '" + folder.string() + "' && '" + program + "' " + arguments +
                              " > said.txt 2>&1 </dev/null";
  const int status = std::system(command.c_str());
  std::ifstream in(log);
  return {WEXITSTATUS(status), std::string(std::istreambuf_iterator<char>(in), {})};
}

}  // namespace

TEST_CASE("A shipped case is found by its name from any folder") {
  const Scratch scratch("by-name");
  for (const char* name : {"heat-pair", "heat-pair.toml"}) {
    const Said said = says(scratch.path, PMR_PROGRAM, std::string("check ") + name);
    INFO(said.text);
    CHECK(said.status == 0);
    CHECK(said.text.find("2 particles") != std::string::npos);
  }
}

TEST_CASE("A file of the user comes before a shipped case of its name") {
  const Scratch scratch("own-case");
  std::ofstream(scratch.path / "heat-pair").put('\n');
  const Said said = says(scratch.path, PMR_PROGRAM, "check heat-pair");
  CHECK(said.status == 2);
  CHECK(said.text.find("empty") != std::string::npos);
}

TEST_CASE("A name that is no case names the nearest shipped one and all of them") {
  const Scratch scratch("no-case");
  const Said said = says(scratch.path, PMR_PROGRAM, "run heat-pear");
  CHECK(said.status == 2);
  CHECK(said.text.find("did you mean 'heat-pair'") != std::string::npos);
  CHECK(said.text.find("demonstrator-small, ") != std::string::npos);
  CHECK_FALSE(fs::exists(scratch.path / "out"));
  const Said study = says(scratch.path, PMR_PROGRAM, "sweep mass-ratios --plan");
  CHECK(study.status == 2);
  CHECK(study.text.find("did you mean 'mass-ratio'") != std::string::npos);
}

TEST_CASE("An installed copy runs its own cases and brings documents and licence") {
  const Scratch scratch("installed");
  const fs::path prefix = scratch.path / "moved here";
  const std::string install = std::string("'") + PMR_CMAKE + "' --install '" + PMR_BINARY_DIR +
                              "' --prefix '" + prefix.string() + "' >/dev/null";
  REQUIRE(std::system(install.c_str()) == 0);
  for (const char* file :
       {"share/pmr/cases/demonstrator.toml", "share/pmr/cases/materials/Al2O3.toml",
        "share/pmr/cases/studies/mass-ratio.toml", "share/doc/pmr/copyright",
        "share/doc/pmr/CITATION.cff", "share/doc/pmr/docs/theory.md"})
    CHECK(fs::exists(prefix / file));
  const Said said = says(scratch.path, (prefix / "bin/pmr").string(), "run heat-pair");
  INFO(said.text);
  CHECK(said.status == 0);
  CHECK(said.text.find("moved here/share/pmr/cases/heat-pair.toml") != std::string::npos);
  CHECK(fs::exists(scratch.path / "out/heat-pair/report.html"));
}
