#include "validate/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/atomic_file.hpp"
#include "report/colour_map.hpp"
#include "report/page.hpp"
#include "report/text.hpp"
#include "study/page_parts.hpp"

namespace pmr::validate {
namespace {

using report::element;
using report::escape;
using report::Value;

std::string figure(double value, int digits = 4) {
  return std::isfinite(value) ? report::significant(value, digits) : "–";
}

std::string rows_table(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows) {
  return element("div", report::table(head, rows, "class=\"numbers compare\""), "class=\"scroll\"");
}

// "1.5 to 3 K": what the points are known to.
std::string deviation_text(const Comparison& c, const std::string& unit) {
  double low = c.points.front().deviation, high = low;
  for (const ComparedPoint& p : c.points) {
    low = std::min(low, p.deviation);
    high = std::max(high, p.deviation);
  }
  const std::string span =
      figure(low, 2) + (figure(low, 2) == figure(high, 2) ? "" : " to " + figure(high, 2));
  return unit.empty() ? span : span + " " + escape(unit);
}

std::string link_to(const Experiment& e, const std::string& quantity) {
  return element("a", escape(e.title), "href=\"#" + e.name + "\"") + ": " + escape(quantity);
}

std::string verdict_cell(Verdict verdict) {
  return verdict == Verdict::missed ? element("b", "missed") : word_of(verdict);
}

std::vector<std::string> row_of(const Experiment& e, const Comparison& c) {
  const Quantity& q = e.quantities[c.quantity];
  const std::string unit = escape(unit_of_miss(q));
  const auto with_unit = [&](double value) {
    return figure(value, 2) + (unit.empty() ? "" : " " + unit);
  };
  if (c.verdict == Verdict::not_run)
    return {link_to(e, q.label),
            word_of(c.verdict),
            std::to_string(c.points.size()),
            deviation_text(c, unit_of_miss(q)),
            "",
            "",
            "",
            "",
            escape(bar_text(q))};
  return {link_to(e, q.label),
          verdict_cell(c.verdict),
          std::to_string(c.judged),
          deviation_text(c, unit_of_miss(q)),
          q.has_free_zero ? "free" : with_unit(c.mean),
          with_unit(c.rms),
          with_unit(c.largest),
          figure(c.rms_in_deviations, 2),
          escape(bar_text(q))};
}

std::vector<std::string> row_of(const Experiment& e, const SlopeFound& found) {
  const Slope& s = e.slopes[found.slope];
  const double miss = found.value - s.measured;
  return {link_to(e, s.label),
          verdict_cell(found.verdict),
          "1",
          figure(s.deviation, 2),
          figure(miss, 2),
          "",
          "",
          figure(std::abs(miss) / std::hypot(s.deviation, found.error), 2),
          fmt::format("{} ± {}", s.measured, s.bar)};
}

report::Section answer(std::span<const Experiment> experiments, const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  std::size_t held = 0, judged = 0;
  const auto count = [&](Verdict verdict) {
    held += verdict == Verdict::held ? 1 : 0;
    judged += verdict == Verdict::held || verdict == Verdict::missed ? 1 : 0;
  };
  for (std::size_t k = 0; k < experiments.size(); ++k) {
    for (const Comparison& c : f.comparisons)
      if (c.experiment == k && c.variant == 0) {
        rows.push_back(row_of(experiments[k], c));
        count(c.verdict);
      }
    for (const SlopeFound& s : f.slopes)
      if (s.experiment == k && s.variant == 0) {
        rows.push_back(row_of(experiments[k], s));
        count(s.verdict);
      }
  }
  std::string html = element(
      "p", fmt::format("{} of {} bars are held. A miss stands with its cause below; no parameter "
                       "was fitted to pass.",
                       held, judged));
  html += rows_table({"experiment", "verdict", "points", "measured to", "mean miss", "rms",
                      "largest", "in deviations", "bar"},
                     rows);
  html += element("p",
                  "A miss is computed less measured. Deviation: of the measurement and of the "
                  "seeds’ mean together; near 1 the program agrees as well as the measurement can "
                  "tell.",
                  "class=\"caption\"");
  for (const std::string& failure : f.failures)
    html += element("p", "Failed: " + escape(failure), "class=\"warning\"");
  return {"answer", "Computed against measured", html};
}

std::string group_name(const Experiment& e, double value) {
  const Column& column = e.points.columns[*e.group];
  return fmt::format("{} {} {}", column.name, figure(value), study::unit_shown(column.unit));
}

// Values of the grouping column in the order of the points; one of nothing where there is none.
std::vector<double> groups_of(const Experiment& e) {
  std::vector<double> groups;
  if (!e.group) return {0.0};
  for (const double value : e.points.columns[*e.group].values)
    if (std::find(groups.begin(), groups.end(), value) == groups.end()) groups.push_back(value);
  return groups;
}

std::vector<ComparedPoint> points_in(const Experiment& e, const Comparison& c, double group) {
  std::vector<ComparedPoint> points;
  for (const ComparedPoint& p : c.points)
    if (!e.group || e.points.columns[*e.group].values[p.row] == group) points.push_back(p);
  std::stable_sort(points.begin(), points.end(),
                   [](const ComparedPoint& a, const ComparedPoint& b) { return a.x < b.x; });
  return points;
}

// The measured ones as dots with their bars of two deviations.
Value measured_series(const std::string& label, const std::string& colour,
                      const std::vector<ComparedPoint>& points) {
  Value::Array dots;
  for (const ComparedPoint& p : points) {
    Value dot;
    dot.set("x", p.x);
    dot.set("y", p.measured);
    dot.set("low", p.measured - 2.0 * p.deviation);
    dot.set("high", p.measured + 2.0 * p.deviation);
    dot.set("label", "measured");
    dots.push_back(std::move(dot));
  }
  Value one;
  one.set("label", label);
  one.set("colour", colour);
  one.set("points", std::move(dots));
  return one;
}

Value computed_series(const std::string& label, const std::string& colour, const char* dash,
                      const std::vector<ComparedPoint>& points) {
  std::vector<double> x, y, low, high;
  for (const ComparedPoint& p : points) {
    if (!std::isfinite(p.computed)) continue;
    x.push_back(p.x);
    y.push_back(p.computed);
    low.push_back(p.computed - 2.0 * p.error);
    high.push_back(p.computed + 2.0 * p.error);
  }
  Value curve, one;
  curve.set("x", x);
  curve.set("y", y);
  curve.set("low", low);
  curve.set("high", high);
  if (!label.empty()) one.set("label", label);
  one.set("colour", colour);
  if (dash != nullptr) one.set("dash", dash);
  one.set("curve", std::move(curve));
  return one;
}

constexpr const char* ink = "#1d2430";
constexpr std::array<const char*, 4> dashes{nullptr, "6 4", "2 3", "8 3 2 3"};

std::string chart_of(const Experiment& e, const Findings& f, std::size_t k, std::size_t q,
                     report::Charts& charts) {
  Value::Array series;
  const auto groups = groups_of(e);
  for (const Comparison& c : f.comparisons) {
    if (c.experiment != k || c.quantity != q) continue;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto points = points_in(e, c, groups[g]);
      const std::string line = report::hex(report::species_colour(e.group ? g : c.variant));
      const std::string name = e.group ? group_name(e, groups[g]) : "measured";
      const bool is_named = g == 0 && (e.variants.size() > 1 || !e.group);
      if (c.variant == 0) series.push_back(measured_series(name, e.group ? line : ink, points));
      series.push_back(computed_series(is_named ? e.variants[c.variant].label : "", line,
                                       dashes[c.variant % dashes.size()], points));
    }
  }
  const Quantity& quantity = e.quantities[q];
  Value x, y, spec;
  x.set("label", e.axis.label);
  x.set("unit", e.axis.unit.empty() ? "1" : study::unit_shown(e.axis.unit));
  if (e.axis.is_logarithmic) x.set("scale", "log");
  y.set("label", quantity.label);
  y.set("unit", quantity.unit.empty() ? "1" : study::unit_shown(quantity.unit));
  spec.set("kind", "scatter");
  spec.set("x", std::move(x));
  spec.set("y", std::move(y));
  spec.set("series", std::move(series));
  return charts.add(e.name + "-" + quantity.name, quantity.label, std::move(spec),
                    "Dots are measured, their bars two deviations; lines are computed, their bands "
                    "two standard errors of the seeds’ mean.");
}

std::string points_table(const Experiment& e, const Findings& f, std::size_t k, std::size_t q) {
  const Quantity& quantity = e.quantities[q];
  std::vector<std::string> head;
  for (const Column& column : e.points.columns)
    head.push_back(escape(study::axis_title(column.name, column.unit)));
  head.insert(head.end(), {escape(study::axis_title("measured", quantity.unit)), "±"});
  std::vector<std::vector<std::string>> rows(e.points.rows);
  for (const Comparison& c : f.comparisons) {
    if (c.experiment != k || c.quantity != q) continue;
    head.insert(head.end(), {escape(e.variants[c.variant].label), "miss", "in deviations"});
    for (const ComparedPoint& p : c.points) {
      auto& row = rows[p.row];
      if (c.variant == 0) {
        for (const Column& column : e.points.columns) row.push_back(figure(column.values[p.row]));
        row.insert(row.end(), {figure(p.measured), figure(p.deviation, 2)});
      }
      const bool is_run = std::isfinite(p.computed);
      row.insert(
          row.end(),
          {figure(p.computed), is_run ? figure(p.miss(), 2) : "–",
           is_run ? figure(p.miss_in_deviations(), 2) + (p.is_judged ? "" : " (shown)") : "–"});
    }
  }
  return element("details", element("summary", "Point by point") + rows_table(head, rows));
}

// What the first variant's misses are put down to, and what other variants come to.
std::string words_on(const Experiment& e, const Findings& f, std::size_t k, std::size_t q) {
  const Quantity& quantity = e.quantities[q];
  std::string html;
  for (const Comparison& c : f.comparisons) {
    if (c.experiment != k || c.quantity != q || c.verdict == Verdict::not_run) continue;
    const std::string unit = quantity.unit.empty() ? "" : " " + unit_of_miss(quantity);
    const std::string zero =
        quantity.has_free_zero
            ? fmt::format(" The measured zero stands at {}{}.", figure(c.zero), unit)
            : "";
    html += element(
        "p",
        escape(fmt::format("{}: mean miss {}{}, rms {}{}, largest {}{} of {} points; {}.{}",
                           e.variants[c.variant].label, figure(c.mean, 2), unit, figure(c.rms, 2),
                           unit, figure(c.largest, 2), unit, c.judged, word_of(c.verdict), zero)));
    if (c.variant == 0 && c.verdict == Verdict::missed)
      html += element(
          "p", element("b", "On the miss. ") +
                   escape(quantity.on_miss.empty() ? "No cause is known yet." : quantity.on_miss));
  }
  return html;
}

std::string slope_words(const Experiment& e, const Findings& f, std::size_t k) {
  std::string html;
  for (const SlopeFound& found : f.slopes) {
    if (found.experiment != k || found.verdict == Verdict::not_run) continue;
    const Slope& s = e.slopes[found.slope];
    html += element("p", escape(fmt::format("{} ({}): {} ± {} computed, {} ± {} measured; {}.",
                                            s.label, e.variants[found.variant].label,
                                            figure(found.value, 3), figure(found.error, 2),
                                            s.measured, s.deviation, word_of(found.verdict))));
    if (found.variant == 0 && found.verdict == Verdict::missed)
      html += element("p", element("b", "On the miss. ") +
                               escape(s.on_miss.empty() ? "No cause is known yet." : s.on_miss));
  }
  return html;
}

report::Section section_of(std::span<const Experiment> experiments, const ValidationPlan& plan,
                           const Findings& f, std::size_t k, report::Charts& charts) {
  const Experiment& e = experiments[k];
  std::string html = element("p", escape(e.teaches));
  html += element("p", "Measured: " + escape(e.source), "class=\"caption\"");
  for (std::size_t q = 0; q < e.quantities.size(); ++q) {
    if (e.points.rows > 1) html += element("div", chart_of(e, f, k, q, charts), "class=\"charts\"");
    html += words_on(e, f, k, q) + points_table(e, f, k, q);
  }
  html += slope_words(e, f, k);
  const study::PlannedRun& first = plan.plan.runs[plan.places[k].front().front().front()];
  html += element("p", "A run of it: " + element("a", escape(first.name),
                                                 "href=\"runs/" + first.name + "/report.html\""));
  return {e.name, e.title, html};
}

}  // namespace

void write_page(std::span<const Experiment> experiments, const ValidationPlan& plan,
                const Findings& findings, const study::Folder& folder) {
  report::Charts charts;
  std::vector<report::Section> sections{answer(experiments, findings)};
  for (std::size_t k = 0; k < experiments.size(); ++k)
    sections.push_back(section_of(experiments, plan, findings, k, charts));
  io::replace_text(folder.root() / "report.html",
                   report::assemble("Validation",
                                    "Experiments that others made, and what the "
                                    "program foretells of them.",
                                    sections, charts));
}

}  // namespace pmr::validate
