#include "sim/forecast.hpp"

#include "coupling/ray_count.hpp"
#include "physics/time_step.hpp"
#include "sim/schedule.hpp"

namespace pmr::sim {
namespace {

// Measured on one core of a 2023 server.
constexpr double particle_steps_per_second = 6e6;    // [1/s]
constexpr double react_seconds_per_particle = 0.01;  // [s] of 30 minutes of reaction
constexpr double rays_per_second = 3e6;              // [1/s]
constexpr double bytes_per_particle = 60.0;          // [B] of a snapshot

// Tracings while the bed moves, at most, and one at rest [s].
struct Tracing {
  double moving = 0.0, reacting = 0.0;
};
Tracing tracing(const Case& c, bool moves) {
  if (!c.models.radiation || c.models.radiation->law != RadiationLaw::traced) return {};
  const RadiationModel& model = *c.models.radiation;
  const double tracings = moves && c.mix ? c.mix->duration / model.retrace_interval : 0.0;
  return {tracings * coupling::count_rays(c, model.rays_moving).sent / rays_per_second,
          coupling::count_rays(c, model.rays_settled).sent / rays_per_second};
}

}  // namespace

Forecast forecast(const Case& c) {
  double particles = 0.0;
  for (const Species& s : c.species) particles += static_cast<double>(s.count);
  const bool moves = c.bed.empty();
  const double moving =
      (moves && c.fill ? c.fill->duration : 0.0) + (moves && c.mix ? c.mix->duration : 0.0);
  const double steps = moving / physics::time_step(c).step;
  const double frames =
      moving / c.output.snapshot_interval + static_cast<double>(c.output.snapshot_times.size());
  const bool reacts = c.react && has_heat(c);
  const Tracing rays = tracing(c, moves);
  return {steps, steps * particles / particle_steps_per_second + rays.moving,
          reacts ? react_seconds_per_particle * particles + rays.reacting : 0.0,
          frames * particles * bytes_per_particle};
}

}  // namespace pmr::sim
