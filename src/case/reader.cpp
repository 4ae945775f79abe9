#include "case/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/nearest.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

std::string range_text(Range range) {
  const bool bounded_above = std::isfinite(range.high);
  if (std::isfinite(range.low) && bounded_above)
    return fmt::format("between {} and {}", range.low, range.high);
  if (bounded_above) return fmt::format("{} {}", range.high_open ? "below" : "at most", range.high);
  return fmt::format("{} {}", range.low_open ? "above" : "at least", range.low);
}

const char* kind_name(const Node& node) {
  switch (node.kind) {
    case Node::Kind::table:
      return "a table";
    case Node::Kind::array:
      return "a list";
    case Node::Kind::string:
      return "a text";
    case Node::Kind::number:
      return "a bare number";
    case Node::Kind::boolean:
      return "true or false";
    case Node::Kind::other:
      break;
  }
  return "a date or time";
}

// The rest of a figure: everything but its mark, source and range.
std::string figure_value(const Node& node) {
  if (node.kind == Node::Kind::string) return node.text;
  if (!node.is_table()) return write_value(node);
  if (const Node* value = node.find("value"); value != nullptr && node.find("law") == nullptr)
    return figure_value(*value);
  Node rest = node;
  for (const char* key : {"mark", "source", "range"}) rest.members.erase(key);
  return write_value(rest);
}

}  // namespace

void Reading::fault(const Place& place, const std::string& key, const std::string& problem) {
  faults_.push_back({place, {to_string(place), key, problem}});
}

void Reading::finish() {
  if (faults_.empty()) return;
  std::stable_sort(faults_.begin(), faults_.end(), [](const auto& a, const auto& b) {
    const Place &p = a.first, &q = b.first;
    return p.line != q.line ? p.line < q.line : p.column < q.column;
  });
  std::vector<Fault> sorted;
  for (const auto& [place, fault] : faults_) sorted.push_back(fault);
  throw CaseError(std::move(sorted));
}

Table::Table(Reading& reading, const Node& node, std::string path)
    : reading_(reading), node_(node), path_(std::move(path)) {}

Table::~Table() {
  report_unknown();
  for (const Missing& missing : missing_)
    reading_.fault(node_.place, path(missing.key), "is missing; wanted " + missing.wanted);
}

// A misspelt key also leaves the right one missing: that is one fault, told once.
void Table::report_unknown() {
  std::vector<std::string> free;
  for (const std::string& key : asked_)
    if (node_.find(key) == nullptr) free.push_back(key);
  for (const auto& [key, member] : node_.members) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    const std::string meant = nearest(key, free);
    reading_.fault(member.place, path(key),
                   unknown_word("key", key, meant.empty() ? asked_ : free));
    std::erase_if(missing_, [&](const Missing& missing) { return missing.key == meant; });
  }
}

std::string Table::path(const std::string& key) const { return joined(path_, key); }

void Table::fault(const std::string& key, const std::string& problem) {
  const Node* node = node_.find(key);
  reading_.fault(node == nullptr ? node_.place : node->place, key.empty() ? path_ : path(key),
                 problem);
}

void Table::ignore_rest() {
  for (const auto& [key, member] : node_.members) asked_.push_back(key);
}

const Node* Table::look(const std::string& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) {
    asked_.push_back(key);
    reading_.asked_for.insert(path(key));
  }
  return node_.find(key);
}

const Node* Table::need(const std::string& key, const std::string& wanted) {
  const Node* node = look(key);
  if (node == nullptr) missing_.push_back({key, wanted});
  return node;
}

const Node* Table::need_table(const std::string& key) {
  if (need(key, "a table") == nullptr) return nullptr;
  return look_table(key);
}

const Node* Table::look_table(const std::string& key) {
  const Node* node = look(key);
  if (node == nullptr || node->is_table()) return node;
  fault(key, fmt::format("is {}; wanted a table", kind_name(*node)));
  return nullptr;
}

void Table::check_range(const std::string& key, const Node& node, Want want, double value) {
  if (!want.range.holds(value))
    reading_.fault(node.place, path(key),
                   fmt::format("{} is out of range; wanted {}, {}", figure_value(node),
                               wanted(want.dimension), range_text(want.range)));
}

// Numbers of a plain value, in SI.
std::vector<double> Table::numbers(const std::string& key, const Node& node, Want want) {
  const auto refuse = [&](const std::string& problem) {
    reading_.fault(node.place, path(key), problem);
    return std::vector<double>{};
  };
  const bool dimensionless = want.dimension == Dimension::none;
  if (!dimensionless && node.kind == Node::Kind::string) {
    Quantities parsed = reading_.units.parse(node.text, want.dimension);
    return parsed.problem.empty() ? std::move(parsed.values) : refuse(parsed.problem);
  }
  if (node.kind == Node::Kind::number) {
    if (!std::isfinite(node.number))
      return refuse(
          fmt::format("{} is not finite; wanted {}", write_value(node), wanted(want.dimension)));
    if (dimensionless) return {node.number};
    return refuse(
        fmt::format("{} has no unit; wanted {}", write_value(node), wanted(want.dimension)));
  }
  if (dimensionless && node.kind == Node::Kind::array) {
    std::vector<double> all;
    for (const Node& item : node.items) {
      if (item.kind == Node::Kind::array) return refuse("wanted a list of bare numbers");
      const std::vector<double> one = numbers(key, item, want);
      if (one.empty()) return {};
      all.push_back(one.front());
    }
    return all;
  }
  return refuse(fmt::format("is {}; wanted {}", kind_name(node), wanted(want.dimension)));
}

// {value = ..., mark = "P", source = "...", range = "..."}
std::vector<double> Table::read_figure(const std::string& key, const Node& node, Want want) {
  Table figure(reading_, node, path(key));
  const std::string mark =
      figure.has("mark") ? figure.choice("mark", {"P", "L", "D", "A"}) : std::string("A");
  const std::string source = figure.word_or("source", "given in the case");
  const std::string range = figure.word_or("range", "");
  const Node* value = figure.need("value", wanted(want.dimension));
  if (value == nullptr) return {};
  if (reading_.provenance != nullptr && !mark.empty())
    reading_.provenance->push_back({path(key), figure_value(node), mark[0], source, range});
  return numbers(key, *value, want);
}

std::vector<double> Table::read(const std::string& key, const Node& node, Want want) {
  std::vector<double> all;
  if (node.is_table()) {
    all = read_figure(key, node, want);
  } else {
    all = numbers(key, node, want);
    if (reading_.records_plain_values && reading_.provenance != nullptr)
      reading_.provenance->push_back({path(key), figure_value(node), 'A', "given in the case", ""});
  }
  for (const double value : all) check_range(key, node, want, value);
  return all;
}

double Table::single(const std::string& key, const Node& node, Want want) {
  const std::vector<double> all = read(key, node, want);
  if (all.size() > 1) fault(key, "wanted one value, " + wanted(want.dimension));
  return all.size() == 1 ? all.front() : nan;
}

double Table::value(const std::string& key, Want want) {
  const Node* node = need(key, wanted(want.dimension));
  return node == nullptr ? nan : single(key, *node, want);
}

double Table::value(const std::string& key, Want want, double fallback) {
  const Node* node = look(key);
  return node == nullptr ? fallback : single(key, *node, want);
}

std::optional<double> Table::maybe(const std::string& key, Want want) {
  const Node* node = look(key);
  if (node == nullptr) return std::nullopt;
  return single(key, *node, want);
}

std::vector<double> Table::values(const std::string& key, Want want) {
  const Node* node = need(key, wanted(want.dimension));
  return node == nullptr ? std::vector<double>{} : read(key, *node, want);
}

std::vector<double> Table::values(const std::string& key, Want want,
                                  const std::vector<double>& fallback) {
  const Node* node = look(key);
  return node == nullptr ? fallback : read(key, *node, want);
}

Vec3 Table::vector(const std::string& key, Dimension dimension) {
  const std::size_t before = reading_.faults();
  const std::vector<double> all = values(key, {dimension, any});
  if (all.size() == 3) return {all[0], all[1], all[2]};
  if (has(key) && reading_.faults() == before)
    fault(key, dimension == Dimension::none ? "wanted three numbers such as [0, 0, 1]"
                                            : "wanted three numbers and one unit such as \"0 0 1 "
                                              "m\", each a component of " +
                                                  wanted(dimension));
  return Vec3::Constant(nan);
}

Vec3 Table::vector(const std::string& key, Dimension dimension, const Vec3& fallback) {
  if (look(key) == nullptr) return fallback;
  return vector(key, dimension);
}

Vec3 Table::direction(const std::string& key) {
  const Vec3 given = vector(key, Dimension::none);
  if (given.norm() == 0.0) fault(key, "has no direction; wanted a vector such as [0, 0, 1]");
  return given.normalized();
}

std::size_t Table::count(const std::string& key, std::size_t smallest) {
  const Node* node = need(key, "a whole number such as 100");
  return node == nullptr ? smallest : count(key, smallest, smallest);
}

std::size_t Table::count(const std::string& key, std::size_t smallest, std::size_t fallback) {
  const Node* node = look(key);
  if (node == nullptr) return fallback;
  const double low = static_cast<double>(smallest);
  if (node->kind == Node::Kind::number && node->is_integer && node->number >= low &&
      node->number <= 4.0e9)
    return static_cast<std::size_t>(node->number);
  fault(key, fmt::format("{} is wrong; wanted a whole number of at least {}", write_value(*node),
                         smallest));
  return fallback;
}

bool Table::flag(const std::string& key, bool fallback) {
  const Node* node = look(key);
  if (node == nullptr) return fallback;
  if (node->kind != Node::Kind::boolean)
    fault(key, fmt::format("is {}; wanted true or false", kind_name(*node)));
  return node->boolean;
}

std::string Table::word(const std::string& key, const std::string& wanted) {
  return need(key, wanted) == nullptr ? std::string() : word_or(key, "");
}

std::string Table::word_or(const std::string& key, const std::string& fallback) {
  const Node* node = look(key);
  if (node == nullptr) return fallback;
  if (node->kind == Node::Kind::string) return node->text;
  fault(key, fmt::format("is {}; wanted a text in quotes", kind_name(*node)));
  return fallback;
}

std::string Table::file(const std::string& key, const std::string& wanted) {
  return need(key, wanted) == nullptr ? std::string() : file_if_any(key);
}

std::string Table::file_if_any(const std::string& key) {
  std::string name = word_or(key, "");
  if (name.empty()) return name;
  const auto folder = reading_.folders.find(node_.find(key)->place.file);
  const auto base = folder == reading_.folders.end() ? reading_.folders.find("") : folder;
  const std::filesystem::path from = base == reading_.folders.end() ? "" : base->second;
  const auto absolute = std::filesystem::absolute(from / name).lexically_normal();
  return reading_.files[path(key)] =
             std::filesystem::path(name).is_absolute() ? name : absolute.string();
}

const std::string& Table::moves_nothing(const std::string& key) {
  reading_.motionless.insert(path(key));
  return key;
}

std::string Table::choice(const std::string& key, const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  std::string chosen = word(key, "one of " + list);
  if (chosen.empty() || std::find(words.begin(), words.end(), chosen) != words.end()) return chosen;
  fault(key, unknown_word("choice", chosen, words));
  return "";
}

}  // namespace pmr::casefile
