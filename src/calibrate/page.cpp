#include "calibrate/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/page_parts.hpp"
#include "io/atomic_file.hpp"
#include "report/compare.hpp"
#include "report/text.hpp"
#include "statistics/band.hpp"
#include "study/page_parts.hpp"

namespace pmr::calibrate {
namespace {

namespace fs = std::filesystem;
using report::element;
using report::escape;

constexpr double z95 = 1.96;

std::string scrolled(const std::vector<std::string>& head,
                     const std::vector<std::vector<std::string>>& rows) {
  return element("div", report::table(head, rows, "class=\"numbers compare\""), "class=\"scroll\"");
}

std::vector<std::string> found_row(const std::string& label, const std::string& unit, double value,
                                   double sd, const std::optional<double>& reference,
                                   const std::string& stage) {
  const bool is_known = reference.has_value();
  return {escape(study::axis_title(label, unit)),
          shown(value),
          shown(sd, 2),
          shown(value - z95 * sd, 3) + " to " + shown(value + z95 * sd, 3),
          is_known ? shown(*reference) : "",
          is_known ? shown((value - *reference) / sd, 2) : "",
          stage};
}

std::string found_table(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  std::size_t k = 0;
  for (const StageResult& result : f.found.stages) {
    const Stage& stage = f.lab.stages[result.stage];
    for (const Parameter& p : stage.parameters) {
      if (result.modes.empty()) continue;
      rows.push_back(found_row(
          p.label, p.unit, f.found.found.values[k], std::sqrt(f.found.found.covariance[k][k]),
          p.reference, element("a", escape(stage.name), "href=\"#" + anchor(stage) + "\"")));
      ++k;
    }
  }
  for (std::size_t d = 0; d < f.found.derived.size(); ++d) {
    if (!std::isfinite(f.found.derived[d].value)) continue;
    rows.push_back(found_row(f.lab.derived[d].label, f.lab.derived[d].unit,
                             f.found.derived[d].value, f.found.derived[d].deviation,
                             f.lab.derived[d].reference, "derived"));
  }
  if (rows.empty()) return report::absent("Nothing was found.");
  return scrolled({"parameter", "found", "standard deviation", "95 %, if normal", "reference",
                   "off by, in deviations", "stage"},
                  rows);
}

std::string run_cell(const Findings& f, const Outcome& o) {
  const fs::path page = fs::path("runs") / o.name / "report.html";
  return fs::exists(f.folder / page)
             ? element("a", escape(o.name), "href=\"" + escape(page.string()) + "\"")
             : escape(o.name);
}

}  // namespace

std::string shown(double value, int digits) {
  return std::isfinite(value) ? report::significant(value, digits) : "–";
}

std::string with_error(double value, double error, const std::string& unit) {
  return shown(value) + " ± " + shown(error, 2) +
         (unit.empty() ? "" : " " + escape(study::unit_shown(unit)));
}

std::string anchor(const Stage& stage) { return "stage-" + study::safe_name(stage.name); }

report::Section answer_part(const Findings& f) {
  std::string warnings;
  for (const std::string& warning : f.found.warnings) warnings += element("li", escape(warning));
  return {"answer", "What was found",
          found_table(f) +
              (warnings.empty() ? element("p", "No warnings.")
                                : element("h3", "What to beware of") + element("ul", warnings)) +
              element("p",
                      "The same in <a href=\"contacts.toml\">contacts.toml</a>, which a case or a "
                      "study takes as it is, and in <a href=\"calibration.json\">"
                      "calibration.json</a>. Deviations hold measurement, surrogate, the floor "
                      "given to each test, small samples and other stages.",
                      "class=\"caption\"")};
}

report::Section predicted_part(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  for (const Predicted& p : f.found.predicted) {
    const Target& target = f.lab.target(p.target);
    const auto band = statistics::band(p.values);
    rows.push_back({escape(f.lab.tests[p.target.test].label), escape(target.response.label),
                    with_error(target.value, target.error, target.response.unit), shown(band.mean),
                    shown(band.deviation, 2), shown(band.mean - target.value, 3),
                    shown(100.0 * (band.mean / target.value - 1.0), 2) + " %"});
  }
  if (rows.empty())
    return {"predicted", "Predicted and measured",
            report::absent("The tests were not run at the parameters found.")};
  return {"predicted", "Predicted and measured",
          scrolled({"test", "response", "measured", "at the parameters found", "seeds differ by",
                    "difference", "of the measured"},
                   rows)};
}

report::Section picture_part(const Findings& f) {
  std::vector<report::RunData> shots;
  for (const Predicted& p : f.found.predicted) {
    const fs::path run = f.folder / "runs" / p.run;
    if (p.target.target != 0 || p.run.empty() || !fs::exists(run / "run.h5")) continue;
    shots.push_back(report::read_run(run));
    shots.back().name = f.lab.tests[p.target.test].label;
  }
  if (shots.empty())
    return {"pictures", "Pictures", report::absent("No run at the parameters found is at hand.")};
  report::Section section = report::compared_pictures(shots);
  section.title = "The tests at the parameters found";
  return section;
}

report::Section runs_part(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  for (const Outcome& o : f.runs.all()) {
    std::string values;
    for (std::size_t r = 0; r < o.responses.size(); ++r) {
      const study::Response& response = f.lab.tests[o.test].targets[r].response;
      values += (r == 0 ? "" : ", ") + escape(response.label) + " " + shown(o.responses[r]) +
                (response.unit.empty() ? "" : " " + escape(study::unit_shown(response.unit)));
    }
    rows.push_back({run_cell(f, o), values,
                    escape(o.reason.empty() ? o.status : o.status + ": " + o.reason) +
                        (o.is_known ? ", made before" : "")});
  }
  return {"runs", "Runs",
          scrolled({"run", "results", "status"}, rows) +
              element("p", "The same as <a href=\"runs.csv\">runs.csv</a>.", "class=\"caption\"")};
}

report::Section reproduction_part(const Findings& f) {
  return {"reproduction", "Reproduction",
          element("p",
                  "The lab file as it was carried out, in this folder as lab.toml; the whole case "
                  "of each run stands in cases/.") +
              element("pre", escape(f.lab.text), "class=\"case\"")};
}

void write_page(const Lab& lab, const Calibration& c, const Runs& runs,
                const std::filesystem::path& folder) {
  const Findings f{lab, c, runs, folder};
  report::Charts charts;
  std::vector<report::Section> sections{answer_part(f)};
  for (const StageResult& result : c.stages) sections.push_back(stage_part(f, result, charts));
  sections.push_back(predicted_part(f));
  sections.push_back(trust_part(f, charts));
  sections.push_back(picture_part(f));
  sections.push_back(runs_part(f));
  sections.push_back(reproduction_part(f));
  io::replace_text(folder / "report.html",
                   report::assemble("Calibration: " + lab.title, lab.teaches, sections, charts));
}

}  // namespace pmr::calibrate
