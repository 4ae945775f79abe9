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

Row completed_row(const Study& study, const PlannedRun& run, const Value& summary) {
  Row row;
  row.name = run.name;
  row.status = "completed";
  for (const Response& r : study.responses)
    row.responses.push_back(r.factor * summary.number(r.key) + r.offset);
  for (const Value& warning : summary.items("warnings")) row.warnings.push_back(warning.as_text());
  return row;
}

Row row_without_result(const Study& study, const Plan& plan, const PlannedRun& run,
                       const Folder& folder) {
  Row row;
  row.name = run.name;
  row.responses.assign(study.responses.size(), std::numeric_limits<double>::quiet_NaN());
  row.reason = run.fault;
  const auto look = [&](const fs::path& run_folder) {
    const fs::path log = folder.root() / "logs" / (run_folder.filename().string() + ".log");
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

void warn_of_unknown(const Study& study, const std::vector<std::string>& keys, Results& results) {
  for (const Response& r : study.responses)
    if (std::find(keys.begin(), keys.end(), r.key) == keys.end())
      results.warnings.push_back(fmt::format(
          "responses.{}: {}", r.name, casefile::unknown_word("key of the summaries", r.key, keys)));
}

}  // namespace

Results collect(const Study& study, const Plan& plan, const Folder& folder) {
  Results results;
  std::vector<std::string> keys;
  for (const PlannedRun& run : plan.runs) {
    if (!run.fault.empty() || status_of(folder.run(run)) != "completed") {
      results.rows.push_back(row_without_result(study, plan, run, folder));
      continue;
    }
    const Value summary = summary_of(folder.run(run));
    if (keys.empty()) add_keys(summary, "", keys);
    results.rows.push_back(completed_row(study, run, summary));
  }
  if (!keys.empty()) warn_of_unknown(study, keys, results);
  return results;
}

}  // namespace pmr::study
