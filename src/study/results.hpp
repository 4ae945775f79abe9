// What the runs of a study came to: one row a run.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "study/folder.hpp"

namespace pmr::study {

struct Row {
  std::string name;
  std::string status;                 // "completed", "failed" or "missing"
  std::string reason;                 // of a failure
  std::vector<double> responses;      // as shown, in their units; NaN where there is none
  std::vector<std::string> warnings;  // of the run's summary
};

struct Results {
  std::vector<Row> rows;              // in the order of the plan
  std::vector<std::string> warnings;  // of the study: responses that no summary knows
};

// What came of one run; of one without a result, why.
Row row_of(std::span<const Response> responses, const Plan& plan, const PlannedRun& run,
           const Folder& folder);

// Every figure of a run's summary by its path.
std::vector<std::string> keys_of_summary(const std::filesystem::path& run);

// Reads the summaries.
Results collect(const Study& study, const Plan& plan, const Folder& folder);

// study.csv and study.h5: run, status, values of the variables, responses; the same bits whenever
// the runs are the same.
void write_tables(const Study& study, const Plan& plan, const Results& results,
                  const std::filesystem::path& folder);

}  // namespace pmr::study
