// A line that tells how far a run is: phase, time, temperatures, how long it will take.
#pragma once
#include <string>

#include "pmr/base/timer.hpp"
#include "sim/forecast.hpp"
#include "sim/simulation.hpp"

namespace pmr::cli {

// On a terminal one line that is rewritten; in a log file a line every ten seconds.
class Progress {
 public:
  Progress();
  ~Progress();  // leaves the last line standing
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(const sim::Simulation& simulation);

 private:
  std::string line(const sim::Simulation& simulation) const;
  void begin_phase(const sim::Simulation& simulation);
  std::string time_left(const sim::Simulation& simulation) const;

  bool is_terminal_;
  Stopwatch total_, phase_clock_, since_shown_;
  Phase phase_ = Phase::done;
  sim::UnitCosts costs_;
  double phase_work_ = 0.0;  // [s] foreseen for the rest of the phase when it was first seen
  bool shown_ = false;
};

}  // namespace pmr::cli
