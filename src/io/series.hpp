// Series as comma-separated values.
#pragma once
#include <filesystem>

#include "io/run_file.hpp"

namespace pmr::io {

// First line "name [unit]" per column, then a line a row; shortest digits that give back the same
// double; "nan" and "inf" where a value is not finite. Replaced atomically.
void write_csv(const std::filesystem::path& path, const Series& series);

}  // namespace pmr::io
