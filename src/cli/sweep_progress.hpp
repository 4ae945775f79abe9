// The table of a sweep while it runs: a line for each job that ends, what runs now, how long yet.
#pragma once
#include <string>
#include <vector>

#include "pmr/base/timer.hpp"
#include "study/engine.hpp"

namespace pmr::cli {

class SweepProgress {
 public:
  // `cores` share the work that is left.
  SweepProgress(const std::vector<study::Job>& jobs, std::size_t cores);
  void show(const study::JobEvent& event);

 private:
  std::string remaining() const;

  std::size_t total_, ended_ = 0;
  double forecast_left_ = 0.0;                // [s] of one core, as forecast
  double forecast_done_ = 0.0, spent_ = 0.0;  // [s] of the jobs that ended
  std::size_t cores_;
  Stopwatch clock_;
};

}  // namespace pmr::cli
