// Where the jobs of a study run: processes on this machine, or a Slurm cluster.
#pragma once
#include <functional>
#include <span>
#include <string>

#include "pmr/base/stop.hpp"
#include "study/folder.hpp"

namespace pmr::study {

enum class JobState { started, done, failed, interrupted, skipped };
struct JobEvent {
  const Job& job;
  JobState state;
  std::string reason;    // of a failure, one line
  double seconds = 0.0;  // [s] that it took
};
using OnEvent = std::function<void(const JobEvent&)>;

// `at_once` processes at a time, each in its own process group; they end with this process. Once
// `stop` is set each running job is asked for a checkpoint, and no more are started. A job whose
// predecessor failed is skipped; the log of a job that was interrupted goes.
void run_here(std::span<const Job> jobs, std::size_t at_once, const StopToken& stop,
              const OnEvent& on_event);

// Two Slurm job arrays, mixings first, each task with its `threads` cores, written to and submitted
// from FOLDER/slurm; waits for their end. What an earlier call submitted and still runs is waited
// for, not submitted again; `stop` ends the waiting alone. Partition, account and time limit are
// sbatch's own variables (SBATCH_PARTITION, ...). CaseError when sbatch is missing or refuses.
void run_on_slurm(std::span<const Job> jobs, const std::filesystem::path& folder, int threads,
                  const StopToken& stop, const OnEvent& on_event);

// The last lines of what a job said, as one.
std::string last_words(const std::filesystem::path& log);

}  // namespace pmr::study
