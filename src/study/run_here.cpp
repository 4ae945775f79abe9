#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>
#include <vector>

#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"
#include "pmr/base/timer.hpp"
#include "study/engine.hpp"

namespace pmr::study {
namespace {

constexpr int exit_interrupted = 130, exit_not_started = 127;

// In the child: dies with its parent, stands outside the terminal's process group, says all into
// its log.
[[noreturn]] void become(const std::vector<char*>& words, int log, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(exit_not_started);
  ::setpgid(0, 0);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execv(words.front(), words.data());
  ::_exit(exit_not_started);
}

pid_t start(const Job& job) {
  std::vector<std::string> text = job.command;
  std::vector<char*> words;
  words.reserve(text.size() + 1);
  for (std::string& word : text) words.push_back(word.data());
  words.push_back(nullptr);
  const int log = ::open(job.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0)
    throw StorageError(job.log.string() + ": cannot be written: " + std::strerror(errno));
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become(words, log, parent);
  ::close(log);
  if (child < 0) throw NumericsError("no process can be started for " + job.name);
  return child;
}

enum class Stage { waiting, running, ended_well, ended_ill };
struct Process {
  Stage stage = Stage::waiting;
  pid_t pid = 0;
  Stopwatch clock;
};

JobState state_of(int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return JobState::done;
  if (WIFEXITED(status) && WEXITSTATUS(status) == exit_interrupted) return JobState::interrupted;
  return JobState::failed;
}

std::string reason_of(const Job& job, int status) {
  if (WIFSIGNALED(status)) return "ended by signal " + std::to_string(WTERMSIG(status));
  return last_words(job.log);
}

class Pool {
 public:
  Pool(std::span<const Job> jobs, std::size_t at_once, const OnEvent& on_event)
      : jobs_(jobs), at_once_(at_once), on_event_(on_event), processes_(jobs.size()) {}

  void run(const StopToken& stop) {
    bool asked = false;
    while (true) {
      reap();
      if (stop.is_set() && !asked) {
        ask_all_to_stop();
        asked = true;
      }
      if (!stop.is_set()) start_what_can();
      if (running_ == 0 && (stop.is_set() || !any_waiting())) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

 private:
  bool any_waiting() const {
    for (const Process& p : processes_)
      if (p.stage == Stage::waiting) return true;
    return false;
  }

  void start_what_can() {
    for (std::size_t k = 0; k < jobs_.size() && running_ < at_once_; ++k) {
      Process& p = processes_[k];
      if (p.stage != Stage::waiting) continue;
      const Stage before = jobs_[k].after ? processes_[*jobs_[k].after].stage : Stage::ended_well;
      if (before == Stage::ended_ill) {
        p.stage = Stage::ended_ill;
        on_event_({jobs_[k], JobState::skipped, "its " + jobs_[*jobs_[k].after].name + " failed"});
      }
      if (before != Stage::ended_well) continue;
      p = {Stage::running, start(jobs_[k]), {}};
      ++running_;
      on_event_({jobs_[k], JobState::started, ""});
    }
  }

  void reap() {
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      Process& p = processes_[k];
      int status = 0;
      if (p.stage != Stage::running || ::waitpid(p.pid, &status, WNOHANG) != p.pid) continue;
      --running_;
      const JobState state = state_of(status);
      p.stage = state == JobState::done ? Stage::ended_well : Stage::ended_ill;
      std::error_code ignored;  // a log without a result would pass for a failure
      if (state == JobState::interrupted) std::filesystem::remove(jobs_[k].log, ignored);
      const std::string reason = state == JobState::failed ? reason_of(jobs_[k], status) : "";
      on_event_({jobs_[k], state, reason, p.clock.seconds()});
    }
  }

  void ask_all_to_stop() const {
    for (const Process& p : processes_)
      if (p.stage == Stage::running) ::kill(p.pid, SIGTERM);
  }

  std::span<const Job> jobs_;
  std::size_t at_once_;
  const OnEvent& on_event_;
  std::vector<Process> processes_;
  std::size_t running_ = 0;
};

}  // namespace

void run_here(std::span<const Job> jobs, std::size_t at_once, const StopToken& stop,
              const OnEvent& on_event) {
  Pool(jobs, at_once, on_event).run(stop);
}

std::string last_words(const std::filesystem::path& log) {
  std::ifstream in(log);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  constexpr std::size_t kept = 4;
  std::string words;
  for (std::size_t k = lines.size() > kept ? lines.size() - kept : 0; k < lines.size(); ++k)
    words += (words.empty() ? "" : " | ") + lines[k];
  return words.empty() ? "it said nothing" : words;
}

}  // namespace pmr::study
