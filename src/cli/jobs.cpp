#include "cli/jobs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "cli/stop_signal.hpp"
#include "cli/sweep_progress.hpp"
#include "study/engine.hpp"

namespace pmr::cli {
namespace {

int all_cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

Share share_of(const JobOptions& options) {
  const int total = options.threads > 0 ? options.threads : all_cores();
  const int at_once = options.at_once > 0 ? options.at_once : total;
  return {static_cast<std::size_t>(at_once), std::max(1, total / at_once)};
}

std::string duration_text(double seconds) {
  const double hours = seconds / 3600.0;
  return hours < 2.0 ? fmt::format("{:.0f} min", 60.0 * hours) : fmt::format("{:.1f} h", hours);
}

bool carry_out(const std::vector<study::Job>& jobs, const study::Folder& folder,
               const JobOptions& options, const Share& share) {
  const AtStake at_stake;
  const StopToken stop = at_stake.token();
  SweepProgress progress(jobs, share.at_once * static_cast<std::size_t>(share.threads));
  const auto show = [&](const study::JobEvent& event) { progress.show(event); };
  if (options.engine == "slurm")
    study::run_on_slurm(jobs, folder.root(), share.threads, stop, show);
  else
    study::run_here(jobs, share.at_once, stop, show);
  return stop.is_set();
}

}  // namespace pmr::cli
