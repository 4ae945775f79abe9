// summary.json: the figures of a run, for people, the report and other programs. SI units.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "coupling/nodes.hpp"
#include "io/run_file.hpp"
#include "pmr/base/timer.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

struct SummaryInput {
  const Case& setup;
  const State& state;
  const coupling::Nodes& nodes;
  const Timings& timings;
  const io::Series& series;                       // of the whole run
  double time_step;                               // [s]
  std::string status;                             // "completed", "stopped" or "failed"
  std::map<std::string, std::string> provenance;  // version, git, case_hash, threads, ...
};

void write_summary(const std::filesystem::path& dir, const SummaryInput& input);

// Limits of the models that the run touched, one sentence each.
std::vector<std::string> limits_touched(const Case& c, const State& state);

}  // namespace pmr::sim
