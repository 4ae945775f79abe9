#include "physics/mechanics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "physics/neighbours.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

// Particles of one task of the cheap passes over all particles.
constexpr std::size_t kick_block = 2048;
constexpr double steps_of_a_list = 20.0;  // [1] a list should last while particles are fast
constexpr double thickest_skin = 5.0;     // [1] times the case's skin

template <class Body>
void timed(double& stage, const Body& body) {
  const Stopwatch watch;
  body();
  stage += watch.seconds();
}

template <class T>
void keep(std::vector<T>& list, const std::vector<std::uint32_t>& places) {
  std::vector<T> kept;
  kept.reserve(places.size());
  for (const std::uint32_t i : places) kept.push_back(list[i]);
  list = std::move(kept);
}

void keep(Particles& particles, const std::vector<std::uint32_t>& places) {
  for_each_field(particles, [&](const char*, const char*, auto& field) { keep(field, places); });
}

void reorder(State& state, const std::vector<std::uint32_t>& order) {
  keep(state.particles, order);
  state.pair_contacts = reordered(state.pair_contacts, order);
  state.wall_contacts = reordered(state.wall_contacts, order);
}

std::string text(const Vec3& v) {
  return "(" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " + std::to_string(v[2]) +
         ")";
}

void require_finite(const Spheres& s, double t) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Kinetics& k = s.kinetics[i];
    if (s.sphere[i].position.allFinite() && k.velocity.allFinite() && k.spin.allFinite()) continue;
    throw NumericsError("mechanics: particle " + std::to_string(k.id) +
                        " at t = " + std::to_string(t) + " s: motion is not finite: position " +
                        text(s.sphere[i].position) + " m, velocity " + text(k.velocity) +
                        " m/s, spin " + text(k.spin) + " rad/s");
  }
}

}  // namespace

Mechanics::Mechanics(const Case& c)
    : case_(c), dt_(physics::time_step(c).step), laws_(c), walls_(c) {}

void Mechanics::advance(State& state, std::uint64_t sub_steps, Timings& timings) {
  const double begin = state.time;
  double now = begin;
  Stages stages;
  timed(stages.lists, [&] { open(state); });
  if (state.step == 0 && sub_steps > 0) {  // forces of the opening state, springs at rest
    timed(stages.walls, [&] { wall_forces(0.0); });
    timed(stages.pairs, [&] { pair_forces(0.0); });
    gather();
  }
  for (std::uint64_t k = 1; k <= sub_steps; ++k) {
    const double before = now;
    now = begin + static_cast<double>(k) * dt_;
    timed(stages.kick, [&] { kick_and_drift(); });
    walls_.place(now);
    if (!all_inside_) take_out_lost(now);
    if (lists_are_due(before, now)) timed(stages.lists, [&] { refresh_lists(); });
    timed(stages.walls, [&] { wall_forces(dt_); });
    timed(stages.pairs, [&] { pair_forces(dt_); });
    timed(stages.kick, [&] { gather_and_kick(); });
  }
  require_finite(spheres_, now);
  timed(stages.lists, [&] { close(state); });
  state.time = now;
  state.step += sub_steps;
  timings.add("mechanics.kick", stages.kick);
  timings.add("mechanics.lists", stages.lists);
  timings.add("mechanics.walls", stages.walls);
  timings.add("mechanics.pairs", stages.pairs);
}

void Mechanics::open(State& state) {
  Particles& p = state.particles;
  smallest_ = p.size() > 0 ? p.radius[0] : 1.0;
  for (const double r : p.radius) smallest_ = std::min(smallest_, r);
  speed_ = parallel_max(p.size(), 0.0, [&](std::size_t i) { return p.velocity[i].norm(); });
  reorder(state, spatial_order(p, 2.0 * smallest_));
  spheres_ = gather_spheres(p);
  lost_.clear();
  dissipated_ = 0.0;
  extremes_ = {};
  walls_.place(state.time);
  rebuild_lists(state.pair_contacts, state.wall_contacts);
}

void Mechanics::close(State& state) {
  if (!lost_.empty()) {  // what is left stands in the order that it had
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < state.particles.size() && left.size() < spheres_.size(); ++i)
      if (state.particles.id[i] == spheres_.kinetics[left.size()].id) left.push_back(i);
    keep(state.particles, left);
    state.lost.insert(state.lost.end(), lost_.begin(), lost_.end());
  }
  put_back(spheres_, state.particles);
  state.pair_contacts = pairs_.history(spheres_);
  state.wall_contacts = walls_.history();
  state.fluxes.dissipated += dissipated_;
  state.extremes.overlap_ratio = std::max(state.extremes.overlap_ratio, extremes_.overlap_ratio);
  state.extremes.speed = std::max(state.extremes.speed, extremes_.speed);
}

void Mechanics::kick_and_drift() {
  const double half = 0.5 * dt_;
  const Vec3 g = case_.gravity, low = case_.domain_low, high = case_.domain_high;
  const std::size_t blocks = (spheres_.size() + kick_block - 1) / kick_block;
  fastest_.assign(blocks, 0.0);
  outside_.assign(blocks, 0);
  const auto block = [&](std::size_t first, std::size_t last) {
    double fastest = 0.0;
    bool all_inside = true;
    for (std::size_t i = first; i < last; ++i) {
      const Load& f = spheres_.load[i];
      Kinetics& k = spheres_.kinetics[i];
      Vec3& x = spheres_.sphere[i].position;
      k.velocity += half * (f.inverse_mass * f.force + g);
      k.spin += (half * f.inverse_inertia) * f.torque;
      x += dt_ * k.velocity;
      fastest = std::max(fastest, k.velocity.squaredNorm());
      for (int a = 0; a < 3; ++a) all_inside = all_inside && x[a] >= low[a] && x[a] <= high[a];
    }
    fastest_[first / kick_block] = fastest;
    outside_[first / kick_block] = !all_inside;
  };
  parallel_blocks(spheres_.size(), std::cref(block), kick_block);
  speed_ = 0.0;
  for (const double squared : fastest_) speed_ = std::max(speed_, std::sqrt(squared));
  all_inside_ = std::none_of(outside_.begin(), outside_.end(), [](auto o) { return o != 0; });
  extremes_.speed = std::max(extremes_.speed, speed_);
}

// Particles outside the domain leave the books here; a place that is no number stops the run.
void Mechanics::take_out_lost(double t) {
  require_finite(spheres_, t);
  std::vector<std::uint32_t> left;
  std::vector<ParticleId> lost;
  for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
    const Vec3& x = spheres_.sphere[i].position;
    const ParticleId id = spheres_.kinetics[i].id;
    if ((x.array() >= case_.domain_low.array()).all() &&
        (x.array() <= case_.domain_high.array()).all()) {
      left.push_back(i);
    } else {
      lost.push_back(id);
      lost_.push_back({id, t, x});
    }
  }
  const ContactHistory walls = reordered(walls_.history(), left);
  const ContactHistory pairs = without(reordered(pairs_.history(spheres_), left), lost);
  keep(spheres_.sphere, left);
  keep(spheres_.kinetics, left);
  keep(spheres_.load, left);
  rebuild_lists(pairs, walls);
}

// The lists hold as long as nothing that was farther off than the skin can have come to touch.
bool Mechanics::lists_are_due(double t0, double t1) {
  gone_ += speed_ * dt_;
  wall_gone_ += walls_.displacement_bound(t0, t1);
  const double safe = 0.999 * skin_;  // rounding in the sums
  return 2.0 * gone_ > safe || gone_ + wall_gone_ > safe;
}

void Mechanics::refresh_lists() { rebuild_lists(pairs_.history(spheres_), walls_.history()); }

// A bed at rest wants a thin skin, few candidates; a fast stream a thick one, few rebuilds. The
// forces do not depend on it.
void Mechanics::rebuild_lists(const ContactHistory& pairs, const ContactHistory& walls) {
  const double least = case_.models.mechanics.skin * smallest_;
  skin_ = std::clamp(2.0 * steps_of_a_list * speed_ * dt_, least, thickest_skin * least);
  pairs_.rebuild(spheres_, skin_, pairs);
  walls_.rebuild(spheres_, skin_, walls);
  gone_ = 0.0;
  wall_gone_ = 0.0;
}

void Mechanics::wall_forces(double dt) { book(walls_.set_forces(spheres_, laws_, dt)); }

void Mechanics::pair_forces(double dt) { book(pairs_.add_forces(spheres_, laws_, dt)); }

void Mechanics::book(const ContactBook& sums) {
  dissipated_ += sums.dissipated;
  extremes_.overlap_ratio = std::max(extremes_.overlap_ratio, sums.overlap_ratio);
}

void Mechanics::gather() {
  parallel_for(spheres_.size(),
               [&](std::size_t i) { pairs_.gather_reactions(i, spheres_.load[i]); });
}

void Mechanics::gather_and_kick() {
  const double half = 0.5 * dt_;
  const Vec3 g = case_.gravity;
  const auto block = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Load& f = spheres_.load[i];
      pairs_.gather_reactions(i, f);
      Kinetics& k = spheres_.kinetics[i];
      k.velocity += half * (f.inverse_mass * f.force + g);
      k.spin += (half * f.inverse_inertia) * f.torque;
    }
  };
  parallel_blocks(spheres_.size(), std::cref(block), kick_block);
}

double kinetic_energy(const Particles& p) {
  return parallel_sum(p.size(), [&](std::size_t i) {
    return 0.5 * p.mass[i] *
           (p.velocity[i].squaredNorm() +
            0.4 * p.radius[i] * p.radius[i] * p.spin[i].squaredNorm());
  });
}

double rms_speed(const Particles& p) {
  const double mass = parallel_sum(p.size(), [&](std::size_t i) { return p.mass[i]; });
  return mass > 0.0 ? std::sqrt(2.0 * kinetic_energy(p) / mass) : 0.0;
}

}  // namespace pmr::physics
