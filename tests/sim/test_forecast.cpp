// What is foreseen of a run, held against what the run does; costs of one second a unit, so that
// work is counted and no clock is read.
#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <vector>

#include "case/case.hpp"
#include "folder.hpp"
#include "sim/forecast.hpp"
#include "sim/simulation.hpp"

using namespace pmr;

namespace {

constexpr sim::UnitCosts unit{1.0, 1.0, 1.0, 1.0};

struct Run {
  std::vector<double> left;                   // [s] foreseen after each interval
  double react_intervals = 0.0, steps = 0.0;  // [1]
};

Run carry_out(const Case& c) {
  Run run;
  const test::Folder folder("forecast");
  sim::Simulation simulation(c, folder.path);
  const std::atomic<bool> never{false};
  Phase phase = simulation.state().phase;
  simulation.run(never, [&](const sim::Simulation& now) {
    run.react_intervals += phase == Phase::react ? 1.0 : 0.0;
    phase = now.state().phase;
    run.left.push_back(sim::forecast_rest(c, unit, now.state()).total());
  });
  run.steps = static_cast<double>(simulation.state().step);
  return run;
}

Case tiny_case() {
  return casefile::load_case(std::filesystem::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml");
}

}  // namespace

TEST_CASE("A forecast knows the intervals of the bed at rest, and what is left never grows") {
  const Case c = tiny_case();
  const Run run = carry_out(c);
  const sim::Forecast whole = sim::forecast(c, unit);
  const sim::Forecast one = sim::forecast_rest(c, unit, [&] {
    State last;
    last.phase = Phase::react;
    last.time = c.react->end - 1e-6;
    last.settled_at = 0.08;
    return last;
  }());
  CHECK(whole.react.network / one.react.network == Approx(run.react_intervals).epsilon(0.05));
  CHECK(whole.steps == Approx(run.steps).epsilon(0.05));
  REQUIRE(run.left.size() > 50);
  for (std::size_t k = 1; k < run.left.size(); ++k) CHECK(run.left[k] <= run.left[k - 1] * 1.001);
  CHECK(run.left.back() == 0.0);
}

TEST_CASE("A bed comes to rest when it was foreseen, within a factor of 1.5") {
  const Case c = casefile::load_case(std::filesystem::path(PMR_SOURCE_DIR) / "cases/settling.toml");
  const double foreseen = sim::forecast(c, unit).steps, done = carry_out(c).steps;
  CHECK(foreseen < 1.5 * done);
  CHECK(foreseen > done / 1.5);
}

TEST_CASE("Costs of every stage are measured for a case that has them all") {
  const sim::UnitCosts costs = sim::measure_costs(tiny_case());
  for (const double cost : {costs.particle_step, costs.ray, costs.links, costs.network}) {
    CHECK(cost > 1e-10);
    CHECK(cost < 1e-2);
  }
}
