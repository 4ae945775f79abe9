#include "case/csv_text.hpp"

#include <fstream>

#include "pmr/base/text.hpp"

namespace pmr::casefile {

std::optional<std::vector<CsvLine>> csv_lines(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) return std::nullopt;
  skip_byte_order_mark(in);
  std::vector<CsvLine> lines;
  unsigned number = 0;
  for (std::string text; next_line(in, text);) {
    ++number;
    if (!trimmed(text).empty() && text.front() != '#') lines.push_back({number, text});
  }
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
    comma = line.find(',', begin);
    cells.emplace_back(trimmed(std::string_view(line).substr(begin, comma - begin)));
  }
  return cells;
}

Heading heading_of(const std::string& cell) {
  const std::size_t bracket = cell.find('[');
  if (bracket == std::string::npos || cell.back() != ']') return {cell, std::nullopt};
  return {std::string(trimmed(std::string_view(cell).substr(0, bracket))),
          cell.substr(bracket + 1, cell.size() - bracket - 2)};
}

}  // namespace pmr::casefile
