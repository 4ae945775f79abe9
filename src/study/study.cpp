#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/correlated.hpp"
#include "study/file_parts.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;
using casefile::Node;
using casefile::Table;

std::vector<Level> read_levels(Table& table) {
  std::vector<Level> levels;
  const Node* node = table.look("levels");
  if (node == nullptr) return levels;
  if (node->kind != Node::Kind::array) {
    table.fault("levels", "wanted a list of {name = \"...\", settings = {...}}");
    return levels;
  }
  for (std::size_t k = 0; k < node->items.size(); ++k) {
    const std::string path = fmt::format("{}.{}", table.path("levels"), k);
    if (!node->items[k].is_table()) {
      table.reading().fault(node->items[k].place, path, "wanted {name, settings}");
      continue;
    }
    Table one(table.reading(), node->items[k], path);
    levels.push_back({one.word("name", "a text in quotes"), read_settings(one)});
  }
  return levels;
}

// from .. to in `count` equal steps, of the logarithm where that is asked for.
std::vector<double> spread(const Variable& v, std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(count - 1);
    values.push_back(v.is_logarithmic ? v.low * std::pow(v.high / v.low, part)
                                      : v.low + part * (v.high - v.low));
  }
  return values;
}

void read_span(Table& table, Variable& v) {
  v.low = table.value("from", casefile::a_number);
  v.high = table.value("to", casefile::a_number);
  if (v.high <= v.low) table.fault("to", "wanted above 'from'");
  if (v.is_logarithmic && !(v.low > 0.0))
    table.fault("from", "wanted above 0 with spacing \"log\"");
}

Variable read_variable(Table& table, const std::string& name, DesignKind design) {
  Variable v;
  v.name = name;
  check_name(table, name);
  v.label = table.word_or("label", name);
  v.unit = table.word_or("unit", "");
  v.key = table.word_or("key", "");
  v.source = table.word_or("source", "");
  v.levels = read_levels(table);
  const bool is_sampled = design != DesignKind::grid;
  for (const char* key : {"values", "from", "to", "count", "spacing"}) table.look(key);
  const int ways = int(table.has("values")) + int(table.has("from")) + int(table.has("levels"));
  if (ways != 1) table.fault("", "wanted one of: values; from and to; levels");
  if (table.has("count") && (is_sampled || !table.has("from")))
    table.fault("count", "goes with 'from' and 'to' of a grid alone");
  v.is_logarithmic = table.has("spacing") && table.choice("spacing", {"linear", "log"}) == "log";
  if (table.has("values")) v.values = table.values("values", casefile::a_number);
  if (v.is_logarithmic &&
      std::any_of(v.values.begin(), v.values.end(), [](double x) { return !(x > 0.0); }))
    table.fault("values", "wanted above 0 with spacing \"log\"");
  if (table.has("from")) {
    read_span(table, v);
    if (!is_sampled) v.values = spread(v, table.count("count", 2));
  }
  if (is_sampled && ways == 1 && !table.has("from"))
    table.fault("", "a sampled design wants 'from' and 'to' of every variable");
  if (ways == 1 && !is_sampled && v.levels.empty() && v.values.empty())
    table.fault("values", "wanted at least one value");
  return v;
}

Design read_design(Table& root) {
  Design design;
  const Node* node = root.look_table("design");
  if (node == nullptr) return design;
  Table table(root.reading(), *node, "design");
  const std::string kind = table.choice("kind", {"grid", "latin-hypercube", "sobol"});
  if (kind == "latin-hypercube") design.kind = DesignKind::latin_hypercube;
  if (kind == "sobol") design.kind = DesignKind::sobol;
  if (design.kind == DesignKind::grid) return design;
  design.samples = table.count("samples", 2);
  if (design.kind == DesignKind::latin_hypercube) design.seed = table.count("seed", 0, 1);
  return design;
}

std::optional<TradeOff> read_trade_off(Table& root, const std::vector<Response>& responses) {
  const Node* node = root.look_table("trade_off");
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "trade_off");
  std::vector<std::string> names;
  for (const Response& response : responses) names.push_back(response.name);
  TradeOff trade;
  trade.gain = table.choice("gain", names);
  trade.cost = table.choice("cost", names);
  return trade;
}

Study read_root(casefile::Reading& reading, const Node& document, const fs::path& file) {
  Table root(reading, document, "");
  Study study;
  study.file = file;
  study.title = root.word("title", "a text in quotes");
  study.teaches = root.word("teaches", "a paragraph on what the study is for");
  study.case_file = read_case_name(root);
  study.replicates = root.count("replicates", 1, 1);
  study.constants = read_constants(root);
  study.design = read_design(root);
  if (!root.has("correlated")) root.need("variables", "a table for each variable");
  for_each_in_order(root, "variables", [&](Table& table, const std::string& name) {
    study.variables.push_back(read_variable(table, name, study.design.kind));
    study.constants.erase(name);  // of a study that this one extends: varied here
  });
  for_each_in_order(root, "correlated", [&](Table& table, const std::string& name) {
    read_correlated(table, name, study);
  });
  study.settings = read_settings(root);
  for (const auto& [name, node] : in_order(root.look_table("derived"))) {
    if (node->kind != Node::Kind::string)
      reading.fault(node->place, "derived." + name, wanted_formula);
    study.derived.emplace_back(name, node->text);
  }
  if (root.need("responses", "a table for each figure looked for") != nullptr)
    for_each_in_order(root, "responses", [&](Table& table, const std::string& name) {
      study.responses.push_back(read_response(table, name));
    });
  for_each_in_order(root, "bands", [&](Table& table, const std::string& name) {
    Band band;
    band.name = name;
    band.column = table.word("column", "a column of the series such as \"pressure\"");
    read_shown(table, band);
    study.bands.push_back(band);
  });
  study.trade_off = read_trade_off(root, study.responses);
  return study;
}

}  // namespace

Study read_study(const fs::path& file, const std::vector<std::string>& sets) {
  const Node document = document_of(file, "study");
  casefile::Reading reading;
  Study study = read_root(reading, document, file);
  reading.finish();
  study.text = casefile::write_toml(document);
  study.sets = apply_to_constants(sets, study.constants);
  return study;
}

}  // namespace pmr::study
