#include "calibrate/outputs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "calibrate/choice.hpp"
#include "case/case.hpp"
#include "io/atomic_file.hpp"
#include "report/value.hpp"
#include "statistics/band.hpp"

namespace pmr::calibrate {
namespace {

using casefile::quoted;
using report::Value;

double deviation(const Found& found, std::size_t k) { return std::sqrt(found.covariance[k][k]); }

// A coefficient of contacts as a figure with its source; any other key as its plain value.
std::string assignment(const std::string& key, const std::string& unit, double value, double sd,
                       const std::string& source) {
  if (key.rfind("contacts.", 0) != 0) return study::key_setting(key, unit, value);
  return fmt::format("{} = {{value = {:.6g}, mark = \"D\", source = {}, range = {}}}", key, value,
                     quoted(source), quoted(fmt::format("sd {:.2g}", sd)));
}

std::string list(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return "[" + text + "]";
}

// Time step, laws and moduli that the parameters belong to, of the tests that found them.
void set_models(const Lab& lab, const Calibration& c, casefile::Node& root) {
  std::set<std::size_t> tests;
  for (const StageResult& stage : c.stages)
    for (const Level& level : stage.levels) tests.insert(level.target.test);
  for (const std::size_t t : tests) {
    std::vector<std::string> settings;
    for (const auto& setting : lab.settings) settings.push_back(study::filled(setting, c.values));
    for (const auto& setting : lab.tests[t].settings)
      settings.push_back(study::filled(setting, c.values));
    for (const std::string& set : lab.sets) settings.push_back(study::filled(set, c.values));
    const Case made = casefile::load_case(lab.tests[t].case_file, settings);
    const std::string table = "calibration.tests." + quoted(lab.tests[t].name);
    if (made.models.mechanics.time_step)
      casefile::apply_setting(root, fmt::format("{}.time_step = \"{:.6g} us\"", table,
                                                1e6 * *made.models.mechanics.time_step));
    const ContactModel& contact = made.models.mechanics.contact;
    const auto name = [](const auto& law) { return std::string(law.name); };
    casefile::apply_setting(root,
                            table + ".force_law = " + quoted(std::visit(name, contact.force)));
    casefile::apply_setting(root,
                            table + ".rolling_law = " + quoted(std::visit(name, contact.rolling)));
    for (const Material& m : made.materials.list)
      casefile::apply_setting(root, fmt::format("calibration.young_modulus.{} = \"{:.6g} Pa\"",
                                                quoted(m.name), m.young_soft));
  }
}

std::string source_of(const Lab& lab, const std::string& version) {
  return "pmr calibrate, " + lab.title + "; pmr " + version;
}

Value numbers(const std::vector<double>& values) { return Value(values); }

Value matrix(const std::vector<std::vector<double>>& rows) {
  Value::Array all;
  for (const auto& row : rows) all.emplace_back(row);
  return Value(std::move(all));
}

Value json_of(const Lab& lab, const StageResult& result, const Level& level, bool is_used) {
  const Target& target = lab.target(level.target);
  Value v;
  v.set("response", lab.target_name(level.target));
  v.set("unit", target.response.unit);
  v.set("measured", target.value);
  v.set("standard_error", target.error);
  v.set("used", is_used ? "to find" : "to decide");
  v.set("noise_of_a_run", level.fit.surrogate.basis().noise);
  v.set("q2", level.fit.validation.q2);
  v.set("q2_beyond_noise", level.fit.validation.q2_of_mean);
  v.set("mean_standardised_square", level.fit.validation.mean_standardised_square);
  v.set("runs_failed", level.fit.lost);
  v.set("runs_censored", level.fit.censored);
  v.set("small_to_full", level.small.value);
  v.set("small_to_full_error", level.small.error);
  v.set("guesses_to_found", level.guesses.value);
  v.set("guesses_to_found_error", level.guesses.error);
  v.set("from_other_stages", level.others);
  v.set("deviation", level.measured.deviation);
  v.set("refusal", level.fit.refusal);
  if (result.modes.empty()) return v;
  const Miss miss = miss_of(target, level, result.best().at);
  v.set("predicted", miss.predicted);
  v.set("missed_by", miss.difference);
  v.set("missed_in_deviations", miss.deviations);
  v.set("discrepancy_to_reconcile", miss.discrepancy);
  return v;
}

Value json_of(const Lab& lab, const StageResult& result) {
  const Stage& stage = lab.stages[result.stage];
  Value v;
  v.set("name", stage.name);
  v.set("title", stage.title);
  Value::Array names, levels, modes, points;
  for (const Parameter& p : stage.parameters) names.emplace_back(p.name);
  v.set("parameters", std::move(names));
  v.set("points", result.points.size());
  v.set("ended", result.ended);
  v.set("closest", result.is_closest);
  v.set("mass_on_edge", result.mass_on_edge);
  v.set("decided", result.decided);
  for (const ModeFound& m : result.modes) {
    Value mode;
    mode.set("at", numbers(m.at));
    mode.set("mean", numbers(m.mode.mean));
    mode.set("covariance", matrix(m.mode.covariance));
    mode.set("mass", m.mode.mass);
    mode.set("weight", m.weight);
    mode.set("crossing", m.is_crossing);
    modes.push_back(std::move(mode));
  }
  v.set("modes", std::move(modes));
  for (std::size_t l = 0; l < result.levels.size(); ++l)
    levels.push_back(json_of(lab, result, result.levels[l], l < stage.use.size()));
  v.set("levels", std::move(levels));
  return v;
}

Value found_json(const Lab& lab, const Calibration& c) {
  Value::Array all;
  const auto add = [&](const std::string& name, const std::string& key, const std::string& unit,
                       double value, double sd, const std::optional<double>& reference) {
    Value one;
    one.set("name", name);
    one.set("key", key);
    one.set("unit", unit);
    one.set("value", value);
    one.set("standard_deviation", sd);
    if (reference) one.set("reference", *reference);
    all.push_back(std::move(one));
  };
  for (std::size_t k = 0; k < c.found.parameters.size(); ++k) {
    const Parameter& p = *c.found.parameters[k];
    add(p.name, p.key, p.unit, c.found.values[k], deviation(c.found, k), p.reference);
  }
  for (std::size_t k = 0; k < lab.derived.size(); ++k) {
    const Derived& d = lab.derived[k];
    if (std::isfinite(c.derived[k].value))
      add(d.name, d.key, d.unit, c.derived[k].value, c.derived[k].deviation, d.reference);
  }
  return Value(std::move(all));
}

}  // namespace

void write_parameters(const Lab& lab, const Calibration& c, const std::string& version,
                      const std::filesystem::path& file) {
  casefile::Node root;
  const auto set = [&](const std::string& text) { casefile::apply_setting(root, text); };
  const std::string source = source_of(lab, version);
  std::vector<std::string> names, keys, units, values, sds, low, high, rows;
  for (std::size_t k = 0; k < c.found.parameters.size(); ++k) {
    const Parameter& p = *c.found.parameters[k];
    if (!p.key.empty())
      set(assignment(p.key, p.unit, c.found.values[k], deviation(c.found, k), source));
    names.push_back(quoted(p.name));
    keys.push_back(quoted(p.key));
    units.push_back(quoted(p.unit));
    values.push_back(fmt::format("{:.6g}", c.found.values[k]));
    sds.push_back(fmt::format("{:.6g}", deviation(c.found, k)));
    low.push_back(fmt::format("{:.6g}", p.box.low));
    high.push_back(fmt::format("{:.6g}", p.box.high));
    std::vector<std::string> row;
    for (std::size_t l = 0; l < c.found.parameters.size(); ++l)
      row.push_back(fmt::format(
          "{:.4f}", c.found.covariance[k][l] / deviation(c.found, k) / deviation(c.found, l)));
    rows.push_back(list(row));
  }
  for (std::size_t k = 0; k < lab.derived.size(); ++k)
    if (const Derived& d = lab.derived[k]; !d.key.empty() && std::isfinite(c.derived[k].value))
      set(assignment(d.key, d.unit, c.derived[k].value, c.derived[k].deviation,
                     source + "; " + d.formula));
  set("calibration.lab = " + quoted(lab.title));
  set("calibration.version = " + quoted(version));
  set("calibration.names = " + list(names));
  set("calibration.keys = " + list(keys));
  set("calibration.units = " + list(units));
  set("calibration.values = " + list(values));
  set("calibration.deviations = " + list(sds));
  set("calibration.low = " + list(low));
  set("calibration.high = " + list(high));
  set("calibration.correlation = " + list(rows));
  set_models(lab, c, root);
  io::replace_text(file,
                   "# Found by pmr calibrate; `extends` of a case takes it, and [correlated] "
                   "of a study.\n" +
                       casefile::write_toml(root));
}

void write_json(const Lab& lab, const Calibration& c, const std::string& version,
                const std::filesystem::path& file) {
  Value v;
  v.set("format", "pmr-calibration");
  v.set("version", version);
  v.set("title", lab.title);
  v.set("status", c.is_refused ? "refused" : "completed");
  v.set("found", found_json(lab, c));
  v.set("covariance", matrix(c.found.covariance));
  Value::Array stages, predicted, warnings;
  for (const StageResult& result : c.stages) stages.push_back(json_of(lab, result));
  v.set("stages", std::move(stages));
  for (const Predicted& p : c.predicted) {
    Value one;
    const Target& target = lab.target(p.target);
    one.set("response", lab.target_name(p.target));
    one.set("unit", target.response.unit);
    one.set("measured", target.value);
    one.set("standard_error", target.error);
    one.set("values", numbers(p.values));
    one.set("mean", statistics::band(p.values).mean);
    predicted.push_back(std::move(one));
  }
  v.set("predicted", std::move(predicted));
  for (const std::string& warning : c.warnings) warnings.emplace_back(warning);
  v.set("warnings", std::move(warnings));
  io::replace_text(file, report::to_json(v) + "\n");
}

}  // namespace pmr::calibrate
