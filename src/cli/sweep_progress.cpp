#include "cli/sweep_progress.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace pmr::cli {
namespace {

const char* word(study::JobState state) {
  switch (state) {
    case study::JobState::started:
      return "started";
    case study::JobState::done:
      return "done";
    case study::JobState::failed:
      return "FAILED";
    case study::JobState::interrupted:
      return "stopped";
    case study::JobState::skipped:
      break;
  }
  return "skipped";
}

std::string clock_text(double seconds) {
  const auto s = static_cast<long>(seconds);
  return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

SweepProgress::SweepProgress(const std::vector<study::Job>& jobs, std::size_t cores)
    : total_(jobs.size()), cores_(cores) {
  for (const study::Job& job : jobs) forecast_left_ += job.seconds;
}

// The forecast, scaled by how it did so far; the time of a job that ran on its share of the cores.
std::string SweepProgress::remaining() const {
  if (!(forecast_done_ > 0.0) || ended_ == total_) return "";
  const double speed = spent_ / forecast_done_;
  return fmt::format("  about {} left",
                     clock_text(speed * forecast_left_ / static_cast<double>(cores_)));
}

void SweepProgress::show(const study::JobEvent& event) {
  const bool has_ended = event.state != study::JobState::started;
  if (has_ended) {
    ++ended_;
    forecast_left_ -= event.job.seconds;
    if (event.state == study::JobState::done) {
      forecast_done_ += event.job.seconds;
      spent_ += event.seconds;
    }
  }
  std::string text =
      fmt::format("{} {:>4}/{} {:8} {}{}{}\n", clock_text(clock_.seconds()), ended_, total_,
                  word(event.state), event.job.name,
                  has_ended && event.seconds > 0.0 ? fmt::format(" ({:.0f} s)", event.seconds) : "",
                  remaining());
  if (!event.reason.empty()) text += fmt::format("         {}\n", event.reason);
  std::fputs(text.c_str(), stderr);  // whether or not anybody reads it
}

}  // namespace pmr::cli
