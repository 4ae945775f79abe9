// Ctrl-C as a wish to stop.
#pragma once
#include <atomic>

namespace pmr::cli {

// True once SIGINT or SIGTERM came: a checkpoint is wanted. A second one ends the process.
const std::atomic<bool>& stop_on_signals();

}  // namespace pmr::cli
