#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "case/case.hpp"
#include "sim/schedule.hpp"

using namespace pmr;

namespace {
Case tiny_schedule() {
  return casefile::load_case(std::filesystem::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml");
}
}  // namespace

TEST_CASE("Intervals of the react phase meet every border and grow in between") {
  const Case c = tiny_schedule();
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
    schedule.move_on(state, false, 0.0);
  }
  for (const double border : {1.0, 5.0, 20.0})
    CHECK(std::count_if(ends.begin(), ends.end(),
                        [&](double t) { return std::abs(t - border) < 1e-9; }) == 1);
  CHECK(closings == 1);
  CHECK(snapshots == 3);
  CHECK(ends.size() < 200);
}

TEST_CASE("Pictures of a moving bed come when they are asked for, whatever the heat's interval") {
  const double dt = 1.3e-5;  // [s] divides nothing here
  Case c = tiny_schedule();
  c.mix->duration = 1.0;
  c.output.snapshot_times = {0.033, 5.0};
  for (const double frame : {0.005, 0.05, 0.3}) {
    c.output.snapshot_interval = frame;
    std::vector<double> wanted{0.033};
    for (int k = 1; k * frame < 0.9999; ++k) wanted.push_back(k * frame);
    std::sort(wanted.begin(), wanted.end());
    const sim::Schedule schedule(c, dt);
    State state;
    schedule.begin(state);
    std::vector<double> taken;
    while (state.time < 0.9999 - 0.5 * dt) {
      const sim::Interval interval = schedule.next(state);
      CHECK(interval.end - interval.begin < c.mix->heat_interval + dt);
      state.time = interval.end;
      if (interval.takes_snapshot && interval.end < 0.9999) taken.push_back(interval.end);
    }
    REQUIRE(taken.size() == wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k)
      CHECK(std::abs(taken[k] - wanted[k]) < 0.51 * dt);
  }
}

TEST_CASE("Pictures at multiples of the heat's interval leave the intervals as they are") {
  Case c = tiny_schedule();
  c.output.snapshot_interval = 0.04;
  c.output.snapshot_times = {};
  const sim::Schedule schedule(c, 2e-5);
  State state;
  schedule.begin(state);
  for (const bool picture : {false, true, false, true}) {
    const sim::Interval interval = schedule.next(state);
    CHECK(interval.sub_steps == 1000);
    CHECK(interval.takes_snapshot == picture);
    state.time = interval.end;
  }
}

TEST_CASE("The mix phase ends at rest, held for its time, or at its deadline") {
  const Case c = tiny_schedule();
  const sim::Schedule schedule(c, 2e-5);
  State state;
  schedule.begin(state);
  REQUIRE(state.phase == Phase::mix);
  state.time = 0.05;
  CHECK_FALSE(schedule.move_on(state, false, 0.0));  // not looked for before 60 ms
  state.time = 0.061;
  CHECK_FALSE(schedule.move_on(state, false, 1e-3));  // at rest, not yet for 20 ms
  state.time = 0.07;
  CHECK_FALSE(schedule.move_on(state, false, 1e-2));  // moved again
  state.time = 0.08;
  CHECK(schedule.move_on(state, false, 1e-2));  // deadline
  CHECK(state.phase == Phase::react);
  CHECK(state.settled_at == 0.08);
}
