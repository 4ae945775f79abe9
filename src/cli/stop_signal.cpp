#include "cli/stop_signal.hpp"

#include <csignal>

namespace pmr::cli {
namespace {

std::atomic<bool> stop_wanted{false};

void on_signal(int signal) {
  stop_wanted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  return stop_wanted;
}

}  // namespace pmr::cli
