// Sampled designs: how far the responses spread, what does it, and the course in between.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/series.hpp"
#include "report/colour_map.hpp"
#include "report/text.hpp"
#include "statistics/band.hpp"
#include "study/page_parts.hpp"

namespace pmr::study {
namespace {

using report::element;
using report::escape;
using report::Value;

std::vector<double> column_of(const Results& results, std::size_t r) {
  std::vector<double> values;
  for (const Row& row : results.rows) values.push_back(row.responses[r]);
  return values;
}

std::string spread_table(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t r = 0; r < f.study.responses.size(); ++r) {
    const auto band = statistics::band(column_of(f.results, r));
    const Response& response = f.study.responses[r];
    const auto shown = [](double value) {
      return std::isfinite(value) ? report::significant(value, 4) : std::string("–");
    };
    rows.push_back({escape(axis_title(response.label, response.unit)), shown(band.p5),
                    shown(band.p50), shown(band.p95), shown(band.mean), shown(band.deviation)});
  }
  return element("div",
                 report::table({"response", "5 %", "median", "95 %", "mean", "standard deviation"},
                               rows, "class=\"numbers compare\""),
                 "class=\"scroll\"");
}

std::string range_table(const Findings& f) {
  std::vector<std::vector<std::string>> rows;
  for (const std::size_t v : f.numeric) {
    const Variable& variable = f.study.variables[v];
    rows.push_back({escape(axis_title(variable.label, variable.unit)),
                    fmt::format("{:.4g} to {:.4g}{}", variable.low, variable.high,
                                variable.is_logarithmic ? ", even in the logarithm" : ""),
                    escape(variable.source)});
  }
  return element("div", report::table({"input", "range", "source"}, rows), "class=\"scroll\"");
}

std::string ranking_chart(const Findings& f, report::Charts& charts, std::size_t r) {
  const auto ranking = rank(f.study, f.plan, f.results, r);
  const Response& response = f.study.responses[r];
  if (!std::isfinite(ranking.r2))
    return report::absent(response.label + ": too few runs to rank the inputs.");
  std::vector<std::size_t> order(f.numeric.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(ranking.inputs[a].coefficient) > std::abs(ranking.inputs[b].coefficient);
  });
  Value::Array rows;
  for (const std::size_t k : order) {
    Value row;
    row.set("name", f.study.variables[f.numeric[k]].label);
    row.set("value", ranking.inputs[k].coefficient);
    row.set("low", ranking.inputs[k].low);
    row.set("high", ranking.inputs[k].high);
    rows.push_back(std::move(row));
  }
  Value spec;
  spec.set("kind", "bars");
  spec.set("label", "standardised rank regression coefficient");
  spec.set("domain", std::vector<double>{-1.0, 1.0});
  spec.set("rows", std::move(rows));
  return charts.add(
      "ranking-" + response.name, response.label, std::move(spec),
      fmt::format("The ranks of the inputs explain {:.0f} % of the variance of this "
                  "response’s ranks.{} Lines: 90 % by bootstrap.",
                  100.0 * ranking.r2,
                  ranking.r2 < 0.7 ? " That is little: do not trust the order." : ""));
}

constexpr std::size_t moments = 160;

// Even steps of the logarithm from the first common second to the end of the shortest run.
std::vector<double> common_times(const std::vector<io::Series>& all) {
  double first = 1e-2, last = 1e300;
  for (const io::Series& s : all) {
    first = std::max(first, s.values("time").front());
    last = std::min(last, s.values("time").back());
  }
  std::vector<double> times;
  for (std::size_t k = 0; k < moments && last > first; ++k)
    times.push_back(first * std::pow(last / first, static_cast<double>(k) / (moments - 1)));
  if (!times.empty()) times.back() = last;
  return times;
}

std::string band_chart(report::Charts& charts, const Band& band, const std::vector<io::Series>& all,
                       const std::vector<double>& times) {
  std::vector<double> low, middle, high;
  for (const double t : times) {
    std::vector<double> values;
    for (const io::Series& s : all)
      if (s.has(band.column)) values.push_back(io::at_time(s, band.column, t));
    const auto spread = statistics::band(values);
    low.push_back(band.factor * spread.p5 + band.offset);
    middle.push_back(band.factor * spread.p50 + band.offset);
    high.push_back(band.factor * spread.p95 + band.offset);
  }
  const bool is_known =
      std::any_of(middle.begin(), middle.end(), [](double value) { return std::isfinite(value); });
  if (!is_known) return report::absent(band.label + ": no run has the column " + band.column + ".");
  Value line, axis, spec;
  line.set("label", fmt::format("median of {} runs, 5 to 95 %", all.size()));
  line.set("colour", report::hex(report::species_colour(0)));
  line.set("x", times);
  line.set("y", middle);
  line.set("low", low);
  line.set("high", high);
  axis.set("label", band.label);
  axis.set("unit", band.unit.empty() ? "1" : band.unit);
  spec.set("kind", "course");
  spec.set("y", std::move(axis));
  spec.set("lines", Value::Array{line});
  return charts.add("band-" + band.name, band.label + " over time", std::move(spec));
}

std::string band_charts(const Findings& f, report::Charts& charts) {
  if (f.study.bands.empty()) return "";
  std::vector<io::Series> all;
  for (std::size_t k = 0; k < f.plan.runs.size(); ++k)
    if (f.results.rows[k].status == "completed") {
      io::Series series = io::read_series(f.folder.run(f.plan.runs[k]));
      if (series.rows() > 1) all.push_back(std::move(series));
    }
  if (all.empty()) return "";
  const auto times = common_times(all);
  std::string html;
  for (const Band& band : f.study.bands) html += band_chart(charts, band, all, times);
  return element("h3", "Course") + element("div", html, "class=\"charts\"");
}

}  // namespace

report::Section ranking_part(const Findings& f, report::Charts& charts) {
  std::string ranking;
  for (std::size_t r = 0; r < f.study.responses.size(); ++r) ranking += ranking_chart(f, charts, r);
  const std::string drawn = f.study.correlated.empty()
                                ? "nothing says that one value is likelier than another."
                                : "those that are correlated are normal, so that values near their "
                                  "means are likelier, and "
                                  "share what they have in common.";
  const std::string how =
      "All inputs below were varied together over their ranges; " + drawn +
      " Bars tell by how many standard deviations of rank a response moves with one of the input.";
  return {"uncertainty", "What the inputs do",
          element("h3", "Spread of the responses") + spread_table(f) + band_charts(f, charts) +
              element("h3", "What it comes from") + element("p", how, "class=\"caption\"") +
              element("div", ranking, "class=\"charts\"") + element("h3", "Ranges") +
              range_table(f)};
}

}  // namespace pmr::study
