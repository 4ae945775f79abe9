#include "study/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "case/case.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/hash.hpp"
#include "pmr/base/parallel.hpp"
#include "sim/bed.hpp"
#include "sim/forecast.hpp"
#include "sim/schedule.hpp"
#include "statistics/design.hpp"
#include "study/settings.hpp"

namespace pmr::study {
namespace {

using Points = std::vector<std::vector<double>>;

std::vector<double> values_of(const Variable& v) {
  if (v.levels.empty()) return v.values;
  std::vector<double> places;
  for (std::size_t k = 0; k < v.levels.size(); ++k) places.push_back(static_cast<double>(k));
  return places;
}

// All combinations; the first variable changes slowest.
Points grid_points(const Study& study) {
  Points points{{}};
  for (const Variable& v : study.variables) {
    Points longer;
    for (const auto& point : points)
      for (const double value : values_of(v)) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    points = std::move(longer);
  }
  return points;
}

const Level& level_of(const Variable& v, double value) {
  return v.levels.at(static_cast<std::size_t>(value));
}

// Constants, variables, and what is derived from them.
Values known_at(const Study& study, const PlannedRun& run) {
  Values known = study.constants;
  for (std::size_t k = 0; k < study.variables.size(); ++k)
    known[study.variables[k].name] = run.values[k];
  derive(study.derived, known);
  return known;
}

// In the order in which the later wins: the study's, the variables', the command line's, the seed.
std::vector<std::string> settings_of(const Study& study, const PlannedRun& run) {
  const Values known = known_at(study, run);
  std::vector<std::string> settings;
  for (const Setting& setting : study.settings) settings.push_back(filled(setting, known));
  for (std::size_t k = 0; k < study.variables.size(); ++k) {
    const Variable& v = study.variables[k];
    if (!v.key.empty()) settings.push_back(key_setting(v.key, v.unit, run.values[k]));
    if (v.levels.empty()) continue;
    for (const Setting& setting : level_of(v, run.values[k]).settings)
      settings.push_back(filled(setting, known));
  }
  for (const std::string& set : study.sets) settings.push_back(filled(set, known));
  if (run.replicate) settings.push_back(fmt::format("seed={}", *run.replicate));
  return settings;
}

constexpr std::size_t longest_name = 80;

// "ratio=2.seed=3"; of many variables the hash of that.
std::string name_of(const Study& study, const PlannedRun& run) {
  std::string name;
  for (std::size_t k = 0; k < study.variables.size(); ++k)
    name += (k == 0 ? "" : "_") + study.variables[k].name + "=" +
            safe_name(value_text(study.variables[k], run.values[k]));
  if (name.size() > longest_name) {
    Hash hash;
    hash.add(std::string_view(name));
    name = fmt::format("{:016x}", hash.value());
  }
  if (run.replicate) name += fmt::format("_seed={}", *run.replicate);
  return name;
}

// Of all that decides where the particles go.
std::string mechanical_hash(const Case& c) {
  Hash hash;
  hash.add(std::string_view(c.mechanical_text));
  for (const Species& s : c.species) {
    hash.add(s.count);
    hash.add(s.diameter);
    hash.add(std::span<const double>(s.diameters));
    hash.add(c.materials.list[s.material].density);
  }
  return fmt::format("{:016x}", hash.value());
}

// A run whose particles move and then react can take them from a mixing.
bool is_shareable(const Case& c) {
  return c.bed.empty() && c.react && sim::has_heat(c) && (c.fill || c.mix);
}

std::size_t mixing_of(const Case& c, const sim::Forecast& forecast, Plan& plan) {
  const std::string name = mechanical_hash(c);
  for (std::size_t k = 0; k < plan.mixings.size(); ++k)
    if (plan.mixings[k].name == name) return k;
  plan.mixings.push_back({name, c.text, forecast.mixing_alone()});
  return plan.mixings.size() - 1;
}

// The values of a group of normal variables in place of even ones.
void correlate(const Correlated& group, const std::vector<statistics::Span>& spans,
               std::vector<double>& point) {
  std::vector<double> fractions;
  for (const std::size_t v : group.variables)
    fractions.push_back(statistics::fraction_at(spans[v], point[v]));
  const auto values = statistics::normal_values(fractions, group.mean, group.covariance);
  for (std::size_t k = 0; k < values.size(); ++k)
    point[group.variables[k]] = std::clamp(values[k], group.low[k], group.high[k]);
}

void check_names(const Study& study, const Plan& plan) {
  std::map<std::string, int> seen;
  for (const PlannedRun& run : plan.runs)
    if (++seen[run.name] == 2)
      throw CaseError({{study.file.string(), "variables",
                        fmt::format("the point {} stands twice in the design", run.name)}});
}

}  // namespace

std::vector<Fault> Planner::add(Plan& plan, PlannedRun run, const std::filesystem::path& case_file,
                                const std::vector<std::string>& settings) {
  std::vector<Fault> faults;
  try {
    Case c = casefile::load_case(case_file, settings);
    run.case_text = c.text;
    if (!c.bed.empty()) {
      if (bed_of_ != c.bed + c.mechanical_text) bed_ = sim::read_bed(c).particles;
      bed_of_ = c.bed + c.mechanical_text;
      sim::count_bed(bed_, c);
    }
    if (!costs_) {
      const ThreadLimit one_core(1);
      costs_ = sim::measure_costs(c);
    }
    const sim::Forecast forecast = sim::forecast(c, *costs_);
    run.seconds = forecast.react.total();
    if (is_shareable(c))
      run.mixing = mixing_of(c, forecast, plan);
    else
      run.seconds += forecast.moving();
  } catch (const CaseError& error) {
    run.fault = error.what();
    faults = error.faults();
  }
  plan.runs.push_back(std::move(run));
  return faults;
}

std::string key_setting(const std::string& key, const std::string& unit, double value) {
  return unit.empty() ? fmt::format("{}={}", key, value)
                      : fmt::format("{}=\"{} {}\"", key, value, unit);
}

std::string safe_name(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' ||
                       c == '=' || c == '_';
    if (plain)
      out += c;
    else if (out.empty() || out.back() != '-')
      out += '-';
  }
  return out;
}

std::string value_text(const Variable& v, double value) {
  if (!v.levels.empty()) return level_of(v, value).name;
  return v.unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, v.unit);
}

Points design_points(const Study& study) {
  if (study.design.kind == DesignKind::grid) return grid_points(study);
  std::vector<statistics::Span> spans;
  for (const Variable& v : study.variables) spans.push_back({v.low, v.high, v.is_logarithmic});
  const auto sequence = study.design.kind == DesignKind::sobol
                            ? statistics::Sequence::sobol
                            : statistics::Sequence::latin_hypercube;
  Points points = statistics::sample(sequence, spans, study.design.samples, study.design.seed);
  for (auto& point : points)
    for (const Correlated& group : study.correlated) correlate(group, spans, point);
  return points;
}

Plan make_plan(const Study& study) {
  Plan plan;
  std::vector<Fault> faults;  // of the first run that is wrong
  std::size_t sound = 0;
  Planner planner;
  for (const auto& point : design_points(study))
    for (std::size_t k = 1; k <= study.replicates; ++k) {
      PlannedRun run;
      run.values = point;
      if (study.replicates > 1) run.replicate = k;
      run.name = name_of(study, run);
      std::vector<Fault> wrong;
      try {
        const auto settings = settings_of(study, run);
        wrong = planner.add(plan, std::move(run), study.case_file, settings);
      } catch (const std::invalid_argument& error) {
        run.fault = error.what();
        wrong = {{study.file.string(), "settings", error.what()}};
        plan.runs.push_back(std::move(run));
      }
      if (wrong.empty()) ++sound;
      if (faults.empty()) faults = std::move(wrong);
    }
  if (sound == 0) throw CaseError(std::move(faults));
  check_names(study, plan);
  return plan;
}

}  // namespace pmr::study
