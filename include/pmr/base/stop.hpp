// A wish to stop, handed down by value to every stage that may take more than a few seconds. Who
// wishes (a signal, a test) is not known below.
#pragma once
#include <atomic>
#include <exception>

namespace pmr {

// Thrown where a stage is given up half-way; no error.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

class StopToken {
 public:
  StopToken() = default;  // never asked to stop
  // `wish` must live on. (std::stop_token cannot be asked from a signal handler.)
  StopToken(const std::atomic<bool>& wish) : wish_(&wish) {}

  bool is_set() const { return wish_ != nullptr && wish_->load(std::memory_order_relaxed); }
  void check() const {  // throws Stopped once the wish is there
    if (is_set()) throw Stopped();
  }

 private:
  const std::atomic<bool>* wish_ = nullptr;
};

}  // namespace pmr
