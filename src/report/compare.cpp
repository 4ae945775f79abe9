// Several runs on one page: figures with differences, courses overlaid, pictures on one scale.
#include "report/compare.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "pmr/base/errors.hpp"
#include "report/course.hpp"
#include "report/figures.hpp"
#include "report/mixture.hpp"
#include "report/report.hpp"

namespace pmr::report {
namespace {

using Figures = std::vector<std::vector<KeyFigure>>;  // by run

const KeyFigure* find(const std::vector<KeyFigure>& figures, const std::string& id) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const KeyFigure& f) { return f.id == id; });
  return found == figures.end() ? nullptr : &*found;
}

// Every figure that any run has, in the order in which they are first met.
std::vector<KeyFigure> union_of(const Figures& figures) {
  std::vector<KeyFigure> all;
  for (const auto& of_run : figures)
    for (const KeyFigure& f : of_run)
      if (find(all, f.id) == nullptr) all.push_back(f);
  return all;
}

std::vector<std::string> heads(const std::vector<RunData>& runs, const char* first) {
  std::vector<std::string> titles{first};
  for (const RunData& run : runs) titles.push_back(escape(run.name));
  for (std::size_t r = 1; r < runs.size(); ++r)
    titles.push_back(escape(runs[r].name) + " − " + escape(runs[0].name));
  return titles;
}

std::vector<std::string> compared(const std::string& label, Quantity quantity,
                                  const std::vector<double>& values, bool differences) {
  std::vector<std::string> row{label};
  for (const double value : values) row.push_back(with_unit(quantity, value));
  for (std::size_t r = 1; r < values.size(); ++r)
    row.push_back(differences ? difference(quantity, values[r] - values[0]) : "");
  return row;
}

std::string figure_table(const std::vector<RunData>& runs, const Figures& figures) {
  std::vector<std::vector<std::string>> rows;
  for (const KeyFigure& kind : union_of(figures)) {
    std::vector<double> values;
    for (const auto& of_run : figures) {
      const KeyFigure* figure = find(of_run, kind.id);
      values.push_back(figure == nullptr ? std::nan("") : figure->value);
    }
    rows.push_back(
        compared(escape(kind.label), kind.quantity, values, kind.quantity != Quantity::residual));
  }
  return table(heads(runs, "quantity"), rows, "class=\"numbers compare\"");
}

std::string against_first(const std::vector<RunData>& runs, const Figures& figures) {
  static const std::vector<std::string> told{
      "granule_highest", "peak", "granule_temperature", "oxygen", "top_ratio", "lacey", "settled"};
  std::string html;
  for (std::size_t r = 1; r < runs.size(); ++r) {
    std::vector<std::string> parts;
    for (const std::string& id : told) {
      const KeyFigure *a = find(figures[0], id), *b = find(figures[r], id);
      if (a == nullptr || b == nullptr) continue;
      parts.push_back(escape(b->label) + " <strong>" +
                      difference(b->quantity, b->value - a->value) + "</strong>");
    }
    if (!parts.empty())
      html += element("p",
                      "<strong>" + escape(runs[r].name) + "</strong> against <strong>" +
                          escape(runs[0].name) + "</strong>: " + join(parts, "; ") + ".",
                      "class=\"answer\"");
  }
  return html;
}

std::string attention(const std::vector<RunData>& runs, const Figures& figures) {
  std::string items;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::string name = "<strong>" + escape(runs[r].name) + "</strong>: ";
    for (const Value& w : runs[r].summary.items("warnings"))
      items += element("li", name + escape(w.as_text()));
    for (const KeyFigure& f : figures[r])
      if (is_worth_listing(f, runs[r]))
        items += element("li", name + escape(f.label) + " " + with_unit(f.quantity, f.value) +
                                   " (" + escape(f.note) + ")");
  }
  return items.empty()
             ? element("p", "No model range was left and no limit was touched.", "class=\"good\"")
             : element("ul", items, "class=\"warnings\"");
}

Section compared_answer(const std::vector<RunData>& runs) {
  Figures figures;
  for (const RunData& run : runs) figures.push_back(key_figures(run));
  std::string html;
  for (const RunData& run : runs)
    html += element("p", "<strong>" + escape(run.name) + "</strong>: " + join(answer(run), " "),
                    "class=\"answer\"");
  html += against_first(runs, figures) + figure_table(runs, figures);
  html += element("h3", "What limits trust in this") + attention(runs, figures);
  return {"answer", "Answer", html};
}

std::vector<const RunData*> pointers(const std::vector<RunData>& runs) {
  std::vector<const RunData*> all;
  for (const RunData& run : runs) all.push_back(&run);
  return all;
}

Section compared_books(const std::vector<RunData>& runs) {
  struct Path {
    const char* key;
    const char* label;
  };
  static constexpr Path paths[] = {
      {"radiation", "beads to granules by radiation"}, {"contact", "beads to granules by contacts"},
      {"gap", "beads to granules through gas gaps"},   {"to_walls", "particles to walls"},
      {"reaction", "taken up by the reaction"},        {"gas", "carried off with gas and oxygen"},
      {"to_surroundings", "radiated out of the rig"}};
  std::vector<std::vector<std::string>> rows;
  for (const Path& path : paths) {
    std::vector<double> heat;
    bool is_known = false;
    for (const RunData& run : runs) {
      heat.push_back(run.summary.number(std::string("heat_paths/") + path.key));
      is_known = is_known || std::isfinite(heat.back());
    }
    if (is_known) rows.push_back(compared(path.label, Quantity::energy, heat, true));
  }
  const std::string html = rows.empty()
                               ? absent("No heat paths: no heat transfer in these cases.")
                               : table(heads(runs, "heat"), rows, "class=\"numbers compare\"");
  return {"books", "Books", html};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

// Lines of one case that the other has not: enough to see what was varied.
std::string only_in(const RunData& run, const RunData& other) {
  const auto theirs = lines_of(other.header.case_text);
  const std::set<std::string> known(theirs.begin(), theirs.end());
  std::string text;
  for (const std::string& line : lines_of(run.header.case_text))
    if (known.count(line) == 0) text += line + "\n";
  return text;
}

Section compared_reproduction(const std::vector<RunData>& runs) {
  std::string html;
  for (std::size_t r = 1; r < runs.size(); ++r) {
    const std::string here = only_in(runs[r], runs[0]), there = only_in(runs[0], runs[r]);
    if (here.empty() && there.empty()) continue;
    html += element(
        "h3", "How the cases differ: " + escape(runs[r].name) + " and " + escape(runs[0].name));
    html += element("pre", element("del", escape(there)) + element("ins", escape(here)),
                    "class=\"case\"");
  }
  if (html.empty()) html = absent("The case texts are the same.");
  for (const RunData& run : runs)
    html += element("h3", escape(run.name)) + reproduction_section(run).html;
  return {"reproduction", "Reproduction", html};
}

}  // namespace

std::string comparison_page(const std::vector<RunData>& runs) {
  ensure(runs.size() >= 2, "a comparison has at least two runs");
  Charts charts;
  std::vector<std::string> names;
  for (const RunData& run : runs) names.push_back(run.name);
  std::vector<Section> sections{compared_answer(runs), compared_pictures(runs)};
  sections.push_back(mixture_section(pointers(runs), charts));
  sections.push_back({"course", "Course", course_charts(pointers(runs), charts)});
  sections.push_back(compared_books(runs));
  sections.push_back(compared_reproduction(runs));
  return assemble("Comparison: " + join(names, ", "),
                  "Differences are taken against " + names.front() + ".", sections, charts);
}

}  // namespace pmr::report
