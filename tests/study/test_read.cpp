#include <catch2/catch.hpp>
#include <set>

#include "helpers.hpp"
#include "study/plan.hpp"
#include "study/settings.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

TEST_CASE("All faults of a study file are told together, with place and nearest key") {
  const auto faults = faults_of(R"(replicates = 0
[variables.x]
vlaues = [1, 2]
[responses.y]
factor = "2"
)");
  std::string all;
  for (const Fault& fault : faults) all += to_string(fault) + "\n";
  INFO(all);
  CHECK(faults.size() == 5);
  CHECK_THAT(all, Contains("study.toml:4:") && Contains("wanted a whole number of at least 1"));
  CHECK_THAT(all, Contains("did you mean 'values'"));
  CHECK_THAT(all, Contains("responses.y.key: is missing"));
}

TEST_CASE("A variable has values, a range or levels, and a sampled one a range") {
  CHECK(faults_of(response + "[variables.x]\n").size() == 1);
  CHECK(faults_of(response + "[variables.x]\nvalues = [1]\nfrom = 0\nto = 1\ncount = 2\n").size() ==
        1);
  CHECK(faults_of(response + "[design]\nkind = \"sobol\"\nsamples = 4\n[variables.x]\n"
                             "values = [1]\n")
            .size() == 1);
  CHECK(faults_of(response + "[variables.x]\nfrom = -1\nto = 1\ncount = 3\nspacing = \"log\"\n")
            .size() == 1);
  CHECK(faults_of(response + "[variables.\"a b\"]\nvalues = [1]\n").size() == 1);
}

TEST_CASE("A trade-off names responses of the study") {
  CHECK_THAT(
      to_string(faults_of(response + "[variables.x]\nvalues = [1]\n[trade_off]\ngain = \"delta\"\n"
                                     "cost = \"dleta\"\n")
                    .at(0)),
      Contains("did you mean 'delta'"));
}

TEST_CASE("What is set on the command line is a constant of the study or a setting of the case") {
  const std::string text = response + "[constants]\nscale = 0.02\n[variables.x]\nvalues = [1]\n";
  const auto study = read(text, {"scale=0.1", "react.end=\"5 s\""});
  CHECK(study.constants.at("scale") == 0.1);
  CHECK(study.sets == std::vector<std::string>{"react.end=\"5 s\""});
  CHECK_THROWS_AS(read(text, {"scale=wide"}), CaseError);
}

TEST_CASE("A study lies on another: tables are merged, the case stays the base's") {
  const StudyFile base(response + "[variables.x]\nvalues = [1]\n[settings]\na = 1\nb = 2\n");
  const auto over = base.path().parent_path() / "over.toml";
  std::ofstream(over) << "extends = \"study.toml\"\ntitle = \"U\"\n[settings]\nb = 3\n";
  const auto study = study::read_study(over, {});
  CHECK(study.title == "U");
  CHECK(study.case_file.filename() == "tiny.toml");
  REQUIRE(study.settings.size() == 2);
  std::set<std::string> filled;
  for (const auto& setting : study.settings) filled.insert(study::filled(setting, {}));
  CHECK(filled == std::set<std::string>{"a=1", "b=3"});
  const auto upper = base.path().parent_path() / "upper.toml";
  std::ofstream(upper) << "extends = \"over.toml\"\ntitle = \"V\"\n";
  CHECK(study::read_study(upper, {}).settings.size() == 2);
  CHECK(study::read_study(upper, {}).title == "V");
}

TEST_CASE("Studies that extend each other in a circle are refused") {
  const StudyFile base(response + "[variables.x]\nvalues = [1]\n");
  const auto over = base.path().parent_path() / "over.toml";
  std::ofstream(over) << "extends = \"over.toml\"\n";
  CHECK_THROWS_WITH(study::read_study(over, {}), Contains("in a circle"));
}

TEST_CASE("A setting that is one expression is a number, in a list too") {
  const auto study = read(response + "[derived]\nz = \"y + 1\"\ny = \"2 * x\"\n[variables.x]\n" +
                          "values = [1]\n[settings]\n\"a.b\" = [\"${x}\", \"${x / 2} mm\"]\n");
  CHECK(study::filled(study.settings[0], {{"x", 3.0}}) == "a.b=[3, \"1.5 mm\"]");
  REQUIRE(study.derived.size() == 2);
  CHECK(study.derived[0].first == "z");  // may stand before what it names
}

TEST_CASE("Expressions stand in braces, and are written with all their digits") {
  CHECK(study::filled("a = \"${1000 * scale * ratio} g\"", {{"scale", 0.02}, {"ratio", 2.5}}) ==
        "a = \"50 g\"");
  CHECK(study::filled("${x} and ${x / 3}", {{"x", 1.0}}) == "1 and 0.3333333333333333");
  CHECK_THROWS_AS(study::filled("${x / 0}", {{"x", 1.0}}), std::invalid_argument);
  CHECK_THROWS_AS(study::filled("${x", {{"x", 1.0}}), std::invalid_argument);
  CHECK_THROWS_AS(study::filled("${y}", {{"x", 1.0}}), std::invalid_argument);
}

TEST_CASE("Correlated variables come from a calibration's file, or from the study itself") {
  const std::string group = R"(names = ["mu", "mu_r"]
keys = ['contacts."SrFeO3|SrFeO3".friction', 'contacts."SrFeO3|SrFeO3".rolling_friction']
units = ["", ""]
values = [0.3, 0.1]
deviations = [0.02, 0.05]
low = [0.1, 0]
high = [0.8, 0.5]
correlation = [[1, -0.8], [-0.8, 1]]
)";
  const std::string sampled = response + "[design]\nkind = \"sobol\"\nsamples = 200\n";
  const auto study = read(sampled + "[correlated.contacts]\n" + group);
  REQUIRE(study.variables.size() == 2);
  CHECK(study.variables[1].low == 0.0);
  double covariance = 0.0;
  std::size_t below = 0;
  for (const auto& point : study::design_points(study)) {
    covariance += (point[0] - 0.3) * (point[1] - 0.1) / 200.0;
    below += point[1] < 0.0;
  }
  CHECK(below == 0);  // cut at the box: 2 % would lie below
  CHECK(covariance == Approx(-0.0008).epsilon(0.1));
  CHECK(study::make_plan(study).runs.at(0).fault.empty());

  const StudyFile file(sampled + "[correlated.contacts]\nfile = \"found.toml\"\n");
  const auto found = file.path().parent_path() / "found.toml";
  std::ofstream(found) << "[calibration]\nlab = \"L\"\nversion = \"V\"\n" << group;
  CHECK(study::read_study(file.path(), {}).correlated.at(0).covariance[0][1] == Approx(-0.0008));
  CHECK(faults_of(response + "[correlated.c]\n" + group).size() == 1);  // a grid
  CHECK(faults_of(sampled + "[correlated.c]\nfile = \"nowhere.toml\"\n").size() == 1);
  std::string crooked = group;
  crooked.replace(crooked.find("[1, -0.8]"), 9, "[1, -1.8]");
  CHECK_THAT(to_string(faults_of(sampled + "[correlated.c]\n" + crooked).at(0)),
             Contains("symmetric and positive"));
}
