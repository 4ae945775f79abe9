// A stage on the page: its responses over its parameters, where their levels meet, and what was
// chosen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/choice.hpp"
#include "calibrate/page_parts.hpp"
#include "report/colour_map.hpp"
#include "report/text.hpp"
#include "statistics/crossing.hpp"
#include "study/page_parts.hpp"

namespace pmr::calibrate {
namespace {

using report::element;
using report::escape;
using report::Value;
using statistics::Grid;

constexpr std::size_t shown_steps = 49;    // [1] of a drawn field
constexpr std::size_t line_steps = 81;     // [1] of drawn lines
constexpr std::size_t region_steps = 161;  // [1] of drawn regions
constexpr std::size_t curve_points = 81;

// The first two parameters of a stage, the third at the point found.
struct Plane {
  const Stage& stage;
  std::vector<double> rest;  // of the point found

  std::vector<double> point(std::span<const double> two) const {
    std::vector<double> at = rest;
    std::copy(two.begin(), two.end(), at.begin());
    return at;
  }
  Grid grid(std::size_t steps) const {
    return Grid({stage.parameters[0].box, stage.parameters[1].box}, steps);
  }
};

Value axis_of(const Parameter& p) {
  Value axis;
  axis.set("label", p.label);
  axis.set("unit", p.unit.empty() ? "1" : study::unit_shown(p.unit));
  axis.set("domain", std::vector<double>{p.box.low, p.box.high});
  if (p.box.is_logarithmic) axis.set("scale", "log");
  return axis;
}

Value line_of(const std::vector<statistics::Segment>& segments, const std::string& colour,
              const std::string& label, const std::string& dash, double width) {
  std::vector<double> flat;
  for (const statistics::Segment& s : segments)
    flat.insert(flat.end(), {s.from[0], s.from[1], s.to[0], s.to[1]});
  Value line;
  line.set("segments", flat);
  line.set("colour", colour);
  line.set("label", label);
  line.set("width", width);
  if (!dash.empty()) line.set("dash", dash);
  return line;
}

statistics::Field field_on(const Plane& plane, const Level& level, std::size_t steps) {
  return statistics::field_of(plane.grid(steps), [&](std::span<const double> two) {
    return level.fit.surrogate.predict(plane.point(two));
  });
}

// The measured level, and a deviation to either side.
void add_band(const Plane& plane, const Level& level, const std::string& colour,
              const std::string& label, Value::Array& lines) {
  const auto field = field_on(plane, level, line_steps);
  const Grid grid = plane.grid(line_steps);
  const auto at = [&](double side) {
    return statistics::level_line(grid, field.mean,
                                  level.measured.level + side * level.measured.deviation);
  };
  lines.push_back(line_of(at(0.0), colour, label, "", 2.2));
  for (const double side : {-1.0, 1.0}) lines.push_back(line_of(at(side), colour, "", "4 3", 1.0));
}

Value::Array dots(const StageResult& result) {
  Value::Array points;
  for (const auto& at : result.points) {
    Value p;
    p.set("x", at[0]);
    p.set("y", at[1]);
    points.push_back(std::move(p));
  }
  return points;
}

void add_strong(Value::Array& points, double x, double y, const std::string& name) {
  Value p;
  p.set("x", x);
  p.set("y", y);
  p.set("strong", true);
  p.set("name", name);
  points.push_back(std::move(p));
}

// A chart over the plane: lines of levels, and points.
Value contours(const Plane& plane, Value::Array lines, Value::Array points) {
  Value spec;
  spec.set("kind", "contours");
  spec.set("x", axis_of(plane.stage.parameters[0]));
  spec.set("y", axis_of(plane.stage.parameters[1]));
  spec.set("lines", std::move(lines));
  spec.set("points", std::move(points));
  return spec;
}

std::string level_text(const Target& target) {
  return fmt::format("{} ± {} {}", shown(target.value), shown(target.error, 2),
                     study::unit_shown(target.response.unit));
}

std::string level_chart(const Findings& f, const Plane& plane, const StageResult& result,
                        const Level& level, report::Charts& charts) {
  const Target& target = f.lab.target(level.target);
  auto drawn = field_on(plane, level, shown_steps);
  Value field;
  field.set("steps", shown_steps);
  field.set("values", drawn.mean);
  for (double& value : drawn.mean) value = restored(target, value + level.shift());
  const auto [low, high] = std::minmax_element(drawn.mean.begin(), drawn.mean.end());
  Value::Array lines;
  add_band(plane, level, "#d55e00", "", lines);
  Value spec = contours(plane, std::move(lines), dots(result));
  spec.set("field", std::move(field));
  return charts.add(
      anchor(plane.stage) + "-" + f.lab.target_name(level.target),
      f.lab.tests[level.target.test].label + ": " + target.response.label, std::move(spec),
      escape(fmt::format("From {} (dark) to {} {} (bright); the line is the measured {}, with all "
                         "errors dashed. Dots are runs.",
                         shown(*low, 3), shown(*high, 3), study::unit_shown(target.response.unit),
                         level_text(target))));
}

// 68 and 95 % of the posterior, where the stage has two parameters.
void add_regions(const Plane& plane, const StageResult& result, Value::Array& lines) {
  if (plane.stage.parameters.size() != 2) return;
  const Grid grid = plane.grid(region_steps);
  const auto problem = problem_of(plane.stage, result.levels);
  std::vector<statistics::Field> fields;
  for (const auto& response : problem.responses)
    fields.push_back(statistics::field_of(grid, response));
  const auto posterior = statistics::normalised(
      grid, statistics::log_density(grid, fields, problem.measured, problem.priors));
  lines.push_back(
      line_of(statistics::level_line(grid, posterior.log_density, posterior.region_level(0.68)),
              "#1d2430", "68 % of the posterior", "", 1.6));
  lines.push_back(
      line_of(statistics::level_line(grid, posterior.log_density, posterior.region_level(0.95)),
              "#8d97a5", "95 %", "", 1.6));
}

std::string crossing_chart(const Findings& f, const Plane& plane, const StageResult& result,
                           report::Charts& charts) {
  Value::Array lines;
  for (std::size_t l = 0; l < result.levels.size(); ++l)
    add_band(plane, result.levels[l], report::hex(report::species_colour(l)),
             f.lab.target_name(result.levels[l].target) +
                 (l < plane.stage.use.size() ? "" : " (decides)"),
             lines);
  add_regions(plane, result, lines);
  Value::Array points;
  for (std::size_t m = 0; m < result.modes.size(); ++m)
    add_strong(points, result.modes[m].at[0], result.modes[m].at[1],
               m == 0 ? "found" : fmt::format("mode {}", m + 1));
  const auto &a = plane.stage.parameters[0].reference, &b = plane.stage.parameters[1].reference;
  if (a && b) add_strong(points, *a, *b, "reference");
  return charts.add(anchor(plane.stage) + "-crossing", "Where the measured levels meet",
                    contours(plane, std::move(lines), std::move(points)));
}

// Over the one parameter of a stage.
std::string curve_chart(const Findings& f, const Stage& stage, const StageResult& result,
                        std::size_t l, report::Charts& charts) {
  const Level& level = result.levels[l];
  const Target& target = f.lab.target(level.target);
  const Parameter& p = stage.parameters.front();
  std::vector<double> x, y, low, high, measured_y, measured_low, measured_high;
  const auto unit = target.is_logarithmic ? target.value : 1.0;
  for (std::size_t k = 0; k < curve_points; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(curve_points - 1);
    x.push_back(statistics::value_at(p.box, part));
    const auto there = foretold(level, {x.back()});
    y.push_back(restored(target, there.mean));
    low.push_back(restored(target, there.mean - 2.0 * there.deviation));
    high.push_back(restored(target, there.mean + 2.0 * there.deviation));
    measured_y.push_back(target.value);
    measured_low.push_back(target.value - unit * level.measured.deviation);
    measured_high.push_back(target.value + unit * level.measured.deviation);
  }
  const auto series = [&](const std::string& label, const std::string& colour,
                          const std::vector<std::vector<double>>& columns) {
    Value curve, one;
    curve.set("x", x);
    curve.set("y", columns[0]);
    curve.set("low", columns[1]);
    curve.set("high", columns[2]);
    one.set("label", label);
    one.set("colour", colour);
    one.set("curve", std::move(curve));
    return one;
  };
  Value runs =
      series("simulated, ± 2 deviations", report::hex(report::species_colour(0)), {y, low, high});
  Value::Array points;
  for (const Sample& s : result.samples[l]) {
    Value dot;
    dot.set("x", s.point[0]);
    dot.set("y", s.value);
    points.push_back(std::move(dot));
  }
  runs.set("points", std::move(points));
  Value spec, axis;
  axis.set("label", target.response.label);
  axis.set("unit", target.response.unit.empty() ? "1" : target.response.unit);
  spec.set("kind", "scatter");
  spec.set("x", axis_of(p));
  spec.set("y", std::move(axis));
  spec.set("series", Value::Array{runs, series("measured, ± all errors", "#d55e00",
                                               {measured_y, measured_low, measured_high})});
  return charts.add(anchor(stage) + "-" + f.lab.target_name(level.target),
                    f.lab.tests[level.target.test].label + ": " + target.response.label,
                    std::move(spec));
}

std::string modes_table(const Stage& stage, const StageResult& result) {
  std::vector<std::string> head{"mode"};
  for (const Parameter& p : stage.parameters)
    head.push_back(escape(study::axis_title(p.label, p.unit)));
  head.insert(head.end(), {"kind", "mass", "weight"});
  std::vector<std::vector<std::string>> rows;
  for (std::size_t m = 0; m < result.modes.size(); ++m) {
    const ModeFound& mode = result.modes[m];
    std::vector<std::string> row{m == 0 ? "found" : std::to_string(m + 1)};
    for (std::size_t v = 0; v < stage.parameters.size(); ++v)
      row.push_back(with_error(mode.at[v], mode.mode.deviation(v), ""));
    row.push_back(mode.is_crossing              ? "crossing"
                  : m == 0 && result.is_closest ? "closest point"
                                                : "densest point");
    row.push_back(shown(mode.mode.mass, 2));
    row.push_back(shown(mode.weight, 2));
    rows.push_back(std::move(row));
  }
  return element("div", report::table(head, rows, "class=\"numbers compare\""), "class=\"scroll\"");
}

std::string misses_table(const Findings& f, const Stage& stage, const StageResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t l = 0; l < result.levels.size(); ++l) {
    const Level& level = result.levels[l];
    const Target& target = f.lab.target(level.target);
    const Miss miss = miss_of(target, level, result.best().at);
    const double unit = target.is_logarithmic ? target.value : 1.0;
    rows.push_back(
        {escape(f.lab.target_name(level.target)) + (l < stage.use.size() ? "" : ", decides"),
         escape(level_text(target)), shown(miss.predicted), shown(miss.difference, 3),
         shown(miss.deviations, 2), shown(unit * level.measured.deviation, 2),
         shown(unit * level.small.error, 2), shown(unit * level.guesses.value, 2),
         shown(unit * level.others, 2), miss.discrepancy > 0.0 ? shown(miss.discrepancy, 2) : ""});
  }
  return element("div",
                 report::table({"level", "measured", "surrogate at the point found", "difference",
                                "in deviations", "deviation of all but the surrogate",
                                "of it small samples", "moved by other stages' guesses",
                                "of the deviation other stages", "discrepancy to reconcile"},
                               rows, "class=\"numbers compare\""),
                 "class=\"scroll\"");
}

std::string charts_of(const Findings& f, const Stage& stage, const StageResult& result,
                      report::Charts& charts) {
  std::string html;
  if (stage.parameters.size() == 1) {
    for (std::size_t l = 0; l < result.levels.size(); ++l)
      html += curve_chart(f, stage, result, l, charts);
    return html;
  }
  std::vector<double> rest;
  for (std::size_t v = 0; v < stage.parameters.size(); ++v)
    rest.push_back(result.modes.empty() ? stage.parameters[v].guess : result.best().at[v]);
  const Plane plane{stage, rest};
  for (const Level& level : result.levels)
    if (level.fit.surrogate.basis().why_constant.empty())
      html += level_chart(f, plane, result, level, charts);
  return result.modes.empty() ? html : html + crossing_chart(f, plane, result, charts);
}

}  // namespace

report::Section stage_part(const Findings& f, const StageResult& result, report::Charts& charts) {
  const Stage& stage = f.lab.stages[result.stage];
  std::string html = element(
      "p",
      escape(fmt::format("{} points; no more because {}.{}", result.points.size(), result.ended,
                         result.decided.empty() ? "" : " " + result.decided + ".")));
  if (!result.modes.empty()) html += modes_table(stage, result) + misses_table(f, stage, result);
  html += element("div", charts_of(f, stage, result, charts), "class=\"charts\"");
  return {anchor(stage), "Stage " + stage.name + ": " + stage.title, html};
}

report::Section trust_part(const Findings& f, report::Charts& charts) {
  std::vector<std::vector<std::string>> rows;
  std::string html;
  for (const StageResult& result : f.found.stages)
    for (const Level& level : result.levels) {
      const Target& target = f.lab.target(level.target);
      const auto& v = level.fit.validation;
      const std::string name =
          f.lab.stages[result.stage].name + ", " + f.lab.target_name(level.target);
      rows.push_back({escape(name), std::to_string(level.fit.surrogate.basis().points.size()),
                      std::to_string(level.fit.lost), std::to_string(level.fit.censored),
                      shown(level.fit.surrogate.basis().noise, 2), shown(v.q2, 3),
                      shown(v.q2_of_mean, 3), shown(v.rmse, 2),
                      shown(v.mean_standardised_square, 2),
                      escape(level.fit.refusal.empty() ? "holds" : level.fit.refusal)});
      Value::Array points;
      std::vector<double> ends;
      for (std::size_t k = 0; k < v.observed.size(); ++k) {
        Value p;
        p.set("x", restored(target, v.observed[k]));
        p.set("y", restored(target, v.predicted[k]));
        points.push_back(std::move(p));
        ends.push_back(restored(target, v.observed[k]));
      }
      if (ends.size() < 2) continue;
      const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
      Value curve, series, x, y, spec;
      curve.set("x", std::vector<double>{*low, *high});
      curve.set("y", std::vector<double>{*low, *high});
      series.set("colour", report::hex(report::species_colour(0)));
      series.set("points", std::move(points));
      series.set("curve", std::move(curve));
      x.set("label", "run");
      x.set("unit", target.response.unit);
      y.set("label", "foretold from the others");
      y.set("unit", target.response.unit);
      spec.set("kind", "scatter");
      spec.set("x", std::move(x));
      spec.set("y", std::move(y));
      spec.set("series", Value::Array{series});
      html += charts.add("trust-" + study::safe_name(name), name, std::move(spec));
    }
  const std::string how =
      "Each point is left out once and foretold from the others. A surrogate is refused where Q² "
      "beyond the seeds' noise is below 0.8, or where its error² / deviation² is above 2.5 and its "
      "errors exceed half of "
      "the measured deviation; a ratio well below 1 makes results wider than they need be. Of a "
      "response looked at by its logarithm, noise and error are relative.";
  return {"trust", "Cross-validation of the surrogates",
          element("p", how, "class=\"caption\"") +
              element("div",
                      report::table(
                          {"response", "points", "runs failed", "censored", "seeds differ by", "Q²",
                           "beyond noise", "error left out", "error² / deviation²", "verdict"},
                          rows, "class=\"numbers compare trust\""),
                      "class=\"scroll\"") +
              element("div", html, "class=\"charts\"")};
}

}  // namespace pmr::calibrate
