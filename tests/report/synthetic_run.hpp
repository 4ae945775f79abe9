// A bed made up for the report's pictures, of any size: two species in a cylinder, with plausible
// places and temperatures. Courses and summaries are those of a run that was (real_run.hpp).
#pragma once
#include <cstddef>
#include <filesystem>

#include "report/run_data.hpp"

namespace pmr::report {

RunData synthetic_run(std::size_t particles, const std::string& name);

// Writes it as a run folder.
void write_folder(const RunData& run, const std::filesystem::path& folder);

}  // namespace pmr::report
