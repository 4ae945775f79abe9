#include "calibrate/run_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/csv_text.hpp"
#include "io/atomic_file.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/text.hpp"

namespace pmr::calibrate {
namespace {

constexpr const char* heading = "run,case,status,response,value,reason";
constexpr std::size_t columns = 6;

// Cells hold no commas, so that any reader of CSV, and a person with grep, can take them apart.
std::string cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '"' || c == '\n'; }, ' ');
  return text;
}

}  // namespace

void write_run_table(const std::filesystem::path& file, const std::vector<TableRow>& rows) {
  std::string text = std::string(heading) + "\n";
  for (const TableRow& row : rows)
    text += fmt::format(
        "{},{},{},{},{},{}\n", cell(row.run), row.case_hash, row.status, cell(row.response),
        std::isfinite(row.value) ? fmt::format("{}", row.value) : "", cell(row.reason));
  io::replace_text(file, text);
}

std::vector<TableRow> read_run_table(const std::filesystem::path& file) {
  const auto lines = casefile::csv_lines(file);
  if (!lines) throw CaseError({{file.string(), "", "cannot be read; wanted a table of runs"}});
  if (lines->empty() || lines->front().text != heading)
    throw CaseError({{file.string(), "", std::string("wanted the heading ") + heading}});
  std::vector<TableRow> rows;
  std::vector<Fault> faults;
  for (std::size_t k = 1; k < lines->size(); ++k) {
    const auto cells = casefile::cells_of((*lines)[k].text);
    const auto fault = [&](const std::string& problem) {
      faults.push_back({fmt::format("{}:{}", file.string(), (*lines)[k].number), "", problem});
    };
    if (cells.size() != columns) {
      fault(fmt::format("wanted {} cells", columns));
      continue;
    }
    const auto value = finite_number(cells[4]);
    if (!value && !cells[4].empty()) fault("'" + cells[4] + "' is no number");
    if (cells[2] != "completed" && cells[2] != "failed") fault("wanted completed or failed");
    rows.push_back({cells[0], cells[1], cells[2], cells[3], value.value_or(nan), cells[5]});
  }
  if (!faults.empty()) throw CaseError(std::move(faults));
  return rows;
}

}  // namespace pmr::calibrate
