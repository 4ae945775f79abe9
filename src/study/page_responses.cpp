// Responses over the variables, with the surrogate's curve, and how far to trust that.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/colour_map.hpp"
#include "report/text.hpp"
#include "study/page_parts.hpp"

namespace pmr::study {
namespace {

using report::element;
using report::escape;
using report::Value;

constexpr std::size_t curve_points = 41;

Value axis_of_variable(const Findings& f, std::size_t v) {
  const Variable& variable = f.study.variables[v];
  Value axis;
  axis.set("label", variable.label);
  axis.set("unit", unit_shown(variable.unit));
  if (!variable.levels.empty()) {
    Value::Array names;
    for (const Level& level : variable.levels) names.emplace_back(level.name);
    axis.set("levels", std::move(names));
  }
  if (is_on_log_axis(f, v)) axis.set("scale", "log");
  return axis;
}

Value axis_of_response(const Response& r) {
  Value axis;
  axis.set("label", r.label);
  axis.set("unit", r.unit.empty() ? "1" : r.unit);
  return axis;
}

Value point_of(const Findings& f, std::size_t row, double x, double y) {
  Value point;
  point.set("x", x);
  point.set("y", y);
  point.set("label", run_title(f, row));
  point.set("link", run_link(f, row));
  return point;
}

// The surrogate with its band of two deviations; over several variables its mean over the others.
Value curve_of(const Findings& f, const Fit& fit, std::size_t place) {
  const auto xs = abscissae(f, fit, place, curve_points);
  std::vector<double> y, low, high;
  for (const double x : xs) {
    const auto at = fit.surrogate.main_effect(place, x);
    y.push_back(at.mean);
    low.push_back(at.mean - 2.0 * at.deviation);
    high.push_back(at.mean + 2.0 * at.deviation);
  }
  Value curve;
  curve.set("x", xs);
  curve.set("y", y);
  curve.set("low", low);
  curve.set("high", high);
  return curve;
}

std::string chart(const Findings& f, report::Charts& charts, std::size_t r, std::size_t place) {
  if (!has_values(f, r))
    return place == 0 ? report::absent(f.study.responses[r].label + ": no run has this figure.")
                      : "";
  const std::size_t v = f.numeric[place];
  const Response& response = f.study.responses[r];
  const Value axis = axis_of_variable(f, v);
  Value::Array series;
  for (std::size_t g = 0; g < f.groups.size(); ++g) {
    Value one;
    Value::Array points;
    for (const std::size_t row : f.groups[g].rows)
      points.push_back(
          point_of(f, row, f.plan.runs[row].values[v], f.results.rows[row].responses[r]));
    one.set("label", f.groups[g].name);
    one.set("colour", report::hex(report::species_colour(g)));
    one.set("points", std::move(points));
    const Fit* fit = fit_of(f, r, g);
    if (fit != nullptr && fit->surrogate.basis().why_constant.empty())
      one.set("curve", curve_of(f, *fit, place));
    series.push_back(std::move(one));
  }
  Value spec;
  spec.set("kind", "scatter");
  spec.set("x", axis);
  spec.set("y", axis_of_response(response));
  spec.set("series", std::move(series));
  return charts.add(fmt::format("response-{}-{}", response.name, f.study.variables[v].name),
                    response.label + " over " + f.study.variables[v].label, std::move(spec));
}

// Where only names are varied: the runs above their level.
std::string level_chart(const Findings& f, report::Charts& charts, std::size_t r, std::size_t v) {
  const Response& response = f.study.responses[r];
  Value one;
  Value::Array points;
  for (std::size_t row = 0; row < f.plan.runs.size(); ++row)
    points.push_back(
        point_of(f, row, f.plan.runs[row].values[v], f.results.rows[row].responses[r]));
  one.set("colour", report::hex(report::species_colour(0)));
  one.set("points", std::move(points));
  Value spec;
  spec.set("kind", "scatter");
  spec.set("x", axis_of_variable(f, v));
  spec.set("y", axis_of_response(response));
  spec.set("series", Value::Array{one});
  return charts.add(fmt::format("levels-{}-{}", response.name, f.study.variables[v].name),
                    response.label + " over " + f.study.variables[v].label, std::move(spec));
}

std::string shown(double value, int digits) {
  return std::isfinite(value) ? report::significant(value, digits) : "–";
}

// What a reader should do with the curve, from its cross-validation.
std::string verdict(const statistics::Basis& basis, const statistics::Validation& validation) {
  if (!basis.why_constant.empty()) return "no curve: " + basis.why_constant;
  if (!(validation.q2 > 0.5)) return "do not read between the points: noise, or a bend they miss";
  return validation.q2 > 0.9 ? "trust it between the points"
                             : "its trend holds, its values by the band";
}

std::string effects_table(const Findings& f) {
  if (f.numeric.size() < 2) return "";
  std::vector<std::string> head{"response"};
  for (const std::size_t v : f.numeric) head.push_back(escape(f.study.variables[v].label));
  head.emplace_back("strongest pair");
  std::vector<std::vector<std::string>> rows;
  for (const Fit& fit : f.fits) {
    if (!fit.surrogate.basis().why_constant.empty()) continue;
    const auto effects = fit.surrogate.effects();
    std::vector<std::string> row{
        escape(f.study.responses[fit.response].label +
               (f.groups[fit.group].name.empty() ? "" : ", " + f.groups[fit.group].name))};
    for (std::size_t k = 0; k < f.numeric.size(); ++k)
      row.push_back(fmt::format("{:.2f} / {:.2f}", effects.first[k], effects.total[k]));
    std::size_t a = 0, b = 1;
    for (std::size_t i = 0; i < f.numeric.size(); ++i)
      for (std::size_t j = i + 1; j < f.numeric.size(); ++j)
        if (effects.pair[i][j] > effects.pair[a][b]) a = i, b = j;
    row.push_back(
        effects.pair[a][b] < 0.01
            ? "none above 0.01"
            : fmt::format("{} with {}: {:.2f}", escape(f.study.variables[f.numeric[a]].label),
                          escape(f.study.variables[f.numeric[b]].label), effects.pair[a][b]));
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return "";
  return element("h3", "Effects and interactions") +
         element("p",
                 "Sobol’ indices of the surrogate over the box of the variables: the share of the "
                 "response’s variance that a variable explains alone / with all its interactions.",
                 "class=\"caption\"") +
         element("div", report::table(head, rows, "class=\"numbers compare\""), "class=\"scroll\"");
}

}  // namespace

report::Section response_part(const Findings& f, report::Charts& charts) {
  std::string html;
  for (std::size_t r = 0; r < f.study.responses.size(); ++r) {
    for (std::size_t place = 0; place < f.numeric.size(); ++place)
      html += chart(f, charts, r, place);
    for (std::size_t v = 0; v < f.study.variables.size(); ++v)
      if (f.numeric.empty() && !f.study.variables[v].levels.empty())
        html += level_chart(f, charts, r, v);
  }
  if (html.empty()) html = report::absent("No variable takes more than one value.");
  const std::string how =
      f.numeric.size() > 1
          ? "Each point is a run. Lines are the surrogate’s mean over the other variables, bands "
            "two of its deviations."
          : "Each point is a run; points above one another are replicates with other seeds. Lines "
            "are the surrogate (Kriging) with a band of two deviations.";
  return {"responses", "Responses",
          element("p", how, "class=\"caption\"") + element("div", html, "class=\"charts\"")};
}

report::Section trust_part(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  for (const Fit& fit : f.fits) {
    const auto& basis = fit.surrogate.basis();
    const auto validation = fit.surrogate.validate();
    std::string label = f.study.responses[fit.response].label;
    if (!f.groups[fit.group].name.empty()) label += ", " + f.groups[fit.group].name;
    rows.push_back({escape(axis_title(label, f.study.responses[fit.response].unit)),
                    std::to_string(basis.points.size()), shown(basis.noise, 2),
                    shown(validation.q2, 2), shown(validation.rmse, 2),
                    shown(validation.mean_standardised_square, 2), verdict(basis, validation)});
  }
  if (rows.empty())
    return {"trust", "Surrogates", report::absent("No surrogate: no variable is a number.")};
  const std::string how =
      "Each design point is left out once and predicted from the others (with the same lengths of "
      "correlation). Q² is 1 for a perfect prediction and 0 for one no better than the mean; the "
      "mean square of error over predicted deviation should be near 1. Replicates are runs that "
      "differ in their seed alone: their standard deviation is what no curve can explain.";
  return {"trust", "Where to trust the curves",
          element("p", how, "class=\"caption\"") +
              element("div",
                      report::table({"response", "points", "replicates differ by", "Q²",
                                     "error left out", "error² / deviation²", "verdict"},
                                    rows, "class=\"numbers compare trust\""),
                      "class=\"scroll\"") +
              effects_table(f)};
}

}  // namespace pmr::study
