// Keeps the course of a run: a row of the series per interval, snapshots when due; hands both to
// run.h5 at every checkpoint, so that file and checkpoint belong together.
#pragma once
#include <filesystem>
#include <vector>

#include "coupling/nodes.hpp"
#include "io/run_file.hpp"
#include "pmr/base/timer.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

class Recorder {
 public:
  Recorder(const Case& c, const coupling::Nodes& nodes, std::filesystem::path dir);

  // Rates of the first row count from this state.
  void start_from(const State& state);
  // `wall_loads` [bodies]: means over the interval; empty where nothing moved.
  void record(const State& state, bool takes_snapshot, const std::vector<Wrench>& wall_loads = {});
  // Writes what is pending without a checkpoint: what a failed run had computed stays readable.
  void flush();
  // Writes what is pending and the checkpoint, each file whole or not at all.
  void checkpoint(const State& state);
  double seconds_since_checkpoint() const { return since_checkpoint_.seconds(); }  // [s]

 private:
  void add_row(const State& state, const std::vector<Wrench>& wall_loads);

  const Case& case_;
  const coupling::Nodes& nodes_;
  std::filesystem::path dir_;
  io::Series rows_;                      // not yet in run.h5
  std::vector<io::Snapshot> snapshots_;  // not yet in run.h5
  double last_time_ = 0.0;               // [s] of the last row
  double last_released_ = 0.0;           // [mol] at the last row
  Stopwatch since_checkpoint_;
};

}  // namespace pmr::sim
