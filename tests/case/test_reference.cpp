// Reference data of the decomposition: a CSV file, read whole or refused with every fault.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "case/reference.hpp"
#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

const std::string tool_text = R"([decomposition]
axis_point = "0 0 0 m"
ramp_azimuth = "0 deg"
layer_fraction = [0.4, 0.4]
sectors = 4
)";

Decomposition tool() { return {Vec3::Zero(), 0.0, {0.4, 0.4}, 4, "", {}}; }

std::string written(const std::string& text) {
  std::string file = temporary("pmr_reference.csv");
  std::ofstream(file) << text;
  return file;
}

MixtureReference read(const std::string& text) {
  return casefile::load_reference(written(text), tool());
}

std::string faults_in(const std::string& text) {
  try {
    read(text);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a reference gives a mass ratio for each layer, in any order") {
  const MixtureReference reference = read("# measured\nlayer, mass_ratio\n2, 0.5\n\n1, 3.5\n");
  CHECK(reference.name == "pmr_reference.csv");
  CHECK(reference.layers == std::vector<double>{3.5, 0.5});
  CHECK(reference.sections.empty());
}

TEST_CASE("a reference by sections gives the means of what was measured") {
  const MixtureReference reference =
      read("layer [1],azimuth [deg],mass_ratio [1]\n1,0,4\n1,90,2\n1,-180,\n1,270,nan\n2,-90,1\n");
  CHECK(reference.layers == std::vector<double>{3.0, 1.0});
  CHECK(reference.sections.at(0).at(1) == 2.0);
  CHECK(std::isnan(reference.sections.at(0).at(2)));
  CHECK(reference.sections.at(1).at(3) == 1.0);
}

TEST_CASE("the sections of another run are a reference") {
  const MixtureReference reference = read(
      "layer [1],azimuth [deg],mass_ratio [1],bead_mass [kg],granule_mass [kg],beads [1],"
      "granules [1]\n1,0,3,0.3,0.1,6,16\n2,180,0.5,0.1,0.2,2,32\n");
  CHECK(reference.layers == std::vector<double>{3.0, 0.5});
}

TEST_CASE("a bad reference is refused with every fault, its line and what was wanted") {
  const std::string faults = faults_in(
      "layer, azimuth [deg], mass_ratio\n3, 0, 1\n1, 30, 1\n1, 90, -2\n2, 0, x\n2, 90\n"
      "2, 180, 1\n2, -180, 1\n");
  CHECK_THAT(faults, Contains(".csv:2:1: layer: '3' is no layer of the tool; wanted a whole "
                              "number from 1 to 2"));
  CHECK_THAT(faults, Contains(".csv:3:1: azimuth: '30' is no sector's centre; the tool's 4 "
                              "sectors have theirs every 90 deg"));
  CHECK_THAT(faults, Contains(".csv:4:1: mass_ratio: '-2' is no mass ratio; wanted a number "
                              "above 0"));
  CHECK_THAT(faults, Contains(".csv:5:1: mass_ratio: 'x' is no mass ratio"));
  CHECK_THAT(faults, Contains(".csv:6:1: has 2 cells; the header has 3"));
  CHECK_THAT(faults, Contains(".csv:8:1: layer: stands twice, first in line 7"));
}

TEST_CASE("a bad header of a reference is refused") {
  CHECK_THAT(faults_in("layer, mass_ration\n1, 1\n"),
             Contains(".csv:1:1: mass_ration: column 'mass_ration' is unknown; did you mean "
                      "'mass_ratio'?"));
  CHECK_THAT(faults_in("mass_ratio\n1\n"), Contains("layer: the column is missing"));
  CHECK_THAT(faults_in("layer, azimuth, mass_ratio\n"), Contains("azimuth: has no unit"));
  CHECK_THAT(faults_in("layer, azimuth [mm], mass_ratio\n"), Contains("is a length"));
  CHECK_THAT(faults_in("layer, layer, mass_ratio\n"), Contains("the column stands twice"));
  CHECK_THAT(faults_in("# nothing\n"), Contains("is empty; wanted 'layer, mass_ratio'"));
}

TEST_CASE("a reference wants every layer") {
  CHECK_THAT(faults_in("layer, mass_ratio\n1, 2\n"), Contains("layer 2 has no mass ratio"));
}

TEST_CASE("a case names its reference beside itself") {
  const std::string file = written("layer, mass_ratio\n1, 2\n2, 1\n");
  const Case made = load(small_case + tool_text + "reference = \"" + file + "\"\n");
  REQUIRE(made.decomposition->reference);
  CHECK(made.decomposition->reference->layers == std::vector<double>{2.0, 1.0});
  const auto faults =
      faults_of(small_case + tool_text + "reference = \"no-such.csv\"\nsector = 3\n");
  REQUIRE(faults.size() == 2);  // with the mistyped key, together
  CHECK_THAT(faults[0] + faults[1], Contains("no-such.csv: cannot be read"));
}

TEST_CASE("a relative reference becomes absolute in the record") {
  const std::filesystem::path file = written("layer, mass_ratio\n1, 2\n2, 1\n");
  const Case made = casefile::load_case_text(
      small_case + tool_text + "reference = \"" + file.filename().string() + "\"\n", "x.toml",
      file.parent_path());
  CHECK_THAT(made.text, Contains(file.string()));
  CHECK(casefile::load_case_text(made.text, "again", "/").decomposition->reference->layers ==
        std::vector<double>{2.0, 1.0});
}
