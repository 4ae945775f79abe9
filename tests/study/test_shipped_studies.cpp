// The shipped studies plan at their own scale; what they ask of the summaries is checked when they
// run.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>

#include "case/case.hpp"
#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"
#include "study/plan.hpp"

using namespace pmr;

TEST_CASE("Every shipped study makes a sound case at each of its points") {
  std::size_t seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PMR_SOURCE_DIR "/cases/studies")) {
    if (!entry.is_regular_file()) continue;  // base/: what they lie on
    INFO(entry.path());
    const auto study = study::read_study(entry.path(), {});
    const auto plan = study::make_plan(study);
    for (const auto& run : plan.runs) {
      INFO(run.name << ": " << run.fault);
      CHECK(run.fault.empty());
    }
    CHECK(study.teaches.size() > 100);
    ++seen;
  }
  CHECK(seen >= 6);
}

// What scripts/fit-equilibrium prints of the covariance: delta in air at 900 degC 0.3954 +- 0.0082,
// its swing from (700 degC, 0.21 bar) to (774, 0.01) 0.1004 +- 0.0039, from (400, 0.21) to (457,
// 0.01) 0.0625 +- 0.0018; the first direction moves the swings by the correlation with the level.
TEST_CASE("The directions of the equilibrium's covariance move what they are meant to move") {
  const auto study = study::read_study(PMR_SOURCE_DIR "/cases/studies/uncertainty.toml", {});
  const auto plan = study::make_plan(study);
  REQUIRE(plan.runs.size() == 40);
  int seen = 0;
  for (const auto& run : plan.runs) {
    std::map<std::string, double> z;
    for (std::size_t v = 0; v < study.variables.size(); ++v)
      z[study.variables[v].name] = run.values[v];
    const Case made = casefile::load_case_text(run.case_text, "case");
    const Material* granule = nullptr;
    for (const Material& m : made.materials.list)
      if (m.redox) granule = &m;
    REQUIRE(granule != nullptr);
    const auto delta = [&](double celsius, double pressure) {
      return chemistry::equilibrium_delta(granule->redox->equilibrium, celsius + zero_celsius,
                                          pressure);
    };
    const double level = z.at("law_level"), hot = z.at("law_hot"), cool = z.at("law_cool");
    if (std::max({std::abs(level), std::abs(hot), std::abs(cool)}) > 1.5) continue;  // bent there
    ++seen;
    INFO(level << " " << hot << " " << cool);
    CHECK(delta(900.0, 0.21 * standard_atmosphere) == Approx(0.3954 + 0.0082 * level).margin(1e-3));
    CHECK(delta(774.0, 0.01 * bar) - delta(700.0, 0.21 * bar) ==
          Approx(0.1004 + 0.0039 * hot - 0.0002 * level).margin(1e-3));
    CHECK(delta(457.0, 0.01 * bar) - delta(400.0, 0.21 * bar) ==
          Approx(0.0625 + 0.0018 * cool - 0.00043 * hot + 0.00016 * level).margin(1e-3));
  }
  CHECK(seen > 20);
}
