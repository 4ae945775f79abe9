// A run that was: tests/sim/tiny.toml from its first particle to its page, made once a program.
#pragma once
#include <filesystem>
#include <string>

#include "report/run_data.hpp"

namespace pmr::report {

// Its folder, as `pmr run` leaves it, with a decomposition tool of two layers; it goes at the
// program's end.
const std::filesystem::path& real_folder();
RunData real_run(const std::string& name);

// The same particles moved alone, without heat and chemistry.
RunData moved_alone();

}  // namespace pmr::report
