#include "sim/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/ray_count.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/constants.hpp"
#include "sim/schedule.hpp"

namespace pmr::sim {
namespace {

// What was measured on the demonstrators (docs/benchmarks.md), as ratios, so that they hold on
// other machines.
constexpr double falls_in_fill = 1.3;    // [1] free falls of the charge's height until it rests
constexpr double falls_in_mix = 2.5;     // [1] of the rig's height, from the last event
constexpr double over_lattice = 2.2;     // [1] a particle-step with lists and walls
constexpr double network_moving = 3.5;   // [1] an interval of the network over the lattice's ...
constexpr double network_at_rest = 3.0;  // [1] ... with walls, gas, more rays and longer rows
constexpr double links_moving = 2.0;     // [1] a look at gaps and conductances likewise
constexpr double links_at_rest = 1.0;    // [1] conductances alone
constexpr double packed = 0.45;          // [1] solid fraction of a charge as it is filled in
constexpr double stored = 3e-6;          // [s] to pack and write a particle in a snapshot
constexpr double stored_bytes = 60.0;    // [B] of it

double particles_of(const Case& c) {
  double count = static_cast<double>(c.particles.size());
  for (const Species& s : c.species) count += static_cast<double>(s.count);
  return count;
}

// Lowest and highest point along gravity that particles are seen at [m].
struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double height) {
    low = std::min(low, height);
    high = std::max(high, height);
  }
  double height() const { return std::max(0.0, high - low); }
};

Vec3 upwards(const Case& c) {
  const double g = c.gravity.norm();
  return g > 0.0 ? Vec3(-c.gravity / g) : Vec3(0, 0, 1);
}

double fall_time(const Case& c, double height) {
  const double g = c.gravity.norm();
  return g > 0.0 ? std::sqrt(2.0 * height / g) : std::numeric_limits<double>::infinity();
}

// Height of a charge as it lies in its region [m].
double charge_height(const Species& s, const CylinderRegion& r) {
  const double area = pi * (r.radius * r.radius - r.inner_radius * r.inner_radius);
  return std::min(r.height, solid_volume(s) / packed / area);
}
double charge_height(const Species& s, const BoxRegion& r) {
  const Vec3 size = r.high - r.low;
  return std::min(size.z(), solid_volume(s) / packed / (size.x() * size.y()));
}

Vec3 base_of(const CylinderRegion& r) { return r.base; }
Vec3 base_of(const BoxRegion& r) { return r.low; }

// Of the tallest charge [m].
double tallest_charge(const Case& c) {
  double height = 0.0;
  for (const Species& s : c.species)
    if (s.region)
      height = std::max(height,
                        std::visit([&](const auto& r) { return charge_height(s, r); }, *s.region));
  return height;
}

// Where a wall's lowest points may be: those that a charge may come down to.
std::vector<Vec3> low_points(const Plane& plane, const Vec3& up) {
  if (up.dot(plane.normal) > 0.5) return {plane.point};
  return {};  // a side or a lid
}
std::vector<Vec3> low_points(const Revolved& turned, const Vec3&) {
  return {turned.origin + turned.z0 * turned.axis, turned.origin + turned.z1 * turned.axis};
}
std::vector<Vec3> low_points(const Facet& facet, const Vec3&) {
  std::vector<Vec3> corners;
  for (const auto& triangle : facet.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

void add_walls(const Case& c, const Vec3& up, Reach& reach) {
  for (const Surface& surface : c.walls.surfaces) {
    if (!surface.holds_particles) continue;
    const auto points = std::visit([&](const auto& s) { return low_points(s, up); }, surface.shape);
    for (const Vec3& point : points) reach.low = std::min(reach.low, up.dot(point));
  }
}

// From the top of the charge to the lowest wall [m].
double drop_height(const Case& c) {
  const Vec3 up = upwards(c);
  Reach reach;
  for (const ExplicitParticle& p : c.particles) reach.add(up.dot(p.position));
  for (const Species& s : c.species) {
    if (s.region)
      std::visit(
          [&](const auto& r) {
            reach.add(up.dot(base_of(r)));
            reach.add(up.dot(base_of(r)) + charge_height(s, r));
          },
          *s.region);
    if (s.pour) std::visit([&](const auto& r) { reach.add(up.dot(base_of(r))); }, s.pour->region);
  }
  add_walls(c, up, reach);
  return std::isfinite(reach.height()) ? reach.height() : 0.0;
}

// The last time at which a wall begins or ends to move, or the last particle is poured in [s];
// infinite where one never stops.
double last_event(const Case& c) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double last = 0.0;
  for (const Body& body : c.walls.bodies) {
    if (const auto* fall = std::get_if<Fall>(&body.motion)) last = std::max(last, fall->release);
    if (const auto* way = std::get_if<Translate>(&body.motion)) last = std::max(last, way->finish);
    if (const auto* turn = std::get_if<Rotate>(&body.motion)) last = std::max(last, turn->finish);
    if (std::holds_alternative<Oscillate>(body.motion)) last = never;
  }
  for (const Species& s : c.species) {
    if (!s.pour) continue;
    const double rate = std::isfinite(s.pour->particle_rate)
                            ? s.pour->particle_rate / static_cast<double>(s.count)
                            : s.pour->mass_rate / s.requested_mass;  // [1/s] of the whole
    last = std::max(last, std::max(0.0, s.pour->begin) + 1.0 / rate);
  }
  return last;
}

// How long phases will last [s].
double fill_length(const Case& c) {
  if (!c.fill) return 0.0;
  const double falling = c.mix ? falls_in_fill * fall_time(c, tallest_charge(c))  // on a valve
                               : falls_in_mix * fall_time(c, drop_height(c));
  return std::min(c.fill->duration, falling + c.fill->rest.hold);
}
double mix_length(const Case& c) {
  if (!c.mix) return 0.0;
  const double rest = last_event(c) + falls_in_mix * fall_time(c, drop_height(c));
  return std::min(c.mix->duration, std::max(rest, c.mix->not_before) + c.mix->rest.hold);
}

// Where the react phase stands, and what is left of it.
struct ReactStart {
  double time, settled_at;    // [s]
  bool is_closed, is_traced;  // the chamber; the bed as it lies
};
constexpr double most_intervals = 1e5;  // [1] that are counted one by one
struct ReactWork {
  double intervals = 0.0, frames = 0.0, tracings = 0.0;  // [1]
};
ReactWork react_work(const Case& c, const ReactStart& start) {
  ReactWork work;
  const Schedule schedule(c, physics::time_step(c).step);
  State at;
  at.phase = Phase::react;
  at.time = start.time;
  at.settled_at = start.settled_at;
  at.gas.closed = start.is_closed;
  work.tracings = start.is_traced ? 0.0 : 1.0;
  while (at.phase == Phase::react && work.intervals < most_intervals) {
    const Interval interval = schedule.next(at);
    ++work.intervals;
    work.frames += interval.takes_snapshot ? 1.0 : 0.0;
    for (const Surface& surface : c.walls.surfaces)
      if (is_present(surface, interval.begin) != is_present(surface, interval.end)) {
        ++work.tracings;
        break;
      }
    at.time = interval.end;
    schedule.move_on(at, false, 0.0);
  }
  if (at.phase == Phase::react)  // and so on
    work.intervals *= (c.react->end - start.time) / (at.time - start.time);
  return work;
}

class Model {
 public:
  Model(const Case& c, const UnitCosts& costs)
      : c_(c), costs_(costs), particles_(particles_of(c)), step_(physics::time_step(c).step) {}

  StageTimes moving(double length, bool has_heat) const {  // [s] of simulated time
    StageTimes times;
    times.mechanics = over_lattice * costs_.particle_step * particles_ * length / step_;
    times.output = stored * particles_ * length / c_.output.snapshot_interval;
    if (!has_heat || !c_.mix) return times;
    const double intervals = length / c_.mix->heat_interval;
    times.links = links_moving * costs_.links * particles_ * intervals;
    times.network = network_moving * costs_.network * particles_ * intervals;
    if (c_.models.radiation)
      times.tracing = tracing(c_.models.radiation->rays_moving) * length /
                      std::max(c_.models.radiation->retrace_interval, c_.mix->heat_interval);
    return times;
  }

  StageTimes react(const ReactStart& start) const {
    if (!c_.react || !has_heat(c_)) return {};
    const ReactWork work = react_work(c_, start);
    StageTimes times;
    times.links = links_at_rest * costs_.links * particles_ * work.intervals;
    times.network = network_at_rest * costs_.network * particles_ * work.intervals;
    times.output = stored * particles_ * work.frames;
    if (c_.models.radiation)
      times.tracing = tracing(c_.models.radiation->rays_settled) * work.tracings;
    return times;
  }

 private:
  double tracing(double rays) const {  // [s] of one
    const bool is_traced = c_.models.radiation->law == RadiationLaw::traced;
    return is_traced ? costs_.ray * coupling::count_rays(c_, rays).sent : 0.0;
  }

  const Case& c_;
  const UnitCosts& costs_;
  double particles_, step_;  // [1], [s]
};

// A phase that lasts longer than was foreseen needs a tenth more.
double left_of(double length, double passed) {
  return std::max(length - passed, 0.1 * std::min(passed, length));
}

}  // namespace

Forecast forecast_rest(const Case& c, const UnitCosts& costs, const State& state) {
  const Model model(c, costs);
  Forecast f;
  double fill = 0.0, mix = 0.0;  // [s] left
  if (state.phase == Phase::fill) fill = left_of(fill_length(c), state.time + c.fill->duration);
  if (state.phase == Phase::fill) mix = mix_length(c);
  if (state.phase == Phase::mix) mix = left_of(mix_length(c), state.time);
  f.steps = (fill + mix) / physics::time_step(c).step;
  f.fill = model.moving(fill, false);
  f.mix = model.moving(mix, has_heat(c));
  const bool is_at_rest = state.phase == Phase::react;
  const double settled = is_at_rest ? state.settled_at : mix_length(c);
  if (state.phase != Phase::done)
    f.react = model.react({is_at_rest ? state.time : settled, settled, state.gas.closed,
                           is_at_rest && std::isfinite(state.exchange.traced_at)});
  f.bytes = stored_bytes / stored * (f.fill.output + f.mix.output + f.react.output);
  return f;
}

Forecast forecast(const Case& c, const UnitCosts& costs) {
  State opening;
  Schedule(c, physics::time_step(c).step).begin(opening);
  // A bed that lies moves again where walls never come to rest alone, or nothing else is asked for.
  if (!c.bed.empty()) {
    const bool moves = c.mix && (!c.react || !std::isfinite(last_event(c)));
    opening.phase = moves ? Phase::mix : c.react ? Phase::react : Phase::done;
    opening.time = opening.settled_at = moves ? 0.0 : mix_length(c);
  }
  return forecast_rest(c, costs, opening);
}

}  // namespace pmr::sim
