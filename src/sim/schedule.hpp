// What falls due next: the phases of a run, each a declared clock.
//   fill   particles settle in the furnace tubes on the closed valves       t < 0
//   mix    valves drop, streams mix, the bed settles: mechanics and heat    0 .. at rest
//   react  the bed is frozen; the network alone                             .. end
#pragma once
#include <cstdint>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

// [begin, end] and what falls due in it.
struct Interval {
  double begin, end;        // [s]; where the bed moves, the end is begin + sub_steps * dt
  std::uint64_t sub_steps;  // of the mechanics; 0: the bed is frozen
  bool heats;               // the network advances
  bool closes_chamber;      // the chamber is shut at `begin`
  bool takes_snapshot;      // the state at `end` is kept as a picture
  bool moves() const { return sub_steps > 0; }
};

class Schedule {
 public:
  Schedule(const Case& c, double time_step) : case_(c), time_step_(time_step) {}

  void begin(State& state) const;  // first phase and time of the case
  // Likewise for a bed read from elsewhere, at its own time: no fill, and no mix where its time is
  // over or the bed has been at rest long enough.
  void begin_with_bed(State& state, double rms_speed) const;
  Interval next(const State& state) const;
  // Rest, ends of phases: called after each interval. `is_over`: what ends the motion has come,
  // though nothing rests. True when a phase has ended.
  bool move_on(State& state, bool is_over, double rms_speed) const;
  double end() const;  // [s] last time the run can reach

 private:
  Interval moving(const State& state, double heat_interval, double phase_end) const;
  Interval frozen(const State& state) const;
  double next_picture(double t) const;
  double next_border(double t) const;

  const Case& case_;
  double time_step_;  // [s]
};

// True while heat and chemistry of the case are computed.
bool has_heat(const Case& c);

}  // namespace pmr::sim
