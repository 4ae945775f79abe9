#include "study/file_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <tuple>

#include "pmr/base/text.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;
using casefile::Node;
using casefile::Table;

constexpr int deepest = 8;  // files that lie on one another

std::string asked_text(const fs::path& file, const std::string& noun) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file))
    throw CaseError({{file.string(), "", "cannot be read; wanted a " + noun + " file"}});
  return {std::istreambuf_iterator<char>(in), {}};
}

// Names of case files, wherever they stand, as absolute ones: the text is to mean the same in
// another folder.
void make_cases_absolute(Node& table, const fs::path& folder) {
  for (auto& [key, node] : table.members) {
    if (key == "case" && node.kind == Node::Kind::string)
      node.text = (folder / node.text).lexically_normal().string();
    if (node.is_table()) make_cases_absolute(node, folder);
  }
}

// A table that changes one of the base stands where that one stands: its order is told by its
// place.
void keep_places(Node& over, const Node& base) {
  over.place = base.place;
  for (auto& [key, node] : over.members)
    if (const Node* below = base.find(key); below && below->is_table() && node.is_table())
      keep_places(node, *below);
}

}  // namespace

bool is_name(const std::string& word) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !word.empty() && letter(word.front()) &&
         std::all_of(word.begin(), word.end(), [&](char c) {
           return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

std::vector<std::pair<std::string, const Node*>> in_order(const Node* table) {
  std::vector<std::pair<std::string, const Node*>> all;
  if (table == nullptr) return all;
  for (const auto& [name, node] : table->members) all.emplace_back(name, &node);
  const auto order = [&](const Node& node) {  // those of the file that it lies on come first
    const casefile::Place& at = node.place;
    return std::tuple(at.file != table->place.file, at.file, at.line, at.column);
  };
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return order(*a.second) < order(*b.second);
  });
  return all;
}

std::vector<Setting> read_settings(Table& table, const std::string& key) {
  std::vector<Setting> settings;
  for (const auto& [name, node] : in_order(table.look_table(key)))
    settings.push_back({name, *node});
  return settings;
}

void check_name(Table& table, const std::string& name) {
  if (!is_name(name))
    table.fault(
        "", fmt::format("'{}' cannot stand in an expression; wanted letters, digits and _", name));
}

std::map<std::string, double> read_constants(Table& root) {
  std::map<std::string, double> constants;
  for (const auto& [name, node] : in_order(root.look_table("constants"))) {
    if (node->kind != Node::Kind::number)
      root.reading().fault(node->place, "constants." + name, "wanted a number");
    constants[name] = node->number;
  }
  return constants;
}

Response read_response(Table& table, const std::string& name) {
  Response response;
  response.name = name;
  response.key = table.word("key", "a key of summary.json such as \"yield/oxygen_per_kg\"");
  read_shown(table, response);
  return response;
}

fs::path read_case_name(Table& table) {
  const std::string base = table.word("case", "the name of the base case's file");
  if (base.empty()) return {};
  const fs::path folder = fs::absolute(table.look("case")->place.file).parent_path();
  fs::path file = folder / base;
  if (!fs::is_regular_file(file)) table.fault("case", "there is no case file " + file.string());
  return file;
}

std::vector<std::string> apply_to_constants(const std::vector<std::string>& sets,
                                            std::map<std::string, double>& constants) {
  std::vector<std::string> left;
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    const std::string key = set.substr(0, equals);
    const auto constant = constants.find(key);
    if (constant == constants.end()) {
      left.push_back(set);
      continue;
    }
    const std::string value = equals == std::string::npos ? "" : set.substr(equals + 1);
    const std::optional<double> number = finite_number(value);
    if (!number) throw CaseError({{"--set " + set, key, "wanted a number for this constant"}});
    constant->second = *number;
  }
  return left;
}

Node document_of(const fs::path& file, const std::string& noun, int depth) {
  Node document = casefile::parse_toml(asked_text(file, noun), file.string());
  make_cases_absolute(document, fs::absolute(file).parent_path());
  const Node* extends = document.find("extends");
  if (extends == nullptr) return document;
  const std::string place = to_string(extends->place);
  if (depth == deepest)
    throw CaseError({{place, "extends", "the files extend each other in a circle"}});
  const fs::path base_file = fs::absolute(file).parent_path() / extends->text;
  if (extends->kind != Node::Kind::string || !fs::is_regular_file(base_file))
    throw CaseError({{place, "extends", "there is no " + noun + " file " + base_file.string()}});
  Node base = document_of(base_file, noun, depth + 1);
  document.members.erase("extends");
  keep_places(document, base);
  casefile::merge(base, document);
  return base;
}

}  // namespace pmr::study
