#include "case/csv_text.hpp"

#include <charconv>
#include <cmath>

namespace pmr::casefile {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
    comma = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
  }
  return cells;
}

std::optional<double> finite_number(const std::string& cell) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const bool is_whole_cell = error == std::errc{} && end == cell.data() + cell.size();
  return is_whole_cell && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

Heading heading_of(const std::string& cell) {
  const std::size_t bracket = cell.find('['), end = cell.find(']');
  Heading heading{trimmed(cell.substr(0, bracket)), std::nullopt};
  if (bracket != std::string::npos && end != std::string::npos && end > bracket)
    heading.unit = cell.substr(bracket + 1, end - bracket - 1);
  return heading;
}

}  // namespace pmr::casefile
