#include <catch2/catch.hpp>
#include <filesystem>

#include "case/case.hpp"
#include "sim/schedule.hpp"

using namespace pmr;

namespace {
Case tiny() {
  return casefile::load_case(std::filesystem::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml");
}
}  // namespace

TEST_CASE("Intervals of the react phase meet every border and grow in between") {
  const Case c = tiny();
  const sim::Schedule schedule(c, 2e-5);
  State state;
  state.phase = Phase::react;
  state.time = state.settled_at = 0.08;
  std::vector<double> ends;
  std::size_t closings = 0, snapshots = 0;
  while (state.phase == Phase::react) {
    const sim::Interval interval = schedule.next(state);
    REQUIRE(interval.end > interval.begin);
    REQUIRE(interval.sub_steps == 0);
    closings += interval.closes_chamber ? 1 : 0;
    snapshots += interval.takes_snapshot ? 1 : 0;
    state.gas.closed = state.gas.closed || interval.closes_chamber;
    state.time = interval.end;
    ends.push_back(interval.end);
    schedule.move_on(state, 0.0);
  }
  for (const double border : {1.0, 5.0, 20.0})
    CHECK(std::count_if(ends.begin(), ends.end(),
                        [&](double t) { return std::abs(t - border) < 1e-9; }) == 1);
  CHECK(closings == 1);
  CHECK(snapshots == 3);
  CHECK(ends.size() < 200);
}

TEST_CASE("The mix phase ends at rest, held for its time, or at its deadline") {
  const Case c = tiny();
  const sim::Schedule schedule(c, 2e-5);
  State state;
  schedule.begin(state);
  REQUIRE(state.phase == Phase::mix);
  state.time = 0.05;
  CHECK_FALSE(schedule.move_on(state, 0.0));  // not looked for before 60 ms
  state.time = 0.061;
  CHECK_FALSE(schedule.move_on(state, 1e-3));  // at rest, not yet for 20 ms
  state.time = 0.07;
  CHECK_FALSE(schedule.move_on(state, 1e-2));  // moved again
  state.time = 0.08;
  CHECK(schedule.move_on(state, 1e-2));  // deadline
  CHECK(state.phase == Phase::react);
  CHECK(state.settled_at == 0.08);
}
