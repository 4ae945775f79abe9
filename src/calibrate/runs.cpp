#include "calibrate/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "calibrate/run_table.hpp"
#include "case/case.hpp"
#include "case/nearest.hpp"
#include "case/shipped.hpp"
#include "pmr/base/hash.hpp"
#include "pmr/base/stop.hpp"
#include "study/results.hpp"

namespace pmr::calibrate {
namespace {

// Of materials, what mechanics asks for.
void add_mechanics(const Materials& materials, Hash& hash) {
  for (const Material& m : materials.list) {
    hash.add(std::string_view(m.name));
    for (const double figure : {m.density, m.young_soft, m.poisson_soft}) hash.add(figure);
  }
  for (const PairContact& pair : materials.pairs)
    for (const double figure : {pair.friction, pair.rolling_friction, pair.restitution})
      hash.add(figure);
}

// What decides a run's result: the case without words and output, and what it takes of the
// materials built in, which it need not name.
std::string hash_of(const std::string& case_text) {
  const casefile::Node document = casefile::parse_toml(case_text, "case");
  const Case c = casefile::load_case_text(case_text, "case", ".", {});
  Hash hash;
  if (c.models.mechanics_only)
    add_mechanics(c.materials, hash);
  else
    for (const casefile::ShippedFile& file : casefile::shipped_files())
      hash.add(std::string_view(file.text));
  hash.add(std::string_view(
      casefile::write_toml(casefile::without(document, {"title", "description", "output"}))));
  return fmt::format("{:016x}", hash.value());
}

// The materials of "contacts.\"A|B\".friction"; none of another key.
std::vector<std::string> pair_of(const std::string& key) {
  const std::size_t open = key.find('"'), bar = key.find('|'), close = key.rfind('"');
  if (key.rfind("contacts.", 0) != 0 || open == std::string::npos || bar == std::string::npos ||
      bar < open || close < bar)
    return {};
  return {key.substr(open + 1, bar - open - 1), key.substr(bar + 1, close - bar - 1)};
}

bool has_all(const Case& c, const std::vector<std::string>& materials) {
  return std::all_of(materials.begin(), materials.end(), [&](const std::string& name) {
    return std::any_of(c.materials.list.begin(), c.materials.list.end(),
                       [&](const Material& m) { return m.name == name; });
  });
}

// A run that exceeds a limit has failed; what a row holds for the limits goes.
void hold_to_limits(const Test& test, study::Row& row) {
  const std::size_t targets = test.targets.size();
  for (std::size_t k = 0; k < test.limits.size() && row.status == "completed"; ++k) {
    const double value = row.responses[targets + k];
    if (value <= test.limits[k].most) continue;
    row.status = "failed";
    row.reason = std::isnan(value)
                     ? fmt::format("its summary has no {}", test.limits[k].figure.key)
                     : fmt::format("{} is {:.4g} where at most {:.4g} is wanted",
                                   test.limits[k].figure.key, value, test.limits[k].most);
  }
  row.responses.resize(targets);
  if (row.status != "completed") row.responses.assign(targets, nan);
}

}  // namespace

study::Values completed(const Lab& lab, study::Values values) {
  std::vector<std::pair<std::string, std::string>> formulas;
  for (const Derived& d : lab.derived) {
    formulas.emplace_back(d.name, d.formula);
    values.erase(d.name);  // of other parameters
  }
  try {
    study::derive(formulas, values);
  } catch (const std::invalid_argument& error) {
    throw CaseError({{lab.file.string(), "derived", error.what()}});
  }
  return values;
}

study::Values guesses(const Lab& lab) {
  study::Values values = lab.constants;
  for (const Stage& stage : lab.stages)
    for (const Parameter& p : stage.parameters) values[p.name] = p.guess;
  return completed(lab, std::move(values));
}

Runs::Runs(const Lab& lab, const study::Folder& folder, std::string program, int threads,
           Execute execute)
    : lab_(lab),
      folder_(folder),
      program_(std::move(program)),
      threads_(threads),
      execute_(std::move(execute)) {
  if (lab_.known)
    for (const TableRow& row : read_run_table(*lab_.known)) {
      Known& known = known_[row.case_hash];
      known.status = row.status;
      known.reason = row.reason;
      known.responses[row.response] = row.value;
    }
  find_reach();
}

bool Runs::reaches(const std::string& name, std::size_t test) const {
  const auto found = reach_.find(name);
  return found != reach_.end() && found->second.count(test) > 0;
}

// In the order in which the later wins.
std::vector<std::string> Runs::settings_of(const Wanted& wanted, bool with_parameters) const {
  const Test& test = lab_.tests[wanted.test];
  std::vector<std::string> settings;
  const auto add = [&](const std::vector<study::Setting>& more) {
    for (const study::Setting& setting : more)
      settings.push_back(study::filled(setting, wanted.values));
  };
  const auto lay = [&](const std::string& name, const std::string& key, const std::string& unit) {
    if (!key.empty() && reaches(name, wanted.test))
      settings.push_back(study::key_setting(key, unit, wanted.values.at(name)));
  };
  try {
    add(lab_.settings);
    add(test.settings);
    if (wanted.is_small) add(test.small);
    for (const Stage& stage : lab_.stages)
      for (const Parameter& p : stage.parameters)
        if (with_parameters) lay(p.name, p.key, p.unit);
    for (const Derived& d : lab_.derived)
      if (with_parameters) lay(d.name, d.key, d.unit);
    for (const std::string& set : lab_.sets) settings.push_back(study::filled(set, wanted.values));
  } catch (const std::invalid_argument& error) {
    throw CaseError({{lab_.file.string(), "tests." + test.name + ".settings", error.what()}});
  }
  settings.push_back(fmt::format("seed={}", wanted.seed));
  return settings;
}

bool Runs::takes(const std::string& key, const std::string& unit, double value, std::size_t test,
                 std::vector<Fault>& faults) const {
  const Wanted at_guess{test, false, guesses(lab_), "", 1};
  auto settings = settings_of(at_guess, false);
  settings.push_back(study::key_setting(key, unit, value));
  try {
    casefile::load_case(lab_.tests[test].case_file, settings);
    return true;
  } catch (const CaseError& error) {
    if (faults.empty()) faults = error.faults();
    return false;
  }
}

void Runs::find_reach() {
  std::vector<Case> cases;  // sound without the parameters: else that is told
  for (std::size_t t = 0; t < lab_.tests.size(); ++t)
    for (const bool is_small : {true, false}) {
      Case c = casefile::load_case(lab_.tests[t].case_file,
                                   settings_of({t, is_small, guesses(lab_), "", 1}, false));
      if (!is_small) cases.push_back(std::move(c));
    }
  std::vector<Fault> wrong;
  const study::Values values = guesses(lab_);
  const auto find = [&](const std::string& table, const std::string& name, const std::string& key,
                        const std::string& unit) {
    std::vector<Fault> faults;
    // Contact parameters are known to every case, but act in those with both materials alone.
    for (std::size_t t = 0; t < lab_.tests.size(); ++t)
      if (!key.empty() && has_all(cases[t], pair_of(key)) &&
          takes(key, unit, values.at(name), t, faults))
        reach_[name].insert(t);
    if (key.empty() || !reach_[name].empty()) return;
    if (faults.empty())
      faults = {{lab_.file.string(), table + "." + name + ".key",
                 "no test has both materials of " + key}};
    wrong.insert(wrong.end(), faults.begin(), faults.end());
  };
  for (const Stage& stage : lab_.stages)
    for (const Parameter& p : stage.parameters)
      find("stages." + stage.name + ".unknowns", p.name, p.key, p.unit);
  for (const Derived& d : lab_.derived) find("derived", d.name, d.key, d.unit);
  if (!wrong.empty()) throw CaseError(std::move(wrong));
}

// A run that was made or is known already, or one that is to be looked for in the folder, then in
// the plan.
Outcome Runs::planned(const Wanted& wanted, study::Plan& plan) {
  const Test& test = lab_.tests[wanted.test];
  Outcome outcome{
      fmt::format("{}_{}{}_seed={}", study::safe_name(wanted.label), study::safe_name(test.name),
                  wanted.is_small ? "_small" : "", wanted.seed),
      wanted.test,
      wanted.is_small,
      wanted.seed,
      "",
      "",
      "",
      std::vector<double>(test.targets.size(), nan)};
  study::PlannedRun run;
  run.name = outcome.name;
  planner_.add(plan, std::move(run), test.case_file, settings_of(wanted, true));
  if (!plan.runs.back().fault.empty()) return outcome;
  outcome.case_hash = hash_of(plan.runs.back().case_text);
  for (const Outcome& made : all_)
    if (made.test == wanted.test && made.case_hash == outcome.case_hash) {
      plan.runs.pop_back();
      outcome = made;
      outcome.is_small = wanted.is_small;
      return outcome;
    }
  const auto known = known_.find(outcome.case_hash);
  if (known == known_.end()) return outcome;
  outcome.is_known = true;
  outcome.status = known->second.status;
  outcome.reason = known->second.reason;
  for (std::size_t r = 0; r < test.targets.size(); ++r)
    if (const auto found = known->second.responses.find(test.targets[r].response.name);
        found != known->second.responses.end())
      outcome.responses[r] = found->second;
  plan.runs.pop_back();
  return outcome;
}

double Runs::forecast(const std::vector<Wanted>& wanted) {
  study::Plan plan;
  for (const Wanted& one : wanted) planned(one, plan);
  double seconds = 0.0;
  for (const study::Job& job : folder_.jobs(plan, program_, threads_)) seconds += job.seconds;
  return seconds;
}

std::vector<Outcome> Runs::get(const std::vector<Wanted>& wanted) {
  study::Plan plan;
  std::vector<Outcome> outcomes;
  for (const Wanted& one : wanted) outcomes.push_back(planned(one, plan));
  folder_.write_cases(plan);
  const auto jobs = folder_.jobs(plan, program_, threads_);
  bool is_whole = jobs.empty() || execute_(jobs);
  auto run = plan.runs.begin();
  for (Outcome& outcome : outcomes) {
    if (outcome.status.empty()) {
      std::vector<study::Response> responses;
      const Test& test = lab_.tests[outcome.test];
      for (const Target& t : test.targets) responses.push_back(t.response);
      for (const Limit& limit : test.limits) responses.push_back(limit.figure);
      study::Row row = study::row_of(responses, plan, *run++, folder_);
      hold_to_limits(test, row);
      outcome.status = row.status;
      outcome.reason = row.reason;
      outcome.responses = row.responses;
      if (row.status == "missing") is_whole = false;
    }
    const bool is_new = std::none_of(
        all_.begin(), all_.end(), [&](const Outcome& other) { return other.name == outcome.name; });
    if (is_new && outcome.status != "missing") all_.push_back(outcome);
  }
  write_table();
  if (!is_whole) throw Stopped();
  return outcomes;
}

void Runs::write_table() const {
  std::vector<TableRow> rows;
  for (const Outcome& o : all_)
    for (std::size_t r = 0; r < o.responses.size(); ++r)
      rows.push_back({o.name, o.case_hash, o.status, lab_.tests[o.test].targets[r].response.name,
                      o.responses[r], o.reason});
  write_run_table(folder_.root() / "runs.csv", rows);
}

std::vector<std::string> Runs::warnings() const {
  std::vector<std::string> warnings;
  for (std::size_t t = 0; t < lab_.tests.size(); ++t)
    for (std::size_t r = 0; r < lab_.tests[t].targets.size(); ++r) {
      const auto of_test = [&](const Outcome& o) { return o.test == t && o.status == "completed"; };
      const auto first = std::find_if(all_.begin(), all_.end(), of_test);
      const bool has_figure = std::any_of(all_.begin(), all_.end(), [&](const Outcome& o) {
        return of_test(o) && std::isfinite(o.responses[r]);
      });
      if (first == all_.end() || has_figure || first->is_known) continue;
      warnings.push_back(fmt::format(
          "{}: no run has it: {}", lab_.target_name({t, r}),
          casefile::unknown_word("key of the summaries", lab_.tests[t].targets[r].response.key,
                                 study::keys_of_summary(folder_.root() / "runs" / first->name))));
    }
  return warnings;
}

}  // namespace pmr::calibrate
