#include <fmt/format.h>

#include <cmath>

#include "io/atomic_file.hpp"
#include "io/hdf5.hpp"
#include "study/results.hpp"

namespace pmr::study {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

// The shortest text that reads back to the same number; empty where there is none.
std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string head(const std::string& name, const std::string& unit) {
  return field(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
}

std::string csv(const Study& study, const Plan& plan, const Results& results) {
  std::string text = "run,status,replicate";
  for (const Variable& v : study.variables) text += "," + head(v.name, v.unit);
  for (const Response& r : study.responses) text += "," + head(r.name, r.unit);
  text += ",reason\n";
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    const PlannedRun& run = plan.runs[k];
    const Row& row = results.rows[k];
    text += field(row.name) + "," + row.status + "," +
            (run.replicate ? std::to_string(*run.replicate) : std::string());
    for (std::size_t v = 0; v < study.variables.size(); ++v)
      text += "," + (study.variables[v].levels.empty()
                         ? csv_number(run.values[v])
                         : field(value_text(study.variables[v], run.values[v])));
    for (const double value : row.responses) text += "," + csv_number(value);
    text += "," + field(row.reason) + "\n";
  }
  return text;
}

void write_column(io::H5File& file, const std::string& path, const std::vector<double>& values,
                  const std::string& unit, const std::string& label) {
  file.write<double>(path, values,
                     {unit.empty() ? "1" : unit, io::Number::float64, io::Packing::checked});
  file.set_attribute(path, "label", label);
}

void write_hdf5(const Study& study, const Plan& plan, const Results& results, io::H5File& file) {
  io::set_format(file, "pmr-study", 1);
  file.set_attribute("/", "title", study.title);
  std::vector<std::string> names, states, reasons;
  for (const Row& row : results.rows) {
    names.push_back(row.name);
    states.push_back(row.status);
    reasons.push_back(row.reason);
  }
  file.write_texts("/run", names);
  file.write_texts("/status", states);
  file.write_texts("/reason", reasons);
  for (std::size_t v = 0; v < study.variables.size(); ++v) {
    std::vector<double> values;
    for (const PlannedRun& run : plan.runs) values.push_back(run.values[v]);
    const Variable& variable = study.variables[v];
    write_column(file, "/variables/" + variable.name, values, variable.unit, variable.label);
    std::vector<std::string> levels;
    for (const Level& level : variable.levels) levels.push_back(level.name);
    if (levels.empty()) continue;
    if (!file.has("/levels")) file.make_group("/levels");
    file.write_texts("/levels/" + variable.name, levels);
  }
  for (std::size_t r = 0; r < study.responses.size(); ++r) {
    std::vector<double> values;
    for (const Row& row : results.rows) values.push_back(row.responses[r]);
    const Response& response = study.responses[r];
    write_column(file, "/responses/" + response.name, values, response.unit, response.label);
  }
}

}  // namespace

void write_tables(const Study& study, const Plan& plan, const Results& results,
                  const std::filesystem::path& folder) {
  io::replace_text(folder / "study.csv", csv(study, plan, results));
  io::Replacement replacement(folder / "study.h5");
  io::H5File file = io::H5File::create(replacement.temporary());
  write_hdf5(study, plan, results, file);
  file.close();
  replacement.commit();
}

}  // namespace pmr::study
