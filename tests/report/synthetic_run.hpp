// A run made up for the report's tests: two species, a bed in a cylinder, plausible courses. No
// physics: only its shape matters.
#pragma once
#include <cstddef>
#include <filesystem>

#include "report/run_data.hpp"

namespace pmr::report {

RunData synthetic_run(std::size_t particles, const std::string& name);

// The same run without heat, chemistry and bed tool: mechanics alone.
RunData mechanics_only(RunData run);

// Writes it as a run folder.
void write_folder(const RunData& run, const std::filesystem::path& folder);

}  // namespace pmr::report
