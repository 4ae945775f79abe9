// A run: the step of the reactor, and the loop round it.
#pragma once
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>

#include "coupling/bed_gas.hpp"
#include "coupling/network.hpp"
#include "coupling/nodes.hpp"
#include "physics/mechanics.hpp"
#include "physics/pouring.hpp"
#include "pmr/base/stop.hpp"
#include "pmr/base/timer.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"
#include "sim/bed.hpp"
#include "sim/recorder.hpp"
#include "sim/schedule.hpp"

namespace pmr::sim {

enum class Ending { completed, stopped };

class Simulation {
 public:
  // A fresh run: fills in the particles. CaseError when they do not fit.
  Simulation(const Case& c, std::filesystem::path dir);
  // A fresh run with particles that are there already.
  Simulation(const Case& c, std::filesystem::path dir, Bed bed);
  // Goes on from a checkpoint of the same case.
  Simulation(const Case& c, std::filesystem::path dir, State state);

  // Steps until the case's end or until `stop` is set; `look` sees the state after every step. An
  // interval that is given up half-way, be it for `stop` or an error, leaves nothing: the state is
  // again that of the last complete interval, and is saved. A StorageError leaves the files as they
  // were saved last.
  Ending run(const StopToken& stop, const std::function<void(const Simulation&)>& look);

  void step(const StopToken& stop = {});

  const Case& setup() const { return case_; }
  const State& state() const { return state_; }
  const coupling::Nodes& nodes() const { return nodes_; }
  const Timings& timings() const { return timings_; }
  const coupling::NetworkWork& network_work() const { return work_; }
  double time_step() const { return mechanics_.time_step(); }  // [s]
  double end() const { return schedule_.end(); }               // [s]

 private:
  void open();
  void settle();
  void open_pores();
  // `before` [s] and `deepest` [1] of the radius: clock and deepest contact when the step began.
  void refuse_walls_in_particles(double before, double deepest) const;
  void pour();
  void move(const Interval& interval, const StopToken& stop);
  void catch_particles();
  void retrace_if_due(const Interval& interval, const StopToken& stop);
  void exchange_heat(const Interval& interval, const StopToken& stop);
  void note_state();
  void replace_exchange(Exchange next);
  void go_back();
  void save_after(const std::exception& error);

  const Case& case_;
  State state_;
  State before_;                             // the interval, without exchange factors
  std::optional<Exchange> exchange_before_;  // only where the interval has replaced them
  physics::Mechanics mechanics_;
  Schedule schedule_;
  std::vector<physics::Entry> entries_;  // of particles to be poured in
  coupling::Nodes nodes_;
  Recorder recorder_;
  coupling::Gaps gaps_;        // of the bed as it last lay
  coupling::PoreSpace pores_;  // of the bed at rest
  Timings timings_;
  coupling::NetworkWork work_;
};

}  // namespace pmr::sim
