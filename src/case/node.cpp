#include "case/node.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "pmr/base/errors.hpp"

namespace pmr::casefile {
namespace {

std::string written_key(const std::string& key) {
  bool bare = !key.empty();
  for (const char c : key)
    bare = bare && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-');
  return bare ? key : quoted(key);
}

std::string written_number(const Node& node) {
  if (std::isnan(node.number)) return "nan";
  if (std::isinf(node.number)) return node.number > 0 ? "inf" : "-inf";
  if (node.is_integer) return fmt::format("{:.0f}", node.number);
  const std::string text = fmt::format("{}", node.number);  // shortest that reads back exactly
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

bool stands_on_its_own(const Node& node) { return node.is_table() && !node.is_inline; }

void write_table(const Node& table, const std::string& path, std::string& out) {
  for (const auto& [key, node] : table.members)
    if (!stands_on_its_own(node)) out += written_key(key) + " = " + write_value(node) + "\n";
  for (const auto& [key, node] : table.members) {
    if (!stands_on_its_own(node)) continue;
    const std::string inner = path.empty() ? written_key(key) : path + "." + written_key(key);
    out += "\n[" + inner + "]\n";
    write_table(node, inner, out);
  }
}

// Calls look(node, path) for a node and all below it, from above.
template <class Look>
void visit_members(Node& node, const std::string& path, const Look& look) {
  look(node, path);
  for (auto& [key, member] : node.members) visit_members(member, joined(path, key), look);
  for (std::size_t k = 0; k < node.items.size(); ++k)
    visit_members(node.items[k], joined(path, std::to_string(k)), look);
}

// A table that loses all its keys goes with them.
Node left_of(const Node& node, const std::set<std::string>& paths, const std::string& path) {
  Node left = node;
  left.members.clear();
  for (const auto& [key, member] : node.members) {
    const std::string inner = joined(path, key);
    if (paths.contains(inner)) continue;
    Node kept = left_of(member, paths, inner);
    if (kept.members.empty() && !member.members.empty()) continue;
    left.members.emplace(key, std::move(kept));
  }
  for (std::size_t k = 0; k < node.items.size(); ++k)
    left.items[k] = left_of(node.items[k], paths, joined(path, std::to_string(k)));
  return left;
}

bool is_all_digits(const std::string& text) {
  if (text.empty() || text.size() > 9) return false;
  for (const char c : text)
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) return false;
  return true;
}

void mark_place(Node& node, const Place& place) {
  node.place = place;
  for (auto& [key, member] : node.members) mark_place(member, place);
  for (Node& item : node.items) mark_place(item, place);
}

[[noreturn]] void refuse(const std::string& setting, const std::string& problem) {
  throw CaseError({{"--set " + setting, "", problem}});
}

// The element of an array that a --set names by its index.
Node& element(Node& array, const std::string& key, const std::string& setting) {
  if (!is_all_digits(key) || std::stoul(key) >= array.items.size())
    refuse(setting, fmt::format("'{}' is no index into a list of {} (0 is the first)", key,
                                array.items.size()));
  return array.items[std::stoul(key)];
}

Node& place_for(Node& node, const std::string& key, const std::string& setting) {
  if (node.kind == Node::Kind::array) return element(node, key, setting);
  if (!node.is_table()) {
    node = Node{};
    node.place.file = "--set " + setting;
  }
  Node& member = node.members[key];
  if (member.place.file.empty()) member.place.file = "--set " + setting;
  return member;
}

// A law or a kind comes whole, and so does a figure; a constant of a law may come alone.
bool states_itself(const Node& over, const Node& base) {
  const bool has_law = base.find("law") != nullptr || base.find("kind") != nullptr;
  return over.find("law") != nullptr || over.find("kind") != nullptr ||
         (!has_law && (over.find("value") != nullptr || base.find("value") != nullptr));
}

// What is changed is no longer what the source says.
void disown(Node& base, const Node& over) {
  Node& source = base.members["source"];
  source.text = "with values of the case; " + source.text;
  if (base.find("mark") == nullptr) return;  // as in lab files
  Node mark;
  mark.kind = Node::Kind::string;
  mark.place = over.place;
  mark.text = "A";
  base.members["mark"] = mark;
}

}  // namespace

std::string to_string(const Place& place) {
  if (place.line == 0) return place.file;
  return fmt::format("{}:{}:{}", place.file, place.line, place.column);
}

std::string joined(const std::string& table, const std::string& key) {
  const std::string shown = key.find_first_of(".| ") == std::string::npos ? key : '"' + key + '"';
  return table.empty() ? shown : table + "." + shown;
}

Node without(const Node& table, const std::set<std::string>& paths) {
  return left_of(table, paths, "");
}

Node with_texts(const Node& table, const std::map<std::string, std::string>& texts) {
  Node changed = table;
  visit_members(changed, "", [&](Node& node, const std::string& path) {
    if (const auto found = texts.find(path); found != texts.end()) node.text = found->second;
  });
  return changed;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

const Node* Node::find(const std::string& key) const {
  const auto found = members.find(key);
  return found == members.end() ? nullptr : &found->second;
}

std::string write_value(const Node& node) {
  std::string out;
  switch (node.kind) {
    case Node::Kind::table:
      for (const auto& [key, member] : node.members)
        out += (out.empty() ? "" : ", ") + written_key(key) + " = " + write_value(member);
      return "{" + out + "}";
    case Node::Kind::array:
      for (const Node& item : node.items) out += (out.empty() ? "" : ", ") + write_value(item);
      return "[" + out + "]";
    case Node::Kind::string:
      return quoted(node.text);
    case Node::Kind::number:
      return written_number(node);
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::other:
      break;
  }
  return "1970-01-01";  // some date: no key wants one, so its value never matters
}

std::string write_toml(const Node& table) {
  std::string out;
  write_table(table, "", out);
  return out;
}

void apply_setting(Node& root, const std::string& setting) {
  Node document;
  try {
    document = parse_toml(setting, "--set");
  } catch (const CaseError&) {
    refuse(setting,
           "wanted dotted.key=VALUE with a TOML value such as 3, true or '\"2 kg\"' "
           "(a text keeps its double quotes)");
  }
  Node* target = &root;
  const Node* value = &document;
  while (stands_on_its_own(*value)) {
    if (value->members.size() != 1) refuse(setting, "wanted exactly one dotted.key=VALUE");
    const auto& [key, inner] = *value->members.begin();
    target = &place_for(*target, key, setting);
    value = &inner;
  }
  *target = *value;
  mark_place(*target, {"--set " + setting, 0, 0});
}

void merge(Node& base, const Node& over) {
  if (!base.is_table() || !over.is_table() || states_itself(over, base)) {
    base = over;
    return;
  }
  base.place = over.place;
  if (base.find("source") != nullptr && over.find("source") == nullptr) disown(base, over);
  for (const auto& [key, node] : over.members) {
    const auto found = base.members.find(key);
    if (found == base.members.end())
      base.members.emplace(key, node);
    else
      merge(found->second, node);
  }
}

}  // namespace pmr::casefile
