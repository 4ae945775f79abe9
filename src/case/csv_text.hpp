// The bare bones of CSV: cells of a line without the spaces round them.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace pmr::casefile {

std::string trimmed(const std::string& text);
std::vector<std::string> cells_of(const std::string& line);  // split at commas, trimmed

// The cell as a finite number; none if it is anything else.
std::optional<double> finite_number(const std::string& cell);

// "x [mm]": the name, and what stands in the brackets; no unit without brackets.
struct Heading {
  std::string name;
  std::optional<std::string> unit;
};
Heading heading_of(const std::string& cell);

}  // namespace pmr::casefile
