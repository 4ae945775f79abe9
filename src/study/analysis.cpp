#include "study/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pmr::study {
namespace {

bool has_completed(const Row& row) { return row.status == "completed"; }

std::vector<double> levels_of(const Study& study, const PlannedRun& run) {
  std::vector<double> levels;
  for (std::size_t v = 0; v < study.variables.size(); ++v)
    if (!study.variables[v].levels.empty()) levels.push_back(run.values[v]);
  return levels;
}

std::string levels_name(const Study& study, const PlannedRun& run) {
  std::string name;
  for (std::size_t v = 0; v < study.variables.size(); ++v)
    if (!study.variables[v].levels.empty())
      name += (name.empty() ? "" : ", ") + value_text(study.variables[v], run.values[v]);
  return name;
}

// Ends of a variable over the plan, for the surrogate's box.
statistics::Span span_of(const Study& study, const Plan& plan, std::size_t variable) {
  const Variable& v = study.variables[variable];
  if (std::isfinite(v.low)) return {v.low, v.high, v.is_logarithmic};
  double low = plan.runs.front().values[variable], high = low;
  for (const PlannedRun& run : plan.runs) {
    low = std::min(low, run.values[variable]);
    high = std::max(high, run.values[variable]);
  }
  return {low, high, low > 0.0 && (v.is_logarithmic || high > 20.0 * low)};
}

}  // namespace

std::vector<std::size_t> numeric_variables(const Study& study, const Plan& plan) {
  std::vector<std::size_t> numeric;
  for (std::size_t v = 0; v < study.variables.size(); ++v) {
    std::set<double> values;
    for (const PlannedRun& run : plan.runs) values.insert(run.values[v]);
    if (study.variables[v].levels.empty() && values.size() > 1) numeric.push_back(v);
  }
  return numeric;
}

std::vector<Group> groups_of(const Study& study, const Plan& plan, const Results& results) {
  std::map<std::vector<double>, Group> groups;
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    const auto levels = levels_of(study, plan.runs[k]);
    Group& group = groups[levels];
    group.name = levels_name(study, plan.runs[k]);
    group.levels = levels;
    if (has_completed(results.rows[k])) group.rows.push_back(k);
  }
  std::vector<Group> all;
  all.reserve(groups.size());
  for (auto& [levels, group] : groups) all.push_back(std::move(group));
  return all;
}

namespace {

// Lowest and highest of each coordinate over the points whose value is a number.
std::vector<std::array<double, 2>> ends_of(const statistics::Points& points,
                                           const std::vector<double>& values) {
  std::vector<std::array<double, 2>> ends;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    if (ends.empty())
      for (const double x : points[k]) ends.push_back({x, x});
    for (std::size_t a = 0; a < ends.size(); ++a)
      ends[a] = {std::min(ends[a][0], points[k][a]), std::max(ends[a][1], points[k][a])};
  }
  return ends;
}

}  // namespace

std::vector<Fit> fit_all(const Study& study, const Plan& plan, const Results& results,
                         const std::vector<Group>& groups) {
  std::vector<Fit> fits;
  const auto numeric = numeric_variables(study, plan);
  if (numeric.empty()) return fits;
  std::vector<statistics::Span> spans;
  spans.reserve(numeric.size());
  for (const std::size_t v : numeric) spans.push_back(span_of(study, plan, v));
  for (std::size_t r = 0; r < study.responses.size(); ++r)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      statistics::Points points;
      std::vector<double> values;
      for (const std::size_t row : groups[g].rows) {
        points.emplace_back();
        for (const std::size_t v : numeric) points.back().push_back(plan.runs[row].values[v]);
        values.push_back(results.rows[row].responses[r]);
      }
      auto ends = ends_of(points, values);
      if (!ends.empty())
        fits.push_back({r, g, std::move(ends), statistics::Surrogate(spans, points, values)});
    }
  return fits;
}

bool is_sampled(const Study& study) { return study.design.kind != DesignKind::grid; }

statistics::Ranking rank(const Study& study, const Plan& plan, const Results& results,
                         std::size_t response) {
  const auto numeric = numeric_variables(study, plan);
  statistics::Points points;
  std::vector<double> values;
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    points.emplace_back();
    for (const std::size_t v : numeric) points.back().push_back(plan.runs[k].values[v]);
    values.push_back(results.rows[k].responses[response]);
  }
  return statistics::rank(points, values);
}

std::vector<std::size_t> pareto_front(const Results& results, std::size_t gain, std::size_t cost) {
  std::vector<std::size_t> front;
  const auto of = [&](std::size_t k, std::size_t r) { return results.rows[k].responses[r]; };
  for (std::size_t k = 0; k < results.rows.size(); ++k) {
    if (!std::isfinite(of(k, gain)) || !std::isfinite(of(k, cost))) continue;
    bool is_beaten = false;
    for (std::size_t j = 0; j < results.rows.size(); ++j)
      is_beaten = is_beaten || (of(j, gain) >= of(k, gain) && of(j, cost) <= of(k, cost) &&
                                (of(j, gain) > of(k, gain) || of(j, cost) < of(k, cost)));
    if (!is_beaten) front.push_back(k);
  }
  return front;
}

std::size_t response_index(const Study& study, const std::string& name) {
  for (std::size_t r = 0; r < study.responses.size(); ++r)
    if (study.responses[r].name == name) return r;
  return study.responses.size();
}

}  // namespace pmr::study
