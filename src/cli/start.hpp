// From a case file, or the folder of a run, to the case with its particles.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pmr/state/case.hpp"
#include "sim/bed.hpp"

namespace pmr::cli {

struct Start {
  Case setup;
  std::optional<sim::Bed> bed;  // none: the case inserts its particles
};

// Reads a case and its bed; CaseError with all that is wrong with them or with the insertion.
Start read_start(const std::filesystem::path& case_file, const std::vector<std::string>& sets);

// "bed = ..." for `--set`, with the file's absolute name.
std::string bed_setting(const std::filesystem::path& bed);

// The case of a run, with the counts and sizes of the particles that it was opened with.
Case case_of_run(const std::filesystem::path& folder);

}  // namespace pmr::cli
