// Wall time by stage, in order of first use.
#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace pmr {

class Stopwatch {
 public:
  double seconds() const {  // [s] since construction
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  double lap() {  // [s] since construction or the last lap
    const double passed = seconds();
    start_ = std::chrono::steady_clock::now();
    return passed;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Timings {
 public:
  void add(const std::string& stage, double seconds) {
    for (auto& [name, sum] : stages_)
      if (name == stage) {
        sum += seconds;
        return;
      }
    stages_.emplace_back(stage, seconds);
  }
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }  // [s]

 private:
  std::vector<std::pair<std::string, double>> stages_;
};

// Adds the life of the value to one stage.
class StageTimer {
 public:
  StageTimer(Timings& timings, std::string stage) : timings_(timings), stage_(std::move(stage)) {}
  ~StageTimer() { timings_.add(stage_, watch_.seconds()); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  Timings& timings_;
  std::string stage_;
  Stopwatch watch_;
};

}  // namespace pmr
