// Measured points: a table with a unit in each heading.
#include <fmt/format.h>

#include "case/csv_text.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/text.hpp"
#include "study/file_parts.hpp"
#include "validate/experiment.hpp"

namespace pmr::validate {
namespace {

std::vector<Column> columns_of(const std::string& head, const std::string& place,
                               std::vector<Fault>& faults) {
  std::vector<Column> columns;
  for (const std::string& cell : casefile::cells_of(head)) {
    const casefile::Heading heading = casefile::heading_of(cell);
    if (!heading.unit)
      faults.push_back({place, cell, "wanted a heading with its unit such as 'pressure [bar]'"});
    if (!study::is_name(heading.name))
      faults.push_back(
          {place, cell, "cannot stand in an expression; wanted letters, digits and _"});
    columns.push_back({heading.name, heading.unit.value_or(""), {}});
  }
  return columns;
}

}  // namespace

Points read_points(const std::filesystem::path& file) {
  const auto lines = casefile::csv_lines(file);
  if (!lines || lines->empty())
    throw CaseError({{file.string(), "", "cannot be read; wanted a table of measured points"}});
  const auto place = [&](const casefile::CsvLine& line) {
    return fmt::format("{}:{}", file.string(), line.number);
  };
  std::vector<Fault> faults;
  Points points;
  points.columns = columns_of(lines->front().text, place(lines->front()), faults);
  for (std::size_t k = 1; k < lines->size(); ++k) {
    const casefile::CsvLine& line = (*lines)[k];
    const auto cells = casefile::cells_of(line.text);
    if (cells.size() != points.columns.size()) {
      faults.push_back(
          {place(line), "",
           fmt::format("has {} cells; wanted {}", cells.size(), points.columns.size())});
      continue;
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto value = finite_number(cells[c]);
      if (!value)
        faults.push_back({place(line), points.columns[c].name, "'" + cells[c] + "' is no number"});
      points.columns[c].values.push_back(value.value_or(0.0));
    }
    ++points.rows;
  }
  if (points.rows == 0) faults.push_back({file.string(), "", "wanted at least one point"});
  if (!faults.empty()) throw CaseError(std::move(faults));
  return points;
}

}  // namespace pmr::validate
