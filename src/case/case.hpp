// Case files: TOML with units in, pmr::Case in SI out, or all faults at once.
#pragma once
#include <filesystem>
#include <set>
#include <span>
#include <string>

#include "pmr/state/case.hpp"

namespace pmr::casefile {

// Reads a case file. Each of `sets` is "dotted.key=TOMLVALUE" and is applied before anything is
// checked. Throws CaseError with every fault: file:line:column, dotted key, what was wanted.
Case load_case(const std::filesystem::path& file, std::span<const std::string> sets = {});

// Reads a case from its text; `name` stands for the file in messages, relative file names start
// from `base_dir`. Case::text of a loaded case, given here, yields the same case again.
Case load_case_text(const std::string& text, const std::string& name,
                    const std::filesystem::path& base_dir = {},
                    std::span<const std::string> sets = {});

// Paths of the keys that the reader asks for in a case, given or not ("walls.tube.radius"),
// whatever the case's faults.
std::set<std::string> keys_asked_for(const std::string& text);

}  // namespace pmr::casefile
