// The bare bones of CSV: lines, their cells without the blanks round them, headings.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pmr::casefile {

// A line that holds something: neither empty nor a comment (#).
struct CsvLine {
  unsigned number;  // [1] from 1
  std::string text;
};
// None if the file cannot be read.
std::optional<std::vector<CsvLine>> csv_lines(const std::filesystem::path& file);

std::vector<std::string> cells_of(const std::string& line);  // split at commas, trimmed

// "x [mm]": the name, and what stands in the brackets; no unit without brackets at the end.
struct Heading {
  std::string name;
  std::optional<std::string> unit;
};
Heading heading_of(const std::string& cell);

}  // namespace pmr::casefile
