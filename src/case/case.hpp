// Case files: TOML with units in, pmr::Case in SI out, or all faults at once.
#pragma once
#include <filesystem>
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

// The case's text (Case::text) without all that moves no particle: titles, temperatures, heat, gas,
// chemistry, instruments. Cases of equal mechanical text and equal particles mix the same bed.
std::string mechanical_text(const std::string& case_text);

}  // namespace pmr::casefile
