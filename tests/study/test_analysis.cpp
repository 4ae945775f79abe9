#include <catch2/catch.hpp>
#include <cmath>

#include "study/analysis.hpp"

using namespace pmr::study;

TEST_CASE("The best designs are those that no other beats in gain and cost") {
  Results results;
  // gain, cost: the second is beaten by the first, the last has no figure
  for (const auto& pair : std::vector<std::vector<double>>{
           {2.0, 1.0}, {1.0, 1.0}, {3.0, 2.0}, {3.0, 3.0}, {0.5, 0.5}, {std::nan(""), 0.1}})
    results.rows.push_back({"", "completed", "", pair, {}});
  CHECK(pareto_front(results, 0, 1) == std::vector<std::size_t>{0, 2, 4});
}

TEST_CASE("Runs are grouped by the levels of what is no number, failed ones left out") {
  Study study;
  study.variables.resize(2);
  study.variables[0].name = "ratio";
  study.variables[1].levels = {{"hot", {}}, {"cold", {}}};
  Plan plan;
  Results results;
  for (const double ratio : {1.0, 2.0})
    for (const double level : {0.0, 1.0}) {
      PlannedRun run;
      run.values = {ratio, level};
      plan.runs.push_back(run);
      results.rows.push_back({"", ratio + level == 3.0 ? "failed" : "completed", "", {ratio}, {}});
    }
  CHECK(numeric_variables(study, plan) == std::vector<std::size_t>{0});
  const auto groups = groups_of(study, plan, results);
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].name == "hot");
  CHECK(groups[0].rows == std::vector<std::size_t>{0, 2});
  CHECK(groups[1].rows == std::vector<std::size_t>{1});
}
