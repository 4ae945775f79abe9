// Section 1: the answer first, then what limits trust in it.
#include <cmath>

#include "report/figures.hpp"
#include "report/page.hpp"

namespace pmr::report {
namespace {

const char* class_of(Verdict verdict) {
  if (verdict == Verdict::good) return "figure good";
  return verdict == Verdict::attention ? "figure attention" : "figure";
}

const char* badge(Verdict verdict) {
  if (verdict == Verdict::good) return "<b class=\"badge\">ok</b>";
  return verdict == Verdict::attention ? "<b class=\"badge\">attention</b>" : "";
}

std::string card(const KeyFigure& figure) {
  const Shown shown = show(figure.quantity, figure.value);
  std::string html = element("span", escape(figure.label), "class=\"label\"");
  html += element("span", shown.number + " " + element("small", shown.unit), "class=\"value\"");
  html += element("span", badge(figure.verdict) + escape(figure.note), "class=\"note\"");
  return element("div", html, std::string("class=\"") + class_of(figure.verdict) + "\"");
}

std::string cards(const std::vector<KeyFigure>& figures) {
  std::string html;
  for (std::size_t k = 0; k < figures.size() && k < 6; ++k) html += card(figures[k]);
  return element("div", html, "class=\"figures\"");
}

std::string more_figures(const std::vector<KeyFigure>& figures) {
  if (figures.size() <= 6) return "";
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 6; k < figures.size(); ++k)
    rows.push_back({escape(figures[k].label), with_unit(figures[k].quantity, figures[k].value),
                    badge(figures[k].verdict) + escape(figures[k].note)});
  return element("details",
                 element("summary", "More figures of this run") +
                     table({"quantity", "value", "band or limit"}, rows, "class=\"numbers\""));
}

std::string warnings(const RunData& run, const std::vector<KeyFigure>& figures) {
  std::string items;
  for (const Value& w : run.summary.items("warnings")) items += element("li", escape(w.as_text()));
  for (const KeyFigure& f : figures)
    if (is_worth_listing(f, run))
      items += element("li", escape(f.label) + ": " + with_unit(f.quantity, f.value) + " (" +
                                 escape(f.note) + ")");
  if (items.empty() && !run.summary.has("warnings"))
    return absent("The summary of this run records no warnings, nor that there were none.");
  if (items.empty())
    return element("p", "No model range was left and no limit was touched.", "class=\"good\"");
  return element("ul", items, "class=\"warnings\"");
}

std::string assumed(const RunData& run) {
  const auto& inputs = run.summary.items("assumed");
  if (inputs.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  for (const Value& input : inputs)
    rows.push_back({"<code>" + escape(input.text("key")) + "</code>", escape(input.text("value")),
                    escape(input.text("source"))});
  const std::string inputs_table =
      table({"input", "value", "why this value"}, rows, "class=\"assumed\"");
  const std::string title = std::to_string(rows.size()) + " assumed inputs that matter";
  if (rows.size() <= 6) return element("h4", title) + inputs_table;
  return element("details", element("summary", title) + inputs_table);
}

}  // namespace

Section answer_section(const RunData& run) {
  const std::vector<KeyFigure> figures = key_figures(run);
  std::string html;
  for (const std::string& sentence : answer(run))
    html += element("p", sentence, "class=\"answer\"");
  html += cards(figures) + more_figures(figures);
  html += element("h3", "What limits trust in this") + warnings(run, figures) + assumed(run);
  return {"answer", "Answer", html};
}

}  // namespace pmr::report
