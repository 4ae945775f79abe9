// The answer, the trade-off, pictures of the extremes, every run, and how to repeat the study.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "io/atomic_file.hpp"
#include "report/colour_map.hpp"
#include "report/compare.hpp"
#include "report/text.hpp"
#include "study/page_parts.hpp"

namespace pmr::study {
namespace {

using report::element;
using report::escape;
using report::Value;

std::string shown_value(double value) {
  return std::isfinite(value) ? report::significant(value, 4) : "–";
}

std::string title_cell(const Findings& f, std::size_t row) {
  const std::string link = run_link(f, row), title = escape(run_title(f, row));
  return link.empty() ? title : element("a", title, "href=\"" + escape(link) + "\"");
}

// Rows with the lowest and the highest value of a response; none without results.
std::optional<std::pair<std::size_t, std::size_t>> extremes(const Results& results, std::size_t r) {
  std::optional<std::pair<std::size_t, std::size_t>> ends;
  for (std::size_t k = 0; k < results.rows.size(); ++k) {
    const double value = results.rows[k].responses[r];
    if (!std::isfinite(value)) continue;
    if (!ends) ends = {k, k};
    if (value < results.rows[ends->first].responses[r]) ends->first = k;
    if (value > results.rows[ends->second].responses[r]) ends->second = k;
  }
  return ends;
}

std::string extremes_table(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t r = 0; r < f.study.responses.size(); ++r) {
    const auto ends = extremes(f.results, r);
    if (!ends) continue;
    const Response& response = f.study.responses[r];
    rows.push_back(
        {escape(axis_title(response.label, response.unit)),
         shown_value(f.results.rows[ends->first].responses[r]), title_cell(f, ends->first),
         shown_value(f.results.rows[ends->second].responses[r]), title_cell(f, ends->second)});
  }
  if (rows.empty()) return report::absent("No run is completed yet.");
  return element("div",
                 report::table({"response", "lowest", "in the run", "highest", "in the run"}, rows),
                 "class=\"scroll\"");
}

// A warning with its figures masked: runs differ in them alone.
std::string masked(const std::string& warning) {
  std::string mask;
  for (const char c : warning) {
    const bool is_figure = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.';
    if (!is_figure)
      mask += c;
    else if (mask.empty() || mask.back() != '#')
      mask += '#';
  }
  return mask;
}

struct Warned {
  std::string mask, first;
  std::size_t runs = 0;
  bool differs = false;  // other runs have other figures in it
};

// Warnings of the study, and those of the runs, each once.
std::string warnings_of(const Findings& f) {
  std::vector<Warned> all;
  for (const Row& row : f.results.rows)
    for (const std::string& warning : row.warnings) {
      const std::string mask = masked(warning);
      auto known = all.begin();
      while (known != all.end() && known->mask != mask) ++known;
      if (known == all.end()) known = all.insert(all.end(), {mask, warning});
      ++known->runs;
      known->differs = known->differs || known->first != warning;
    }
  std::string items;
  for (const std::string& warning : f.results.warnings) items += element("li", escape(warning));
  for (const Warned& w : all)
    items += element("li",
                     escape(w.first) + fmt::format(" ({} run{}{})", w.runs, w.runs == 1 ? "" : "s",
                                                   w.differs ? ", each with its own figures" : ""));
  return items.empty() ? "" : element("ul", items, "class=\"warnings\"");
}

std::size_t count_of(const Results& results, const char* status) {
  return static_cast<std::size_t>(
      std::count_if(results.rows.begin(), results.rows.end(),
                    [&](const Row& row) { return row.status == status; }));
}

}  // namespace

report::Section answer_part(const Findings& f) {
  const std::size_t failed = count_of(f.results, "failed"),
                    missing = count_of(f.results, "missing");
  std::string html =
      element("p",
              fmt::format("{} of {} runs are completed{}{}; {} mixing{} of particles served them.",
                          count_of(f.results, "completed"), f.plan.runs.size(),
                          failed > 0 ? fmt::format(", {} failed", failed) : "",
                          missing > 0 ? fmt::format(", {} are still to come", missing) : "",
                          f.plan.mixings.size(), f.plan.mixings.size() == 1 ? "" : "s"),
              "class=\"answer\"");
  return {"answer", "Answer", html + trends(f) + extremes_table(f) + warnings_of(f)};
}

report::Section trade_off_part(const Findings& f, report::Charts& charts) {
  const std::size_t gain = response_index(f.study, f.study.trade_off->gain);
  const std::size_t cost = response_index(f.study, f.study.trade_off->cost);
  const auto front = pareto_front(f.results, gain, cost);
  const auto is_best = [&](std::size_t k) {
    return std::find(front.begin(), front.end(), k) != front.end();
  };
  Value::Array others, best;
  for (std::size_t k = 0; k < f.results.rows.size(); ++k) {
    const double x = f.results.rows[k].responses[cost], y = f.results.rows[k].responses[gain];
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    Value point;
    point.set("x", x);
    point.set("y", y);
    point.set("label", run_title(f, k));
    point.set("link", run_link(f, k));
    point.set("strong", is_best(k));
    (is_best(k) ? best : others).push_back(std::move(point));
  }
  if (best.empty()) return {"trade-off", "Trade-off", report::absent("No run has both figures.")};
  const auto axis = [&](std::size_t r) {
    Value a;
    a.set("label", f.study.responses[r].label);
    a.set("unit", f.study.responses[r].unit.empty() ? "1" : f.study.responses[r].unit);
    return a;
  };
  Value dominated, frontier, spec, x = axis(cost);
  x.set("padded", true);
  dominated.set("label", "beaten in both by another run");
  dominated.set("colour", "#8d97a5");
  dominated.set("points", std::move(others));
  frontier.set("label", "best: more gain only at more cost");
  frontier.set("colour", report::hex(report::species_colour(1)));
  frontier.set("points", std::move(best));
  spec.set("kind", "scatter");
  spec.set("x", std::move(x));
  spec.set("y", axis(gain));
  spec.set("series", Value::Array{dominated, frontier});
  std::vector<std::vector<std::string>> rows;
  rows.reserve(front.size());
  for (const std::size_t k : front)
    rows.push_back({title_cell(f, k), shown_value(f.results.rows[k].responses[gain]),
                    shown_value(f.results.rows[k].responses[cost])});
  return {
      "trade-off", "Trade-off and best designs",
      charts.add("trade-off",
                 f.study.responses[gain].label + " against " + f.study.responses[cost].label,
                 std::move(spec), "Up and to the left is better.") +
          element(
              "div",
              report::table(
                  {"best designs",
                   escape(axis_title(f.study.responses[gain].label, f.study.responses[gain].unit)),
                   escape(axis_title(f.study.responses[cost].label, f.study.responses[cost].unit))},
                  rows, "class=\"numbers compare\""),
              "class=\"scroll\"")};
}

report::Section picture_part(const Findings& f) {
  const std::size_t r = f.study.trade_off ? response_index(f.study, f.study.trade_off->gain) : 0;
  const auto ends = extremes(f.results, r);
  if (!ends) return {"pictures", "Pictures", report::absent("No pictures: no run is completed.")};
  std::vector<report::RunData> runs;
  for (const std::size_t k : {ends->first, ends->second}) {
    if (!runs.empty() && ends->first == ends->second) break;
    runs.push_back(report::read_run(f.folder.run(f.plan.runs[k])));
    runs.back().name = (runs.size() == 1 ? "lowest: " : "highest: ") + run_title(f, k);
  }
  report::Section section = report::compared_pictures(runs);
  section.title = "Beds at the extremes of: " + f.study.responses[r].label;
  return section;
}

report::Section runs_part(const Findings& f) {
  std::vector<std::string> head{"run"};
  const bool goes_by_number = !f.results.rows.empty() && run_title(f, 0) == "run 1";
  for (const std::size_t v : f.numeric)
    if (goes_by_number)
      head.push_back(escape(axis_title(f.study.variables[v].label, f.study.variables[v].unit)));
  for (const Response& r : f.study.responses) head.push_back(escape(axis_title(r.label, r.unit)));
  head.emplace_back("status");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < f.results.rows.size(); ++k) {
    const Row& row = f.results.rows[k];
    std::vector<std::string> cells{title_cell(f, k)};
    for (const std::size_t v : f.numeric)
      if (goes_by_number) cells.push_back(shown_value(f.plan.runs[k].values[v]));
    for (const double value : row.responses) cells.push_back(shown_value(value));
    cells.push_back(escape(row.reason.empty() ? row.status : row.status + ": " + row.reason));
    rows.push_back(std::move(cells));
  }
  return {
      "runs", "Runs",
      element("div", report::table(head, rows, "class=\"numbers compare\""), "class=\"scroll\"") +
          element("p",
                  "The same as <a href=\"study.csv\">study.csv</a> and study.h5, with all "
                  "digits.",
                  "class=\"caption\"")};
}

report::Section reproduction_part(const Findings& f) {
  return {
      "reproduction", "Reproduction",
      element("p",
              "The study’s file as it was run, in this folder as study.toml; the whole "
              "case of each run stands in cases/, its own report in runs/.") +
          element("pre", escape(io::read_text(f.folder.root() / "study.toml")), "class=\"case\"")};
}

}  // namespace pmr::study
