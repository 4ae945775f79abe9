#include "physics/mechanics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/neighbours.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

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
    throw NumericsError("mechanics: particle " + std::to_string(s.label[i].id) +
                        " at t = " + std::to_string(t) + " s: motion is not finite: position " +
                        text(s.sphere[i].position) + " m, velocity " + text(k.velocity) +
                        " m/s, spin " + text(k.spin) + " rad/s");
  }
}

}  // namespace

Mechanics::Mechanics(const Case& c)
    : case_(c),
      leapfrog_{physics::time_step(c).step, c.gravity},
      domain_{c.domain_low, c.domain_high},
      adhered_(c),
      walls_(c),
      pairs_(ContactLaws(c)) {}

// Half kick, drift, forces, half kick. The half kicks that meet between two sub-steps and the drift
// go in one pass with the forces, block by block.
void Mechanics::advance(State& state, std::uint64_t sub_steps, Timings& timings, StopToken stop) {
  const double begin = state.time;
  double now = begin;
  Stages stages;
  timed(stages.lists, [&] { open(state); });
  if (state.step == 0 && sub_steps > 0) opening_forces();
  if (sub_steps > 0) timed(stages.kick, [&] { opening_drift(now + leapfrog_.dt); });
  for (std::uint64_t k = 1; k <= sub_steps; ++k) {
    stop.check();
    const double before = now;
    now = begin + static_cast<double>(k) * leapfrog_.dt;
    walls_.place(now);
    if (!all_inside_) take_out_lost(now);
    const double next = begin + static_cast<double>(k + 1) * leapfrog_.dt;
    pass({walls_.displacement_bound(before, now), now, next, k == sub_steps}, stages);
  }
  require_finite(spheres_, now);
  take_over_impulses();
  for (Wrench& load : wall_loads_) {
    const double passed = std::max(now - begin, leapfrog_.dt);
    load = {load.force / passed, load.torque / passed};
  }
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
  reorder(state, spatial_order(p));
  spheres_ = gather_spheres(p);
  free_ = p.size();
  lost_.clear();
  dissipated_ = 0.0;
  elastic_ = state.elastic_energy;
  extremes_ = {};
  wall_loads_.assign(case_.wall_forces.empty() ? 0 : case_.walls.bodies.size(), {});
  walls_.place(state.time);
  open_blocks(state.time);
  build_lists(state.pair_contacts, state.wall_contacts);
}

// Blocks of the particles, and behind them those of the grains that adhere to walls.
void Mechanics::open_blocks(double t) {
  blocks_ = cut(free_);
  free_blocks_ = blocks_.size();
  adhered_.join(t, spheres_, blocks_);
}

void Mechanics::close(State& state) {
  if (!lost_.empty()) {  // what is left stands in the order that it had
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < state.particles.size() && left.size() < free_; ++i)
      if (state.particles.id[i] == spheres_.label[left.size()].id) left.push_back(i);
    keep(state.particles, left);
    state.lost.insert(state.lost.end(), lost_.begin(), lost_.end());
  }
  put_back(spheres_, state.particles);
  state.pair_contacts = pairs_.history(spheres_, free_);
  state.wall_contacts = walls_.history(free_);
  state.fluxes.dissipated += dissipated_;
  state.elastic_energy = elastic_;
  state.extremes.overlap_ratio = std::max(state.extremes.overlap_ratio, extremes_.overlap_ratio);
  state.extremes.speed = std::max(state.extremes.speed, extremes_.speed);
}

// Forces of the opening state, springs at rest.
void Mechanics::opening_forces() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const std::span<Load> loads(&spheres_.load[blocks_[b].first], blocks_[b].size());
    std::fill(loads.begin(), loads.end(), Load{});
    if (!adheres(blocks_[b])) elastic_ += walls_.add_forces(b, spheres_, 0.0, loads).elastic;
    elastic_ += pairs_.add_forces(b, spheres_, 0.0, loads).elastic;
  }
}

void Mechanics::opening_drift(double t) {
  parallel_for(
      blocks_.size(),
      [&](std::size_t b) {
        const Block& block = blocks_[b];
        const std::span<const Load> loads(&spheres_.load[block.first], block.size());
        pass_[b].passage =
            adheres(block)  // what their loads do in this half step the call before has counted
                ? adhered_.follow(spheres_, loads, block, t, leapfrog_.dt, 0.0, after_)
                : kick_and_drift(spheres_, loads, block, leapfrog_, false, after_);
      },
      1);
  take_over_motion();
}

// Particles outside the domain leave the books here; a place that is no number stops the run.
void Mechanics::take_out_lost(double t) {
  require_finite(spheres_, t);
  take_over_impulses();
  std::vector<std::uint32_t> left;
  std::vector<ParticleId> lost;
  for (std::uint32_t i = 0; i < free_; ++i) {
    const Vec3& x = spheres_.sphere[i].position;
    const ParticleId id = spheres_.label[i].id;
    if ((x.array() >= domain_.low.array()).all() && (x.array() <= domain_.high.array()).all()) {
      left.push_back(i);
    } else {
      lost.push_back(id);
      lost_.push_back({id, t, x});
    }
  }
  const ContactHistory walls = reordered(walls_.history(free_), left);
  const ContactHistory pairs = without(reordered(pairs_.history(spheres_, free_), left), lost);
  keep(spheres_.sphere, left);
  keep(spheres_.kinetics, left);
  keep(spheres_.label, left);
  spheres_.load.resize(left.size());
  free_ = left.size();
  open_blocks(t);
  build_lists(pairs, walls);
}

void Mechanics::build_lists(const ContactHistory& pairs, const ContactHistory& walls) {
  pass_.assign(blocks_.size(), {});
  for (BlockPass& pass : pass_) pass.impulse.assign(wall_loads_.size(), {});
  bound(spheres_, blocks_);
  after_.resize(spheres_.size(), blocks_.size());
  if (!adhered_.empty()) after_ = spheres_;  // with the empty places between
  const double skin = case_.models.mechanics.skin * smallest_;
  pairs_.open(spheres_, blocks_, leapfrog_.dt, skin, pairs);
  walls_.open(spheres_,
              {blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(free_blocks_)}, skin,
              walls);
}

void Mechanics::pass(const Pass& at, Stages& stages) {
  const Stopwatch watch;
  parallel_for(
      blocks_.size(), [&](std::size_t b) { pass_block(b, at); }, 1);
  take_over_sums();
  take_over_motion();
  Stages all;
  for (const BlockPass& p : pass_) {
    all.kick += p.stages.kick;
    all.lists += p.stages.lists;
    all.walls += p.stages.walls;
    all.pairs += p.stages.pairs;
  }
  const double share =
      watch.seconds() / std::max(all.kick + all.lists + all.walls + all.pairs, 1e-12);
  stages.kick += share * all.kick;
  stages.lists += share * all.lists;
  stages.walls += share * all.walls;
  stages.pairs += share * all.pairs;
}

// One task: a block's lists, the forces of its walls and of its pairs, its motion.
void Mechanics::pass_block(std::size_t b, const Pass& at) {
  const Block& block = blocks_[b];
  const double dt = leapfrog_.dt;
  BlockPass& p = pass_[b];
  std::array<Load, largest_block> scratch;
  const std::span<Load> loads = at.is_last ? std::span(&spheres_.load[block.first], block.size())
                                           : std::span(scratch).first(block.size());
  std::fill(loads.begin(), loads.end(), Load{});
  Stopwatch watch;
  const bool is_free = !adheres(block);
  if (is_free) walls_.follow(b, spheres_, p.passage.fastest * dt + at.walls_moved);
  pairs_.follow(b, spheres_, spread_, dt);
  p.stages.lists = watch.lap();
  const ContactBook at_walls =
      is_free ? walls_.add_forces(b, spheres_, dt, loads, p.impulse) : ContactBook{};
  p.stages.walls = watch.lap();
  const ContactBook at_pairs = pairs_.add_forces(b, spheres_, dt, loads);
  p.stages.pairs = watch.lap();
  if (!is_free && !p.impulse.empty()) adhered_.add_impulse(spheres_, loads, block, dt, p.impulse);
  p.passage = move_block(block, loads, at);
  p.stages.kick = watch.lap();
  p.sums = {at_walls.elastic + at_pairs.elastic, at_walls.wall_work,
            std::max(at_walls.overlap_ratio, at_pairs.overlap_ratio)};
}

Passage Mechanics::move_block(const Block& block, std::span<const Load> loads, const Pass& at) {
  if (adheres(block))
    return adhered_.follow(spheres_, loads, block, at.is_last ? at.now : at.next, leapfrog_.dt,
                           leapfrog_.dt, after_);
  return at.is_last ? kick(spheres_, loads, block, leapfrog_, after_)
                    : kick_and_drift(spheres_, loads, block, leapfrog_, true, after_);
}

// Dissipated is what contacts have taken from particles and moving walls and their Hertz springs do
// not hold.
void Mechanics::take_over_sums() {
  const double elastic_before = elastic_;
  elastic_ = 0.0;
  for (const BlockPass& p : pass_) {
    elastic_ += p.sums.elastic;
    dissipated_ += p.sums.wall_work;
    extremes_.overlap_ratio = std::max(extremes_.overlap_ratio, p.sums.overlap_ratio);
  }
  dissipated_ -= elastic_ - elastic_before;
}

void Mechanics::take_over_motion() {
  std::swap(static_cast<Places&>(spheres_), after_);
  all_inside_ = true;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Passage& p = pass_[b].passage;
    extremes_.speed = std::max(extremes_.speed, p.fastest);
    dissipated_ -= p.contact_work;
    const Box& box = spheres_.block_box[b];
    if (b >= free_blocks_) continue;
    all_inside_ = all_inside_ && p.is_finite && (box.low.array() >= domain_.low.array()).all() &&
                  (box.high.array() <= domain_.high.array()).all();
  }
  VelocityRange all;
  for (const VelocityRange& range : spheres_.block_velocity) all.include(range);
  spread_ = all.spread();
}

void Mechanics::take_over_impulses() {
  for (const BlockPass& p : pass_)
    for (std::size_t k = 0; k < p.impulse.size(); ++k) {
      wall_loads_[k].force += p.impulse[k].force;
      wall_loads_[k].torque += p.impulse[k].torque;
    }
}

void leave_in(State& state, const std::vector<std::uint32_t>& places) {
  std::vector<ParticleId> gone;
  for (std::uint32_t i = 0, kept = 0; i < state.particles.size(); ++i)
    if (kept < places.size() && places[kept] == i)
      ++kept;
    else
      gone.push_back(state.particles.id[i]);
  reorder(state, places);
  state.pair_contacts = without(state.pair_contacts, gone);
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
