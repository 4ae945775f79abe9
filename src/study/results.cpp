#include "study/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/nearest.hpp"
#include "io/atomic_file.hpp"
#include "report/value.hpp"
#include "study/engine.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;
using report::Value;

Value summary_of(const fs::path& run) {
  return report::parse_json(io::read_text(run / "summary.json"));
}

// Every number of a summary by its path.
void add_keys(const Value& value, const std::string& path, std::vector<std::string>& keys) {
  if (const auto* members = std::get_if<Value::Object>(&value.data)) {
    for (const report::Member& m : *members)
      add_keys(m.value, path.empty() ? m.key : path + "/" + m.key, keys);
  } else if (const auto* items = std::get_if<Value::Array>(&value.data)) {
    for (std::size_t k = 0; k < items->size(); ++k)
      add_keys((*items)[k], path + "/" + std::to_string(k), keys);
  } else {
    keys.push_back(path);
  }
}

Row completed_row(std::span<const Response> responses, const PlannedRun& run,
                  const Value& summary) {
  Row row;
  row.name = run.name;
  row.status = "completed";
  for (const Response& r : responses)
    row.responses.push_back(r.factor * summary.number(r.key) + r.offset);
  for (const Value& warning : summary.items("warnings")) row.warnings.push_back(warning.as_text());
  return row;
}

Row row_without_result(std::size_t responses, const Plan& plan, const PlannedRun& run,
                       const Folder& folder) {
  Row row;
  row.name = run.name;
  row.responses.assign(responses, std::numeric_limits<double>::quiet_NaN());
  row.reason = run.fault;
  const auto look = [&](const fs::path& run_folder) {
    const fs::path log = folder.log_of(run_folder);
    if (row.reason.empty() && fs::exists(log) && status_of(run_folder) != "stopped")
      row.reason = last_words(log);
  };
  if (run.mixing && status_of(folder.mixing(plan.mixings[*run.mixing])) != "completed")
    look(folder.mixing(plan.mixings[*run.mixing]));
  else
    look(folder.run(run));
  row.status = row.reason.empty() ? "missing" : "failed";
  return row;
}

bool is_completed(const PlannedRun& run, const Folder& folder) {
  return run.fault.empty() && status_of(folder.run(run)) == "completed";
}

}  // namespace

std::vector<std::string> keys_of_summary(const fs::path& run) {
  std::vector<std::string> keys;
  add_keys(summary_of(run), "", keys);
  return keys;
}

Row row_of(std::span<const Response> responses, const Plan& plan, const PlannedRun& run,
           const Folder& folder) {
  return is_completed(run, folder) ? completed_row(responses, run, summary_of(folder.run(run)))
                                   : row_without_result(responses.size(), plan, run, folder);
}

Results collect(const Study& study, const Plan& plan, const Folder& folder) {
  Results results;
  for (const PlannedRun& run : plan.runs)
    results.rows.push_back(row_of(study.responses, plan, run, folder));
  const auto known = std::find_if(plan.runs.begin(), plan.runs.end(),
                                  [&](const PlannedRun& run) { return is_completed(run, folder); });
  if (known == plan.runs.end()) return results;
  const auto keys = keys_of_summary(folder.run(*known));
  for (const Response& r : study.responses)
    if (std::find(keys.begin(), keys.end(), r.key) == keys.end())
      results.warnings.push_back(fmt::format(
          "responses.{}: {}", r.name, casefile::unknown_word("key of the summaries", r.key, keys)));
  return results;
}

}  // namespace pmr::study
