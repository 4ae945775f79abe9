// The runs of a study or a calibration: how many at once, where, and what is said of them.
#pragma once
#include <string>
#include <vector>

#include "cli/verbs.hpp"
#include "study/folder.hpp"

namespace pmr::cli {

std::string this_program();

struct Share {
  std::size_t at_once;
  int threads;  // [1] of each run
  double cores() const { return static_cast<double>(at_once) * threads; }
};
Share share_of(const JobOptions& options);

// "12 min", "3.5 h" of seconds.
std::string duration_text(double seconds);

// Whether it was stopped.
bool carry_out(const std::vector<study::Job>& jobs, const study::Folder& folder,
               const JobOptions& options, const Share& share);

}  // namespace pmr::cli
