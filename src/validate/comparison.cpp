#include "validate/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/atomic_file.hpp"
#include "pmr/base/constants.hpp"
#include "statistics/band.hpp"
#include "study/results.hpp"

namespace pmr::validate {
namespace {

double value_of(const Experiment& e, const std::string& formula, std::size_t row,
                const Reading* reading) {
  study::Values known = known_at(e, row);
  if (reading != nullptr)
    for (std::size_t f = 0; f < e.figures.size(); ++f)
      known[e.figures[f].name] = reading->figures[f];
  try {
    return study::evaluated(formula, known);
  } catch (const std::invalid_argument& error) {
    throw CaseError({{e.file.string(), fmt::format("point {}", row + 1), error.what()}});
  }
}

bool is_whole(const std::vector<Reading>& seeds) {
  return std::all_of(seeds.begin(), seeds.end(), [](const Reading& r) {
    return r.status == "completed" && std::all_of(r.figures.begin(), r.figures.end(),
                                                  [](double x) { return std::isfinite(x); });
  });
}

ComparedPoint point_of(const Experiment& e, const Quantity& q, std::size_t row,
                       const std::vector<Reading>& seeds) {
  ComparedPoint point{row,
                      value_of(e, e.axis.value, row, nullptr),
                      value_of(e, q.measured, row, nullptr),
                      value_of(e, q.deviation, row, nullptr),
                      nan,
                      0.0,
                      false};
  point.is_judged = q.bar.judges(point.x);
  if (!is_whole(seeds)) return point;
  std::vector<double> values;
  for (const Reading& reading : seeds) values.push_back(value_of(e, q.computed, row, &reading));
  const auto band = statistics::band(values);
  point.computed = band.mean;
  if (values.size() > 1)
    point.error = band.deviation / std::sqrt(static_cast<double>(values.size()));
  return point;
}

double bar_figure(const Comparison& c, Bar::Kind kind) {
  switch (kind) {
    case Bar::Kind::largest:
      return std::abs(c.largest);
    case Bar::Kind::rms:
      return c.rms;
    case Bar::Kind::relative:
      return c.relative;
    case Bar::Kind::none:
      break;
  }
  return 0.0;
}

void take_off_zero(Comparison& c) {
  std::vector<double> misses;
  for (const ComparedPoint& p : c.points)
    if (p.is_judged) misses.push_back(p.miss());
  c.zero = statistics::band(misses).mean;
  for (ComparedPoint& p : c.points) p.computed -= c.zero;
}

void sum_up(const Quantity& q, Comparison& c) {
  const bool is_run = std::all_of(c.points.begin(), c.points.end(),
                                  [](const ComparedPoint& p) { return std::isfinite(p.computed); });
  if (!is_run) return;
  if (q.has_free_zero) take_off_zero(c);
  double squares = 0.0, deviations = 0.0;
  for (const ComparedPoint& p : c.points) {
    if (!p.is_judged) continue;
    ++c.judged;
    c.mean += p.miss();
    squares += p.miss() * p.miss();
    deviations += p.miss_in_deviations() * p.miss_in_deviations();
    if (std::abs(p.miss()) > std::abs(c.largest)) c.largest = p.miss();
    c.relative = std::max(c.relative, std::abs(p.miss() / p.measured));
  }
  const auto n = static_cast<double>(c.judged);
  c.mean /= n;
  c.rms = std::sqrt(squares / n);
  c.rms_in_deviations = std::sqrt(deviations / n);
  c.verdict = q.bar.kind == Bar::Kind::none             ? Verdict::shown
              : bar_figure(c, q.bar.kind) <= q.bar.most ? Verdict::held
                                                        : Verdict::missed;
}

Readings read_all(const Experiment& e, const ValidationPlan& plan,
                  const std::vector<std::vector<std::size_t>>& places,
                  const study::Folder& folder) {
  Readings readings;
  for (std::size_t row = 0; row < places.size(); ++row) {
    readings.emplace_back();
    for (const std::size_t run : places[row])
      readings.back().push_back(read_run(e, row, plan.plan, run, folder));
  }
  return readings;
}

// A line of CSV: no commas within.
std::string cell(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

}  // namespace

double ComparedPoint::miss_in_deviations() const { return miss() / std::hypot(deviation, error); }

Comparison held_against(const Experiment& e, const Quantity& quantity, const Readings& readings) {
  Comparison c;
  for (std::size_t row = 0; row < e.points.rows; ++row)
    c.points.push_back(point_of(e, quantity, row, readings[row]));
  sum_up(quantity, c);
  return c;
}

SlopeFound slope_through(const Experiment& e, const Slope& slope, const Readings& readings) {
  SlopeFound found;
  std::vector<double> x, y;
  for (std::size_t row = 0; row < readings.size(); ++row) {
    if (!is_whole(readings[row])) return found;
    x.push_back(value_of(e, slope.x, row, nullptr));
    double sum = 0.0;
    for (const Reading& r : readings[row]) sum += value_of(e, slope.y, row, &r);
    y.push_back(sum / static_cast<double>(readings[row].size()));
  }
  const auto n = static_cast<double>(x.size());
  const double x_mean = statistics::band(x).mean, y_mean = statistics::band(y).mean;
  double xx = 0.0, xy = 0.0, rest = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - x_mean) * (x[k] - x_mean);
    xy += (x[k] - x_mean) * (y[k] - y_mean);
  }
  found.value = xy / xx;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double off = y[k] - y_mean - found.value * (x[k] - x_mean);
    rest += off * off;
  }
  found.error = x.size() > 2 ? std::sqrt(rest / (n - 2.0) / xx) : nan;
  found.verdict =
      std::abs(found.value - slope.measured) <= slope.bar ? Verdict::held : Verdict::missed;
  return found;
}

Findings compare(std::span<const Experiment> experiments, const ValidationPlan& plan,
                 const study::Folder& folder) {
  Findings findings;
  for (std::size_t k = 0; k < experiments.size(); ++k) {
    const Experiment& e = experiments[k];
    std::vector<Readings> of_variants;
    for (const auto& places : plan.places[k])
      of_variants.push_back(read_all(e, plan, places, folder));
    for (std::size_t q = 0; q < e.quantities.size(); ++q)
      for (std::size_t v = 0; v < of_variants.size(); ++v) {
        Comparison c = held_against(e, e.quantities[q], of_variants[v]);
        c.experiment = k, c.quantity = q, c.variant = v;
        findings.comparisons.push_back(std::move(c));
      }
    for (std::size_t s = 0; s < e.slopes.size(); ++s)
      for (std::size_t v = 0; v < of_variants.size(); ++v) {
        SlopeFound found = slope_through(e, e.slopes[s], of_variants[v]);
        found.experiment = k, found.slope = s, found.variant = v;
        findings.slopes.push_back(found);
      }
  }
  for (const study::PlannedRun& run : plan.plan.runs) {
    const study::Row row = study::row_of({}, plan.plan, run, folder);
    if (row.status == "failed") findings.failures.push_back(run.name + ": " + row.reason);
  }
  return findings;
}

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::held:
      return "held";
    case Verdict::missed:
      return "missed";
    case Verdict::shown:
      return "no bar";
    case Verdict::not_run:
      break;
  }
  return "not run";
}

std::string unit_of_miss(const Quantity& quantity) {
  return quantity.unit == "degC" ? "K" : quantity.unit;
}

std::string bar_text(const Quantity& quantity) {
  const Bar& bar = quantity.bar;
  const std::string unit = quantity.unit.empty() ? "" : " " + unit_of_miss(quantity);
  std::string text;
  if (bar.kind == Bar::Kind::largest) text = fmt::format("largest {}{}", bar.most, unit);
  if (bar.kind == Bar::Kind::rms) text = fmt::format("rms {}{}", bar.most, unit);
  if (bar.kind == Bar::Kind::relative) text = fmt::format("largest {} %", 100.0 * bar.most);
  if (std::isfinite(bar.from)) text += fmt::format(" from {}", bar.from);
  if (std::isfinite(bar.to)) text += fmt::format(" to {}", bar.to);
  return text;
}

void write_table(std::span<const Experiment> experiments, const Findings& findings,
                 const std::filesystem::path& file) {
  std::string text =
      "experiment,quantity,unit,variant,point,axis,measured,deviation,computed,standard_error,"
      "miss,miss_in_deviations,judged\n";
  for (const Comparison& c : findings.comparisons) {
    const Experiment& e = experiments[c.experiment];
    const Quantity& q = e.quantities[c.quantity];
    for (const ComparedPoint& p : c.points) {
      const bool is_run = std::isfinite(p.computed);
      text +=
          fmt::format("{},{},{},{},{},{},{},{},", e.name, cell(q.name), cell(q.unit),
                      cell(e.variants[c.variant].name), p.row + 1, p.x, p.measured, p.deviation);
      text += is_run ? fmt::format("{},{},{},{},{}\n", p.computed, p.error, p.miss(),
                                   p.miss_in_deviations(), p.is_judged ? 1 : 0)
                     : ",,,,\n";
    }
  }
  io::replace_text(file, text);
}

}  // namespace pmr::validate
