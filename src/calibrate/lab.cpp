#include "calibrate/lab.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "case/nearest.hpp"
#include "study/file_parts.hpp"

namespace pmr::calibrate {
namespace {

namespace fs = std::filesystem;
using casefile::Node;
using casefile::Table;

constexpr double default_floor = 0.01;  // [1] of the measured value

// At most what a grid of the posterior can hold.
constexpr std::size_t most_parameters = 3;

// {value, standard_error or relative_standard_error, runs, source}
void read_result(Table& parent, Target& target) {
  const Node* node =
      parent.need("result", "{value = 26.8, relative_standard_error = 0.008, source = \"...\"}");
  if (node == nullptr || !node->is_table()) {
    if (node != nullptr) parent.fault("result", "wanted {value, relative_standard_error, source}");
    return;
  }
  Table table(parent.reading(), *node, parent.path("result"));
  target.value = table.value("value", casefile::a_number);
  const auto error =
      table.maybe("standard_error", {casefile::Dimension::none, casefile::not_negative});
  const auto relative =
      table.maybe("relative_standard_error", {casefile::Dimension::none, casefile::not_negative});
  if (error.has_value() == relative.has_value())
    table.fault("", "wanted either standard_error or relative_standard_error");
  target.error = error ? *error : relative ? *relative * std::abs(target.value) : nan;
  target.runs = table.count("runs", 1, 1);
  target.source = table.word("source", "where the value comes from, in quotes");
}

Target read_target(Table& table, const std::string& name) {
  Target target;
  study::check_name(table, name);
  target.response = study::read_response(table, name);
  read_result(table, target);
  target.is_logarithmic = table.has("scale") && table.choice("scale", {"linear", "log"}) == "log";
  if (target.is_logarithmic && target.value <= 0.0)
    table.fault("scale", "wanted a measured value above 0 with scale \"log\"");
  const casefile::Want an_error{casefile::Dimension::none, casefile::not_negative};
  target.floor = table.value("floor", an_error, default_floor * std::abs(target.value));
  target.discrepancy = table.value("discrepancy", an_error, 0.0);
  target.beyond = table.maybe("beyond", casefile::a_number);
  if (target.beyond && *target.beyond <= target.value)
    table.fault("beyond", "wanted above the measured value");
  if (target.error == 0.0 && target.floor == 0.0 && target.discrepancy == 0.0)
    table.fault("floor", "wanted above 0 where the measured value has no error");
  return target;
}

Test read_test(Table& table, const std::string& name, std::size_t predictions) {
  Test test;
  test.name = name;
  test.label = table.word_or("label", name);
  test.case_file = study::read_case_name(table);
  test.settings = study::read_settings(table);
  test.small = study::read_settings(table, "small");
  test.pairs = table.count("pairs", 2, 4);
  test.predictions = table.count("predictions", 0, predictions);
  test.synthetic = table.count("synthetic", 2, test.synthetic);
  if (test.small.empty() && table.has("pairs"))
    table.fault("pairs", "goes with [..small]: settings of a cheaper sample");
  for (const study::Setting& limit : study::read_settings(table, "at_most")) {
    if (limit.value.kind != Node::Kind::number)
      table.reading().fault(limit.value.place, table.path("at_most"),
                            "wanted a number for each key of summary.json");
    study::Response figure;
    figure.name = figure.key = limit.key;
    test.limits.push_back({figure, limit.value.number});
  }
  if (table.need("responses", "a table for each figure that was measured") != nullptr)
    study::for_each_in_order(table, "responses", [&](Table& inner, const std::string& response) {
      test.targets.push_back(read_target(inner, response));
    });
  return test;
}

std::optional<statistics::Normal> read_prior(Table& parent) {
  const Node* node = parent.look("prior");
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) {
    parent.fault("prior", "wanted {mean = .., sd = ..}");
    return std::nullopt;
  }
  Table table(parent.reading(), *node, parent.path("prior"));
  statistics::Normal prior{};
  prior.mean = table.value("mean", casefile::a_number);
  prior.deviation = table.value("sd", casefile::a_positive_number);
  return prior;
}

Parameter read_parameter(Table& table, const std::string& name) {
  Parameter p;
  p.name = name;
  study::check_name(table, name);
  p.label = table.word_or("label", name);
  p.unit = table.word_or("unit", "");
  p.key = table.word_or("key", "");
  p.source = table.word_or("source", "");
  p.box.low = table.value("from", casefile::a_number);
  p.box.high = table.value("to", casefile::a_number);
  p.box.is_logarithmic =
      table.has("spacing") && table.choice("spacing", {"linear", "log"}) == "log";
  if (p.box.high <= p.box.low) table.fault("to", "wanted above 'from'");
  if (p.box.is_logarithmic && p.box.low <= 0.0)
    table.fault("from", "wanted above 0 with spacing \"log\"");
  p.guess = table.value("guess", casefile::a_number, statistics::value_at(p.box, 0.5));
  p.prior = read_prior(table);
  p.reference = table.maybe("reference", casefile::a_number);
  return p;
}

Sampling read_sampling(Table& table, const Sampling& otherwise) {
  Sampling s = otherwise;
  s.points = table.count("points", 4, otherwise.points);
  s.most = table.count("most", 4, std::max(s.points, otherwise.most));
  s.replicated = table.count("replicated", 0, std::min(s.points, otherwise.replicated));
  s.replicates = table.count("replicates", 1, otherwise.replicates);
  s.batch = table.count("batch", 1, otherwise.batch);
  s.seed = table.count("seed", 0, otherwise.seed);
  if (s.most < s.points) table.fault("most", "wanted at least as many as 'points'");
  if (s.replicated > s.points) table.fault("replicated", "wanted at most as many as 'points'");
  return s;
}

// "TEST.RESPONSE", or "TEST" for all that was measured in it.
std::vector<TargetIndex> read_use(Table& table, const std::string& key, const Lab& lab) {
  std::vector<TargetIndex> found;
  const Node* node = table.look(key);
  if (node == nullptr) return found;
  if (node->kind != Node::Kind::array) {
    table.fault(key, "wanted a list of \"TEST.RESPONSE\"");
    return found;
  }
  for (const Node& item : node->items) {
    const std::size_t before = found.size();
    std::vector<std::string> names;
    for (std::size_t t = 0; t < lab.tests.size(); ++t)
      for (std::size_t r = 0; r < lab.tests[t].targets.size(); ++r) {
        names.push_back(lab.target_name({t, r}));
        if (item.text == names.back() || item.text == lab.tests[t].name) found.push_back({t, r});
      }
    if (found.size() == before)
      table.reading().fault(item.place, table.path(key),
                            casefile::unknown_word("response of a test", item.text, names));
  }
  return found;
}

Stage read_stage(Table& table, const std::string& name, const Lab& lab, const Sampling& sampling) {
  Stage stage;
  stage.name = name;
  stage.title = table.word_or("title", "stage " + name);
  table.need("use", "a list of \"TEST.RESPONSE\"");
  stage.use = read_use(table, "use", lab);
  stage.decide = read_use(table, "decide", lab);
  if (table.need("unknowns", "a table for each parameter to be found") != nullptr)
    study::for_each_in_order(table, "unknowns", [&](Table& inner, const std::string& parameter) {
      stage.parameters.push_back(read_parameter(inner, parameter));
    });
  if (stage.parameters.size() > most_parameters)
    table.fault("unknowns", fmt::format("wanted at most {}: make stages of them", most_parameters));
  stage.sampling = sampling;
  if (const Node* node = table.look_table("sampling")) {
    Table inner(table.reading(), *node, table.path("sampling"));
    stage.sampling = read_sampling(inner, sampling);
  }
  return stage;
}

Derived read_derived(Table& table, const std::string& name) {
  Derived d;
  d.name = name;
  study::check_name(table, name);
  d.label = table.word_or("label", name);
  d.unit = table.word_or("unit", "");
  d.key = table.word_or("key", "");
  d.formula = table.word("formula", study::wanted_formula);
  d.reference = table.maybe("reference", casefile::a_number);
  return d;
}

// Names of parameters, constants and what is derived stand for one value each.
void check_once(Table& root, const Lab& lab) {
  std::set<std::string> seen;
  for (const auto& [name, value] : lab.constants) seen.insert(name);
  const auto add = [&](const std::string& table, const std::string& name) {
    if (!seen.insert(name).second) root.fault(table, "'" + name + "' is named twice");
  };
  for (const Stage& stage : lab.stages)
    for (const Parameter& p : stage.parameters) add("stages", p.name);
  for (const Derived& d : lab.derived) add("derived", d.name);
}

Lab read_root(casefile::Reading& reading, const Node& document) {
  Table root(reading, document, "");
  Lab lab;
  lab.title = root.word("title", "a text in quotes");
  lab.teaches = root.word("teaches", "a paragraph on what the calibration is for");
  lab.constants = study::read_constants(root);
  lab.settings = study::read_settings(root);
  const std::size_t predictions = root.count("predictions", 0, Test{}.predictions);
  lab.rounds = root.count("rounds", 0, lab.rounds);
  if (root.has("known")) {
    const Node* node = root.look("known");
    lab.known = fs::absolute(node->place.file).parent_path() / root.word_or("known", "");
    if (!fs::is_regular_file(*lab.known))
      root.fault("known", "there is no table of runs " + lab.known->string());
  }
  Sampling sampling{12, 36, 4, 3, 1, 1};
  if (const Node* node = root.look_table("sampling")) {
    Table table(reading, *node, "sampling");
    sampling = read_sampling(table, sampling);
  }
  if (root.need("tests", "a table for each test") != nullptr)
    study::for_each_in_order(root, "tests", [&](Table& table, const std::string& name) {
      lab.tests.push_back(read_test(table, name, predictions));
    });
  if (root.need("stages", "a table for each stage") != nullptr)
    study::for_each_in_order(root, "stages", [&](Table& table, const std::string& name) {
      lab.stages.push_back(read_stage(table, name, lab, sampling));
    });
  study::for_each_in_order(root, "derived", [&](Table& table, const std::string& name) {
    lab.derived.push_back(read_derived(table, name));
  });
  check_once(root, lab);
  return lab;
}

}  // namespace

Lab read_lab(const fs::path& file, const std::vector<std::string>& sets) {
  Node document = study::document_of(file, "lab");
  casefile::Reading reading;
  Lab lab = read_root(reading, document);
  reading.finish();
  lab.file = file;
  if (lab.known) document.members.at("known").text = lab.known->string();
  lab.text = casefile::write_toml(document);
  lab.sets = study::apply_to_constants(sets, lab.constants);
  return lab;
}

}  // namespace pmr::calibrate
