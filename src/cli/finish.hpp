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

// Completed or stopped: writes everything (no report of a run that was stopped: whoever stops it
// does not want to wait), prints the headline; returns the exit status, `failed` when the books do
// not close.
int finish_run(const sim::Simulation& simulation, const RunRecord& record, sim::Ending ending);

// Failed: says so in summary.json and on the terminal, and how to see it again.
int finish_failed(const sim::Simulation& simulation, const RunRecord& record,
                  const std::string& why);

// The disk failed: says so, and how to go on from what was saved last.
int finish_unsaved(const std::filesystem::path& folder, const std::string& why);

}  // namespace pmr::cli
