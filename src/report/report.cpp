#include "report/report.hpp"

#include <cmath>

#include "case/reference.hpp"
#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"
#include "report/mixture.hpp"
#include "report/page.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

std::string title_of(const RunData& run) {
  const std::string title = run.setup ? run.setup->title : run.summary.text("case/title");
  return title.empty() ? run.name : title;
}

std::string description_of(const RunData& run) {
  std::string text = run.setup ? run.setup->description : run.summary.text("case/description");
  if (!text.empty()) return text;
  return title_of(run) == run.name ? "" : run.name;
}

RunData read_as_wished(const std::filesystem::path& folder, const ReportWishes& wishes) {
  RunData run = read_run(folder);
  run.frame_times = wishes.frame_times;
  if (wishes.reference.empty()) return run;
  if (!run.setup)
    throw CaseError({{folder.string(), "",
                      "its case cannot be read again, so that no reference "
                      "can be set beside it"}});
  casefile::set_reference(*run.setup, wishes.reference, folder.string());
  return run;
}

}  // namespace

std::string report_page(const RunData& run) {
  Charts charts;
  std::vector<Section> sections{answer_section(run), picture_section(run)};
  if (has_bulk_tests(run)) sections.push_back(bulk_tests_section(run, charts));
  sections.push_back(mixture_section({&run}, charts));
  sections.push_back(course_section(run, charts));
  if (run.summary.has("effective_conductivity"))
    sections.push_back(conductivity_section(run, charts));
  sections.push_back(books_section(run, charts));
  sections.push_back(reproduction_section(run));
  return assemble(title_of(run), description_of(run), sections, charts);
}

void write_report(const std::vector<std::filesystem::path>& runs, const std::filesystem::path& html,
                  const ReportWishes& wishes) {
  ensure(!runs.empty(), "a report is written of at least one run");
  std::vector<RunData> data;
  for (const auto& folder : runs) data.push_back(read_as_wished(folder, wishes));
  io::replace_text(html, data.size() == 1 ? report_page(data.front()) : comparison_page(data));
}

}  // namespace pmr::report
