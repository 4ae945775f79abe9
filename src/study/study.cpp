#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "case/nearest.hpp"
#include "case/reader.hpp"
#include "pmr/base/text.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;
using casefile::Node;
using casefile::Table;

// Members of a table in the order of the file.
std::vector<std::pair<std::string, const Node*>> in_order(const Node* table) {
  std::vector<std::pair<std::string, const Node*>> all;
  if (table == nullptr) return all;
  for (const auto& [name, node] : table->members) all.emplace_back(name, &node);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    const auto &p = a.second->place, &q = b.second->place;
    return p.line != q.line ? p.line < q.line : p.column < q.column;
  });
  return all;
}

template <class Read>
void for_each_in_order(Table& root, const std::string& key, const Read& read) {
  for (const auto& [name, node] : in_order(root.look_table(key))) {
    if (!node->is_table()) {
      root.reading().fault(node->place, key + "." + name, "wanted a table");
      continue;
    }
    Table table(root.reading(), *node, key + "." + name);
    read(table, name);
  }
}

std::vector<Setting> read_settings(Table& table) {
  std::vector<Setting> settings;
  for (const auto& [key, node] : in_order(table.look_table("settings")))
    settings.push_back({key, *node});
  return settings;
}

bool is_name(const std::string& word) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !word.empty() && letter(word.front()) &&
         std::all_of(word.begin(), word.end(), [&](char c) {
           return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

void check_name(Table& table, const std::string& name) {
  if (!is_name(name))
    table.fault(
        "", fmt::format("'{}' cannot stand in an expression; wanted letters, digits and _", name));
}

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

template <class Shown>
void read_shown(Table& table, Shown& shown) {
  shown.label = table.word_or("label", shown.name);
  shown.unit = table.word_or("unit", "");
  shown.factor = table.value("factor", casefile::a_number, 1.0);
  shown.offset = table.value("offset", casefile::a_number, 0.0);
}

void read_constants(Table& root, Study& study) {
  for (const auto& [name, node] : in_order(root.look_table("constants"))) {
    if (node->kind != Node::Kind::number)
      root.reading().fault(node->place, "constants." + name, "wanted a number");
    study.constants[name] = node->number;
  }
}

void read_derived(Table& root, Study& study) {
  for (const auto& [name, node] : in_order(root.look_table("derived"))) {
    if (node->kind != Node::Kind::string)
      root.reading().fault(node->place, "derived." + name,
                           "wanted an expression in quotes such as \"(scale * ratio)^(1/3)\"");
    study.derived.emplace_back(name, node->text);
  }
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
  const std::string base = root.word("case", "the name of the base case's file");
  study.case_file = fs::absolute(file).parent_path() / base;
  if (!base.empty() && !fs::is_regular_file(study.case_file))
    root.fault("case", "there is no case file " + study.case_file.string());
  study.replicates = root.count("replicates", 1, 1);
  read_constants(root, study);
  study.design = read_design(root);
  if (root.need("variables", "a table for each variable") != nullptr)
    for_each_in_order(root, "variables", [&](Table& table, const std::string& name) {
      study.variables.push_back(read_variable(table, name, study.design.kind));
      study.constants.erase(name);  // of a study that this one extends: varied here
    });
  study.settings = read_settings(root);
  read_derived(root, study);
  if (root.need("responses", "a table for each figure looked for") != nullptr)
    for_each_in_order(root, "responses", [&](Table& table, const std::string& name) {
      Response response;
      response.name = name;
      response.key = table.word("key", "a key of summary.json such as \"yield/oxygen_per_kg\"");
      read_shown(table, response);
      study.responses.push_back(response);
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

std::string study_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file))
    throw CaseError({{file.string(), "", "cannot be read; wanted a study file"}});
  return {std::istreambuf_iterator<char>(in), {}};
}

// "scale=1" changes a constant of that name; anything else is a setting of the cases.
void apply(Study& study, const std::string& set) {
  const std::size_t equals = set.find('=');
  const std::string key = set.substr(0, equals);
  const auto constant = study.constants.find(key);
  if (constant == study.constants.end()) {
    study.sets.push_back(set);
    return;
  }
  const std::string value = equals == std::string::npos ? "" : set.substr(equals + 1);
  const std::optional<double> number = finite_number(value);
  if (!number)
    throw CaseError({{"--set " + set, key, "wanted a number for this constant of the study"}});
  constant->second = *number;
}

// A study may lie on another: tables are merged, anything else is replaced.
Node document_of(const fs::path& file) {
  Node document = casefile::parse_toml(study_text(file), file.string());
  const Node* extends = document.find("extends");
  if (extends == nullptr) return document;
  const fs::path base_file = fs::absolute(file).parent_path() / extends->text;
  if (extends->kind != Node::Kind::string || !fs::is_regular_file(base_file))
    throw CaseError(
        {{to_string(extends->place), "extends", "there is no study file " + base_file.string()}});
  Node base = casefile::parse_toml(study_text(base_file), base_file.string());
  if (const auto found = base.members.find("case"); found != base.members.end())
    found->second.text = fs::absolute(base_file.parent_path() / found->second.text).string();
  document.members.erase("extends");
  casefile::merge(base, document);
  return base;
}

}  // namespace

Study read_study(const fs::path& file, const std::vector<std::string>& sets) {
  const Node document = document_of(file);
  casefile::Reading reading;
  Study study = read_root(reading, document, file);
  reading.finish();
  study.text = casefile::write_toml(document);
  for (const std::string& set : sets) apply(study, set);
  return study;
}

}  // namespace pmr::study
