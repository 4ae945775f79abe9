#include "sim/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmr::sim {
namespace {

constexpr double fill_interval = 5.0e-3;  // [s] between looks at the rest of a filling tube
constexpr double infinity = std::numeric_limits<double>::infinity();

// Below this part of an interval two times count as one.
constexpr double same_time = 1e-9;  // [s]

Phase phase_after(const Case& c, Phase phase) {
  if (phase == Phase::fill && c.mix) return Phase::mix;
  if ((phase == Phase::fill || phase == Phase::mix) && c.react) return Phase::react;
  return Phase::done;
}

}  // namespace

bool has_heat(const Case& c) {
  return c.models.conduction || c.models.radiation || c.models.reaction;
}

void Schedule::begin(State& state) const {
  state.time = case_.fill ? -case_.fill->duration : 0.0;
  state.phase = case_.fill ? Phase::fill : phase_after(case_, Phase::fill);
  if (state.phase == Phase::react) state.settled_at = state.time;
}

void Schedule::begin_with_bed(State& state, double rms_speed) const {
  state.phase = case_.mix ? Phase::mix : phase_after(case_, Phase::mix);
  if (state.phase == Phase::react)
    state.settled_at = state.time;
  else
    move_on(state, false, rms_speed);
}

double Schedule::end() const {
  if (case_.react) return case_.react->end;
  return case_.mix ? case_.mix->duration : 0.0;
}

Interval Schedule::next(const State& state) const {
  if (state.phase == Phase::fill) {
    Interval interval = moving(state, fill_interval, 0.0);
    interval.heats = false;  // the tubes are at the furnace's temperature, and so is the charge
    return interval;
  }
  if (state.phase == Phase::mix)
    return moving(state, case_.mix->heat_interval, case_.mix->duration);
  return frozen(state);
}

// The first time after t at which a picture is wanted while the bed moves.
double Schedule::next_picture(double t) const {
  const double frame = std::max(case_.output.snapshot_interval, time_step_);
  const double now = t + 0.5 * time_step_;
  double next = (std::floor(now / frame) + 1.0) * frame;
  for (const double at : case_.output.snapshot_times)
    if (at > now) next = std::min(next, at);
  return next;
}

// The way to the next picture in equal parts, none longer than `length`.
Interval Schedule::moving(const State& state, double length, double phase_end) const {
  const double picture = next_picture(state.time), way = picture - state.time;
  const double parts = std::max(1.0, std::ceil(way / length - 1e-6));
  double target = std::min(state.time + way / parts, phase_end);
  for (const Surface& surface : case_.walls.surfaces)  // its place is looked at as it comes in
    if (surface.from > state.time + same_time) target = std::min(target, surface.from);
  const auto sub_steps = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::llround((target - state.time) / time_step_)));
  const double end = state.time + static_cast<double>(sub_steps) * time_step_;
  const bool snapshot = end + 0.5 * time_step_ >= picture;
  return {state.time, end, sub_steps, has_heat(case_), false, snapshot};
}

double Schedule::next_border(double t) const {
  double border = case_.react->end;
  const auto consider = [&](double at) {
    if (at > t + same_time) border = std::min(border, at);
  };
  if (case_.chamber) {
    consider(case_.chamber->closing);
    if (case_.chamber->pump) consider(case_.chamber->pump->start);
    if (case_.chamber->vent) consider(case_.chamber->vent->start);
  }
  for (const Surface& surface : case_.walls.surfaces) {
    consider(surface.from);
    consider(surface.until);
  }
  for (const double at : case_.output.snapshot_times) consider(at);
  return border;
}

Interval Schedule::frozen(const State& state) const {
  const ReactPhase& react = *case_.react;
  // Changes are fast after rest, after the chamber is closed, after the pump starts and
  // after the chamber is vented.
  double origin = state.settled_at;
  if (case_.chamber && state.time >= case_.chamber->closing)
    origin = std::max(origin, case_.chamber->closing);
  if (case_.chamber && case_.chamber->pump && state.time >= case_.chamber->pump->start)
    origin = std::max(origin, case_.chamber->pump->start);
  if (case_.chamber && case_.chamber->vent && state.time >= case_.chamber->vent->start - same_time)
    origin = std::max(origin, case_.chamber->vent->start);
  const double length = std::clamp(react.growth * (state.time - origin), react.first_interval,
                                   react.longest_interval);
  const double border = next_border(state.time);
  const double end = state.time + 1.5 * length >= border ? border : state.time + length;
  const auto& times = case_.output.snapshot_times;
  const bool snapshot = std::any_of(times.begin(), times.end(),
                                    [&](double at) { return std::abs(at - end) < same_time; }) ||
                        end >= react.end;
  const bool closes =
      case_.chamber && !state.gas.closed && state.time >= case_.chamber->closing - same_time;
  return {state.time, end, 0, has_heat(case_), closes, snapshot};
}

bool Schedule::move_on(State& state, bool is_over, double rms_speed) const {
  const Phase before = state.phase;
  if (before == Phase::react) {
    if (state.time >= case_.react->end - same_time) state.phase = Phase::done;
    return state.phase != before;
  }
  const bool filling = before == Phase::fill;
  const RestCriterion& rest = filling ? case_.fill->rest : case_.mix->rest;
  const double not_before = filling ? -infinity : case_.mix->not_before;
  if (rms_speed >= rest.rms_speed || state.time < not_before)
    state.rest_since = infinity;
  else
    state.rest_since = std::min(state.rest_since, state.time);
  const bool at_rest = state.time - state.rest_since >= rest.hold;
  const double deadline = filling ? 0.0 : case_.mix->duration;
  if (!at_rest && !is_over && state.time < deadline - 0.5 * time_step_) return false;

  state.phase = is_over ? phase_after(case_, Phase::mix) : phase_after(case_, before);
  state.rest_since = infinity;
  if (filling) state.time = 0.0;
  if (state.phase == Phase::react || (at_rest && !filling)) state.settled_at = state.time;
  return true;
}

}  // namespace pmr::sim
