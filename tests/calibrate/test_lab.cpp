// Lab files as their users write them.
#include <catch2/catch.hpp>

#include "bench.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

std::string faults_of(const std::string& text) {
  try {
    const Bench bench(text, [](const Case&) { return Said{}; });
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

const std::string lab_stage = "[stages.s]\nuse = [\"t.y\"]\n";
const std::string x = unknown("s", "x", "SrFeO3|coated-wall\".friction");

}  // namespace

TEST_CASE("All faults of a lab file are told together, with place and nearest key") {
  const std::string all = faults_of(R"([tests.t]
case = "nowhere.toml"
[tests.t.responses.y]
kye = "heap/angle"
result = {value = 26.8, standard_error = 0.2, relative_standard_error = 0.008, source = "A"}
[stages.s]
use = ["t.z"]
[stages.s.unknowns.x]
from = 1
to = 0
)");
  INFO(all);
  CHECK_THAT(all, Contains("lab.toml:4:") && Contains("there is no case file"));
  CHECK_THAT(all, Contains("lab.toml:6:") && Contains("did you mean 'key'"));
  CHECK_THAT(all, Contains("either standard_error or relative_standard_error"));
  CHECK_THAT(all, Contains("lab.toml:9:") && Contains("did you mean 't.y'"));
  CHECK_THAT(all, Contains("lab.toml:12:") && Contains("wanted above 'from'"));
}

TEST_CASE("What cannot be calibrated is refused") {
  const std::string test = test_table("t") + response("t", "y", 1.0, 0.1);
  CHECK(faults_of(test + lab_stage + x).empty());
  CHECK_THAT(faults_of(test + lab_stage + x + unknown("s", "a", "a") + unknown("s", "b", "b") +
                       unknown("s", "c", "c")),
             Contains("at most 3"));
  CHECK_THAT(faults_of(test_table("t") + response("t", "y", 1.0, 0.0) + lab_stage + x),
             Contains("wanted above 0 where the measured value has no error"));
  CHECK_THAT(faults_of(test_table("t") + response("t", "y", -1.0, 0.1, "scale = \"log\"\n") +
                       lab_stage + x),
             Contains("above 0 with scale"));
  CHECK_THAT(faults_of(test + lab_stage + x + "[derived.x]\nformula = \"1\"\n"),
             Contains("'x' is named twice"));
  CHECK_THAT(
      faults_of(test_table("t", "pairs = 4\n") + response("t", "y", 1.0, 0.1) + lab_stage + x),
      Contains("settings of a cheaper sample"));
  CHECK_THAT(faults_of(test + lab_stage + x + "[sampling]\npoints = 20\nmost = 10\n"),
             Contains("at least as many as 'points'"));
}

TEST_CASE("A key that no test knows is told with the nearest, before anything is written") {
  const std::string test = test_table("t") + response("t", "y", 1.0, 0.1);
  const auto refused = [&](const std::string& lab) {
    Bench bench(lab, [](const Case&) { return Said{}; });
    const study::Folder folder(bench.root / "out", "lab.toml");
    std::string said;
    try {
      calibrate::Runs(bench.lab, folder, "pmr", 1, [](const auto&) { return true; });
    } catch (const CaseError& error) {
      said = error.what();
    }
    CHECK_FALSE(std::filesystem::exists(bench.root / "out"));
    return said;
  };
  CHECK(refused(test + lab_stage + x).empty());
  CHECK_THAT(refused(test + lab_stage + unknown("s", "x", "SrFeO3|coated-wall\".frictoin")),
             Contains("did you mean 'friction'"));
  CHECK_THAT(refused(test + lab_stage + unknown("s", "x", "SrFeO3|CeO2\".friction")),
             Contains("no test has both materials"));
  CHECK_THAT(refused(test_table("t", "settings = {titel = \"b\"}\n") +
                     response("t", "y", 1.0, 0.1) + lab_stage + x),
             Contains("did you mean 'title'"));
}

TEST_CASE("A parameter reaches the tests with both of its materials alone") {
  Bench bench(test_table("t") + response("t", "y", 1.0, 0.1) +
                  "[tests.u]\ncase = \"" PMR_SOURCE_DIR "/cases/heat-pair.toml\"\n" +
                  response("u", "y", 1.0, 0.1) + lab_stage + x,
              [](const Case&) { return Said{}; });
  const study::Folder folder(bench.root / "out", "lab.toml");
  const calibrate::Runs runs(bench.lab, folder, "pmr", 1, [](const auto&) { return true; });
  CHECK(runs.reaches("x", 0));
  CHECK_FALSE(runs.reaches("x", 1));
}

TEST_CASE("A lab file that lies on another changes a box of it, which its source then disowns") {
  const auto file = std::filesystem::temp_directory_path() /
                    ("pmr-lab-over-" + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << "extends = \"" PMR_SOURCE_DIR "/cases/calibration/devices.toml\"\n"
                      << "[stages.lift.unknowns.lift]\nto = 30\n";
  const calibrate::Lab lab = calibrate::read_lab(file, {});
  std::filesystem::remove(file);
  REQUIRE(lab.stages.size() == 5);
  const calibrate::Parameter& lift = lab.stages[1].parameters[0];
  CHECK(lift.box.high == 30.0);
  CHECK(lift.box.low == 6.0);
  CHECK_THAT(lift.source, Contains("with values of the case"));
}
