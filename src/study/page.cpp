#include "study/page.hpp"

#include <fstream>

#include "io/atomic_file.hpp"
#include "study/page_parts.hpp"

namespace pmr::study {

std::string axis_title(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " [" + unit + "]";
}

std::string run_link(const Findings& f, std::size_t row) {
  const bool stands = f.results.rows[row].status == "completed";
  return stands ? "runs/" + f.results.rows[row].name + "/report.html" : "";
}

std::string run_title(const Findings& f, std::size_t row) {
  const PlannedRun& run = f.plan.runs[row];
  std::string title;
  for (std::size_t v = 0; v < f.study.variables.size(); ++v)
    title += (v == 0 ? "" : ", ") + f.study.variables[v].label + " " +
             value_text(f.study.variables[v], run.values[v]);
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
