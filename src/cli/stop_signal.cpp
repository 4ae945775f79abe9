#include "cli/stop_signal.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string_view>

#include "cli/console.hpp"

namespace pmr::cli {
namespace {

std::atomic<bool> is_at_stake{false}, stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may write it");

void on_signal(int signal) {
  const bool asked_before = stop_wanted.exchange(true);
  if (signal == SIGPIPE) return;
  if (is_at_stake && !(signal == SIGINT && asked_before)) return;
  constexpr std::string_view words = "pmr: interrupted\n";
  [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, words.data(), words.size());
  ::_exit(interrupted);
}

}  // namespace

void end_on_signals() {
  ::signal(SIGXFSZ, SIG_IGN);  // the write fails instead
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;  // a file that is being written is written to its end
    ::sigaction(signal, &action, nullptr);
  }
}

AtStake::AtStake() { is_at_stake = true; }
AtStake::~AtStake() { is_at_stake = false; }
StopToken AtStake::token() const { return stop_wanted; }

}  // namespace pmr::cli
