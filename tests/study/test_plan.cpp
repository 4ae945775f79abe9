#include <catch2/catch.hpp>
#include <set>

#include "case/case.hpp"
#include "helpers.hpp"
#include "study/folder.hpp"
#include "study/results.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

TEST_CASE("A grid holds all combinations, replicates of a point together") {
  const auto plan = study::make_plan(read("replicates = 2\n" + response + R"(
[variables.bead]
key = "species.Al2O3.temperature"
unit = "degC"
values = [900, 1100]
[variables.pressure]
key = "chamber.pressure"
unit = "Pa"
from = 1000
to = 100000
count = 3
spacing = "log"
)"));
  REQUIRE(plan.runs.size() == 12);
  CHECK(plan.runs[0].values == std::vector<double>{900, 1000});
  CHECK(plan.runs[1].values == plan.runs[0].values);
  CHECK(plan.runs[2].values[1] == Approx(1e4).epsilon(1e-12));
  CHECK(plan.runs[0].name == "bead=900-degC_pressure=1000-Pa_seed=1");
  CHECK(plan.mixings.size() == 2);  // one for each seed: temperatures move no particle
}

TEST_CASE("Runs share a mixing if and only if their particles move alike") {
  const auto mixings = [](const std::string& variable) {
    return study::make_plan(read(response + "[variables.x]\n" + variable)).mixings.size();
  };
  CHECK(mixings("key = \"species.SrFeO3.temperature\"\nunit = \"degC\"\nvalues = [300, 700]") == 1);
  CHECK(mixings("key = \"models.conduction.gap_reach\"\nvalues = [0.3, 0.5]") == 1);
  CHECK(mixings("key = \"materials.SrFeO3.emissivity\"\nvalues = [0.8, 0.9]") == 1);
  CHECK(mixings("key = \"species.SrFeO3.diameter\"\nunit = \"mm\"\nvalues = [1.4, 1.5]") == 2);
  CHECK(mixings("key = \"species.SrFeO3.count\"\nvalues = [100, 120]") == 2);
  CHECK(mixings("key = \"materials.SrFeO3.density\"\nunit = \"kg/m3\"\nvalues = [3e3, 4e3]") == 2);
  CHECK(mixings("key = \"mix.not_before\"\nunit = \"ms\"\nvalues = [50, 60]") == 2);
  CHECK(mixings("key = \"chamber.closing\"\nunit = \"s\"\nvalues = [0.5, 1]") == 2);
}

TEST_CASE("A run from a bed at hand is forecast with the bed's particles") {
  const std::string one = "[variables.x]\nkey = \"chamber.closing\"\nunit = \"s\"\nvalues = [1]\n";
  const auto bed = std::filesystem::temp_directory_path() /
                   ("pmr-study-bed-" + std::to_string(::getpid()) + ".dump");
  std::ofstream(bed) << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n"
                        "0 1\n0 1\n0 1\nITEM: ATOMS id type radius x y z vx vy vz\n"
                        "1 1 0.0015 0 0 0.0015 0 0 0\n2 2 0.0008 0.003 0 0.0009 0 0 0\n";
  const auto plan =
      study::make_plan(read(response + one + "[settings]\nbed = \"" + bed.string() + "\"\n"));
  std::filesystem::remove(bed);
  REQUIRE(plan.runs.size() == 1);
  INFO(plan.runs[0].fault);
  CHECK(plan.mixings.empty());
  CHECK(plan.runs[0].seconds > 0.0);
}

TEST_CASE("Settings follow the variables and the constants through their expressions") {
  const auto study = read(response +
                              "[settings]\n\"species.Al2O3.count\" = \"${round * 10 + "
                              "2}\"\n[constants]\nround = 1\n[variables.x]\nvalues = [1, 2]\n",
                          {"round=3"});
  const auto plan = study::make_plan(study);
  REQUIRE(plan.runs.size() == 2);
  CHECK(casefile::load_case_text(plan.runs[0].case_text, "case").species[0].count == 32);
}

TEST_CASE("Levels set what belongs together") {
  const auto plan =
      study::make_plan(read(response + R"(
[variables.pair]
levels = [
  {name = "1100 / 700", settings = {"species.Al2O3.temperature" = "1100 degC",)"
                                       R"( "species.SrFeO3.temperature" = "700 degC"}},
  {name = "400 / 200", settings = {"species.Al2O3.temperature" = "400 degC",)"
                                       R"( "species.SrFeO3.temperature" = "200 degC"}},
]
)"));
  REQUIRE(plan.runs.size() == 2);
  const Case cold = casefile::load_case_text(plan.runs[1].case_text, "case");
  CHECK(cold.species[0].initial_temperature == Approx(673.15));
  CHECK(cold.species[1].initial_temperature == Approx(473.15));
  CHECK(plan.runs[1].name == "pair=400-200");
}

TEST_CASE("A point whose case is wrong is told at that point alone") {
  const auto plan = study::make_plan(
      read(response + "[variables.x]\nkey = \"species.SrFeO3.diameter\"\nunit = \"mm\"\n"
                      "values = [1.4, -1]\n"));
  CHECK(plan.runs[0].fault.empty());
  CHECK_THAT(plan.runs[1].fault, Contains("species.SrFeO3.diameter") && Contains("out of range"));
}

TEST_CASE("A setting that is wrong at all points is an error of the study") {
  const auto study = read("[settings]\n\"chamber.presure\" = \"1 bar\"\n" + response +
                          "[variables.x]\nvalues = [1, 2]\n");
  CHECK_THROWS_WITH(study::make_plan(study), Contains("did you mean 'pressure'"));
  const auto unknown =
      read("[settings]\nseed = \"${y}\"\n" + response + "[variables.x]\nvalues = [1, 2]\n");
  CHECK_THROWS_AS(study::make_plan(unknown), CaseError);
}

TEST_CASE("A sampled design is the same on every call and stays in its box") {
  const std::string text = response +
                           "[design]\nkind = \"latin-hypercube\"\nsamples = 8\n[variables.bead]\n"
                           "key = \"species.Al2O3.temperature\"\nunit = \"degC\"\nfrom = 900\n"
                           "to = 1100\n[variables.factor]\nfrom = 0.1\nto = 1\nspacing = \"log\"\n";
  const auto first = study::design_points(read(text)), again = study::design_points(read(text));
  CHECK(first == again);
  REQUIRE(first.size() == 8);
  std::set<int> strata;
  for (const auto& point : first) {
    CHECK((point[0] >= 900 && point[0] <= 1100 && point[1] >= 0.1 && point[1] <= 1));
    strata.insert(static_cast<int>((point[0] - 900) / 25));
  }
  CHECK(strata.size() == 8);  // each eighth of the range once
}

TEST_CASE("A completed run that was killed before its report stood gets it, and no more") {
  const StudyFile file(response);
  const auto root = file.path().parent_path() / "out";
  study::Plan plan;
  plan.runs.push_back({"a", {}, {}, "text", "", {}, 5.0});
  const study::Folder folder(root);
  std::filesystem::create_directories(folder.run(plan.runs[0]));
  std::ofstream(folder.run(plan.runs[0]) / "summary.json") << R"({"status": "completed"})";
  const auto jobs = folder.jobs(plan, "pmr", 1);
  REQUIRE(jobs.size() == 1);
  CHECK(jobs[0].command ==
        std::vector<std::string>{"pmr", "report", folder.run(plan.runs[0]).string()});
  CHECK(jobs[0].seconds == 0.0);
  std::ofstream(folder.run(plan.runs[0]) / "report.html") << "<html>";
  CHECK(folder.jobs(plan, "pmr", 1).empty());
}

TEST_CASE("A run of another case than was asked for goes with what it said") {
  const StudyFile file(response);
  study::Plan plan;
  plan.runs.push_back({"a", {}, {}, "text", "", {}, 5.0});
  const study::Folder folder(file.path().parent_path() / "out");
  const auto lock = folder.prepare("asked for");
  folder.write_cases(plan);
  std::filesystem::create_directories(folder.run(plan.runs[0]));
  std::ofstream(folder.run(plan.runs[0]) / "summary.json") << R"({"status": "completed"})";
  std::ofstream(folder.root() / "logs/a.log") << "report   out/a/report.html";
  const auto row = [&] { return study::row_of({}, plan, plan.runs[0], folder); };
  folder.write_cases(plan);
  CHECK(row().status == "completed");
  plan.runs[0].case_text = "another";
  folder.write_cases(plan);
  CHECK(row().status == "missing");  // was "failed", for what its predecessor had said
  CHECK_FALSE(std::filesystem::exists(folder.run(plan.runs[0])));
}
