// The shipped studies plan at their own scale; what they ask of the summaries is checked when they
// run.
#include <catch2/catch.hpp>
#include <filesystem>

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
