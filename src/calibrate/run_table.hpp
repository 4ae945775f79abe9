// runs.csv: what came of every run of a calibration, a line to each response; from it a calibration
// goes on without the runs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace pmr::calibrate {

struct TableRow {
  std::string run;        // name
  std::string case_hash;  // of what was simulated, 16 hexadecimal digits; "" where there is no case
  std::string status;     // "completed" or "failed"
  std::string response;
  double value;  // in the response's unit; NaN, an empty cell: none
  std::string reason;
};

void write_run_table(const std::filesystem::path& file, const std::vector<TableRow>& rows);

// CaseError with all faults and their lines.
std::vector<TableRow> read_run_table(const std::filesystem::path& file);

}  // namespace pmr::calibrate
