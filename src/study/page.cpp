#include "study/page.hpp"

#include <algorithm>
#include <cmath>

#include "io/atomic_file.hpp"
#include "study/page_parts.hpp"

namespace pmr::study {

namespace {

constexpr std::size_t most_in_title = 3;  // [1] variables; a run of more goes by its number

}  // namespace

std::string unit_shown(const std::string& unit) { return unit == "degC" ? "°C" : unit; }

std::string axis_title(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " [" + unit_shown(unit) + "]";
}

std::array<double, 2> ends_of(const Findings& f, std::size_t v) {
  double low = f.plan.runs.front().values[v], high = low;
  for (const PlannedRun& run : f.plan.runs) {
    low = std::min(low, run.values[v]);
    high = std::max(high, run.values[v]);
  }
  return {low, high};
}

bool is_on_log_axis(const Findings& f, std::size_t v) {
  const auto [low, high] = ends_of(f, v);
  return low > 0.0 && (f.study.variables[v].is_logarithmic || high > 20.0 * low);
}

std::vector<double> abscissae(const Findings& f, const Fit& fit, std::size_t place,
                              std::size_t count) {
  const auto [low, high] = fit.ends[place];
  const bool is_logarithmic = is_on_log_axis(f, f.numeric[place]);
  std::vector<double> xs;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(count - 1);
    xs.push_back(is_logarithmic ? low * std::pow(high / low, part) : low + part * (high - low));
  }
  return xs;
}

const Fit* fit_of(const Findings& f, std::size_t response, std::size_t group) {
  for (const Fit& fit : f.fits)
    if (fit.response == response && fit.group == group) return &fit;
  return nullptr;
}

bool has_values(const Findings& f, std::size_t response) {
  return std::any_of(f.results.rows.begin(), f.results.rows.end(),
                     [&](const Row& row) { return std::isfinite(row.responses[response]); });
}

std::string run_link(const Findings& f, std::size_t row) {
  const bool stands = f.results.rows[row].status == "completed";
  return stands ? "runs/" + f.results.rows[row].name + "/report.html" : "";
}

std::string run_title(const Findings& f, std::size_t row) {
  const PlannedRun& run = f.plan.runs[row];
  if (f.study.variables.size() > most_in_title) return "run " + std::to_string(row + 1);
  std::string title;
  for (std::size_t v = 0; v < f.study.variables.size(); ++v) {
    Variable shown = f.study.variables[v];
    shown.unit = unit_shown(shown.unit);
    title += (v == 0 ? "" : ", ") + shown.label + " " + value_text(shown, run.values[v]);
  }
  if (run.replicate) title += ", seed " + std::to_string(*run.replicate);
  return title;
}

void write_page(const Study& study, const Plan& plan, const Results& results,
                const Folder& folder) {
  Findings f{
      study, plan, results, folder, numeric_variables(study, plan), groups_of(study, plan, results),
      {}};
  f.fits = fit_all(study, plan, results, f.groups);
  report::Charts charts;
  std::vector<report::Section> sections{answer_part(f)};
  if (is_sampled(study)) sections.push_back(ranking_part(f, charts));
  sections.push_back(response_part(f, charts));
  sections.push_back(trust_part(f));
  if (study.trade_off) sections.push_back(trade_off_part(f, charts));
  sections.push_back(picture_part(f));
  sections.push_back(runs_part(f));
  sections.push_back(reproduction_part(f));
  io::replace_text(folder.root() / "report.html",
                   report::assemble("Study: " + study.title, study.teaches, sections, charts));
}

}  // namespace pmr::study
