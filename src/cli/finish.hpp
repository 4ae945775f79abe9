// What stands in a run folder when a run ends: summary, instruments, report, a last word.
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "sim/simulation.hpp"

namespace pmr::cli {

struct RunRecord {
  std::filesystem::path folder;
  std::map<std::string, std::string> provenance;
};

// Completed or stopped: writes everything, prints the headline; returns the exit status, `failed`
// when the books do not close.
int finish_run(const sim::Simulation& simulation, const RunRecord& record, sim::Ending ending);

// Failed: says so in summary.json and on the terminal, and how to see it again.
int finish_failed(const sim::Simulation& simulation, const RunRecord& record,
                  const std::string& why);

}  // namespace pmr::cli
