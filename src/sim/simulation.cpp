#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "coupling/heat_links.hpp"
#include "coupling/outlook.hpp"
#include "coupling/retrace.hpp"
#include "coupling/thermal_state.hpp"
#include "instruments/catching.hpp"
#include "physics/insertion.hpp"
#include "physics/wall_overlaps.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"
#include "sim/ledger.hpp"

namespace pmr::sim {

Simulation::Simulation(const Case& c, std::filesystem::path dir)
    : case_(c),
      mechanics_(c),
      schedule_(c, mechanics_.time_step()),
      entries_(physics::entries(c)),
      recorder_(case_, nodes_, std::move(dir)) {
  state_.particles = physics::insert(c);
  state_.waiting = physics::waiting_particles(c, static_cast<ParticleId>(state_.particles.size()));
  schedule_.begin(state_);
  open();
}

Simulation::Simulation(const Case& c, std::filesystem::path dir, Bed bed)
    : case_(c),
      mechanics_(c),
      schedule_(c, mechanics_.time_step()),
      entries_(physics::entries(c)),
      recorder_(case_, nodes_, std::move(dir)) {
  state_.time = bed.time;
  state_.rest_since = bed.rest_since;
  state_.particles = std::move(bed.particles);
  state_.pair_contacts = std::move(bed.pair_contacts);
  state_.wall_contacts = std::move(bed.wall_contacts);
  schedule_.begin_with_bed(state_, physics::rms_speed(state_.particles));
  open();
}

Simulation::Simulation(const Case& c, std::filesystem::path dir, State state)
    : case_(c),
      state_(std::move(state)),
      mechanics_(c),
      schedule_(c, mechanics_.time_step()),
      entries_(physics::entries(c)),
      nodes_(coupling::number_nodes(c, state_.opening.particles)),
      recorder_(case_, nodes_, std::move(dir)) {
  if (state_.phase == Phase::react) coupling::number_in_space(state_.particles, nodes_);
  pores_ = coupling::cut_pores(case_, nodes_, state_);
  recorder_.start_from(state_);
}

// Heat, books and the first record of a run that begins.
void Simulation::open() {
  nodes_ = coupling::number_nodes(case_, state_.particles.size() + state_.waiting.size());
  if (state_.phase == Phase::react) coupling::number_in_space(state_.particles, nodes_);
  coupling::begin_thermal_state(case_, nodes_, state_);
  open_pores();
  recorder_.start_from(state_);
  recorder_.record(state_, true);
  recorder_.checkpoint(state_);
}

// One step of the reactor.
void Simulation::step(const StopToken& stop) {
  note_state();
  const Interval interval = schedule_.next(state_);
  const double deepest = state_.extremes.overlap_ratio;
  if (interval.moves()) pour();
  if (interval.moves()) move(interval, stop);
  if (interval.moves()) catch_particles();
  if (interval.closes_chamber) coupling::close_chamber(case_, state_);
  if (interval.heats) retrace_if_due(interval, stop);
  if (interval.heats) exchange_heat(interval, stop);
  if (!interval.moves()) state_.time = interval.end;
  ++state_.interval;
  const bool is_pouring = state_.waiting.size() > 0;  // not at rest, whatever moves
  const bool is_over = interval.moves() && instruments::ends_motion(case_, state_);
  const bool phase_ended = schedule_.move_on(
      state_, is_over,
      is_pouring ? std::numeric_limits<double>::infinity() : physics::rms_speed(state_.particles));
  refuse_walls_in_particles(interval.begin, deepest);
  if (phase_ended && state_.phase == Phase::react) settle();
  recorder_.record(state_, interval.takes_snapshot || phase_ended,
                   interval.moves() ? mechanics_.mean_wall_loads() : std::vector<Wrench>{});
}

// A wall that has come in since must have found its place free: its contacts would throw off what
// it cuts into, and conduct as none does. As deep as the run's contacts were it may stand: where
// one floor takes the place of another.
void Simulation::refuse_walls_in_particles(double before, double deepest) const {
  const auto came_in = [&](const Surface& surface) {
    return !is_present(surface, before) && is_present(surface, state_.time);
  };
  const auto& surfaces = case_.walls.surfaces;
  if (std::none_of(surfaces.begin(), surfaces.end(), came_in)) return;
  const double limit = std::max(physics::largest_opening_overlap, deepest);
  const auto found =
      physics::wall_overlaps(state_.particles, case_.walls, state_.time, limit, came_in);
  if (found.excessive.empty()) return;
  throw NumericsError(fmt::format(
      "t = {:.6g} s: a wall comes in where particles are: {}; see its `from`, and its place",
      state_.time, to_text(found.excessive.front(), state_.particles, case_.walls, limit)));
}

// The bed lies now: neighbours get neighbouring nodes, and what named the old ones goes.
void Simulation::settle() {
  coupling::number_in_space(state_.particles, nodes_);
  replace_exchange({});
  gaps_ = {};
  open_pores();
}

// Where the bed's gas is resolved it begins as the air around.
void Simulation::open_pores() {
  pores_ = coupling::cut_pores(case_, nodes_, state_);
  if (pores_.is_resolved()) coupling::fill_pores(case_, nodes_, pores_, state_);
}

// Particles that are due come in; exchange factors are traced anew with them.
void Simulation::pour() {
  const StageTimer timer(timings_, "pouring");
  if (physics::pour(case_, entries_, state_) > 0) replace_exchange({});
}

void Simulation::move(const Interval& interval, const StopToken& stop) {
  if (state_.particles.size() == 0) {  // none has come in yet
    state_.time = interval.end;
    return;
  }
  const coupling::Holdings before = coupling::holdings(case_, state_.particles);
  const std::size_t lost = state_.lost.size();
  mechanics_.advance(state_, interval.sub_steps, timings_, stop);
  if (state_.lost.size() == lost) return;
  book_losses(case_, before, state_);
  replace_exchange({});  // the lost take no further part in it: traced anew
}

// What has crossed an opening that catches leaves the run, with what it holds.
void Simulation::catch_particles() {
  const auto caught = instruments::crossings(case_, before_, state_);
  if (caught.empty()) return;
  const coupling::Holdings before = coupling::holdings(case_, state_.particles);
  std::vector<std::uint8_t> is_caught(state_.opening.particles, 0);  // by id
  for (const CaughtParticle& particle : caught) is_caught[particle.id] = 1;
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < state_.particles.size(); ++i)
    if (is_caught[state_.particles.id[i]] == 0) left.push_back(i);
  physics::leave_in(state_, left);
  state_.caught.insert(state_.caught.end(), caught.begin(), caught.end());
  book_losses(case_, before, state_);
  replace_exchange({});
}

// Anew when there are no factors, a wall has come or gone, emissivities have changed much, or the
// particles have moved on and a stated time has passed; where emissivities have changed a little,
// factors are scaled.
void Simulation::retrace_if_due(const Interval& interval, const StopToken& stop) {
  if (!case_.models.radiation) return;
  const RadiationModel& model = *case_.models.radiation;
  const StageTimer timer(timings_, "radiation");
  const double traced = state_.exchange.traced_at;
  bool due = !std::isfinite(traced);
  for (const Surface& surface : case_.walls.surfaces)
    due = due || is_present(surface, traced) != is_present(surface, state_.time);
  const double rounding = 0.5 * mechanics_.time_step();  // [s]
  if (interval.moves() && state_.time - traced >= model.retrace_interval - rounding)
    due = due || coupling::mean_displacement(state_) > model.retrace_displacement;
  const auto now = coupling::emissivities(case_, nodes_, state_);
  const auto change = [&](const std::vector<double>& then) {
    return coupling::mean_change(case_, nodes_, state_, now, then);
  };
  due = due || change(state_.exchange.traced_emissivity) > model.emissivity_change_traced;
  if (due) {
    const double rays = interval.moves() ? model.rays_moving : model.rays_settled;
    replace_exchange(coupling::retrace(case_, nodes_, state_, rays, stop));
  } else if (change(state_.exchange.emissivity) > model.emissivity_change) {
    replace_exchange(state_.exchange);
    coupling::rescale(case_, nodes_, state_);
  }
}

void Simulation::exchange_heat(const Interval& interval, const StopToken& stop) {
  const double length = interval.end - interval.begin;
  const auto outlook = coupling::look_ahead(case_, state_, 0.5 * length);
  auto links = [&] {
    const StageTimer timer(timings_, "conduction");
    if (interval.moves() || !coupling::walls_stand(case_, gaps_, state_.time))
      gaps_ = coupling::find_gaps(case_, nodes_, state_);
    return coupling::conduct(case_, nodes_, state_, gaps_, outlook, pores_);
  }();
  const StageTimer timer(timings_, "network");
  const coupling::TrendWatch watch(case_, state_);
  const auto work = coupling::advance_network(case_, nodes_, outlook, std::move(links), pores_,
                                              interval.begin, interval.end, state_, stop);
  watch.set(case_, length, state_);
  state_.set_point_at = std::min(state_.set_point_at, work.set_point_at);
  work_.steps += work.steps;
  work_.rate_calls += work.rate_calls;
  work_.newton += work.newton;
  work_.krylov += work.krylov;
}

// Exchange factors are most of the state, and few intervals replace them: they are kept apart.
void Simulation::note_state() {
  Exchange exchange = std::exchange(state_.exchange, {});
  before_ = state_;
  state_.exchange = std::move(exchange);
  exchange_before_.reset();
}

void Simulation::replace_exchange(Exchange next) {
  Exchange last = std::exchange(state_.exchange, std::move(next));
  if (!exchange_before_) exchange_before_ = std::move(last);
}

// To the last complete interval.
void Simulation::go_back() {
  before_.exchange = std::move(exchange_before_ ? *exchange_before_ : state_.exchange);
  state_ = std::move(before_);
}

// An error that ends the run must not be hidden by one of the disk.
void Simulation::save_after(const std::exception& error) try {
  go_back();
  recorder_.checkpoint(state_);
} catch (const StorageError& second) {
  throw NumericsError(std::string(error.what()) + "\n" + second.what());
}

Ending Simulation::run(const StopToken& stop, const std::function<void(const Simulation&)>& look) {
  while (state_.phase != Phase::done && !stop.is_set()) {
    const Phase phase = state_.phase;
    try {
      step(stop);
    } catch (const Stopped&) {
      go_back();
      break;
    } catch (const std::exception& error) {
      save_after(error);
      throw;
    }
    look(*this);
    if (state_.phase != phase ||
        recorder_.seconds_since_checkpoint() > case_.output.checkpoint_wall_time) {
      const StageTimer timer(timings_, "output");
      recorder_.checkpoint(state_);
    }
  }
  const StageTimer timer(timings_, "output");
  recorder_.checkpoint(state_);
  return state_.phase == Phase::done ? Ending::completed : Ending::stopped;
}

}  // namespace pmr::sim
