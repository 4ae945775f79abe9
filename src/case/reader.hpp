// Typed reading of a document: every fault is collected with its place, every key that nobody
// asked for is a fault, every figure with a source is recorded.
#pragma once
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "case/node.hpp"
#include "case/units.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/vec3.hpp"
#include "pmr/state/materials.hpp"

namespace pmr::casefile {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;
  bool holds(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};
inline constexpr Range any{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range not_negative{0.0, std::numeric_limits<double>::infinity(), false, false};
inline constexpr Range fraction{0.0, 1.0, false, false};

// What a key wants: its dimension and the range in SI.
struct Want {
  Dimension dimension = Dimension::none;
  Range range = any;
};
inline constexpr Want a_length{Dimension::length, positive};
inline constexpr Want a_time{Dimension::time, any};
inline constexpr Want a_duration{Dimension::time, positive};
inline constexpr Want a_temperature{Dimension::temperature, positive};
inline constexpr Want a_pressure{Dimension::pressure, not_negative};
inline constexpr Want a_number{Dimension::none, any};
inline constexpr Want a_positive_number{Dimension::none, positive};
inline constexpr Want a_fraction{Dimension::none, fraction};

// What one loading shares.
class Reading {
 public:
  Units units;
  std::vector<Provenance>* provenance = nullptr;  // where figures are recorded; may be none
  bool records_plain_values = false;              // a plain value is a figure "given in the case"
  std::map<std::string, std::filesystem::path> folders;  // of the files that the document is from
  // What the keys said of themselves as they were read, by their paths ("walls.tube.file").
  std::set<std::string> asked_for;           // all, given or not
  std::set<std::string> motionless;          // those that move no particle
  std::map<std::string, std::string> files;  // absolute names of files
  std::vector<std::string> warnings;         // what is taken otherwise than it is written

  void fault(const Place& place, const std::string& key, const std::string& problem);
  std::size_t faults() const { return faults_.size(); }
  // Throws CaseError with all faults, in the order of their places, if there are any.
  void finish();

 private:
  std::vector<std::pair<Place, Fault>> faults_;
};

// One table under reading. Its end of life reports the missing and the unknown keys.
class Table {
 public:
  Table(Reading& reading, const Node& node, std::string path);
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  bool has(const std::string& key) const { return node_.find(key) != nullptr; }
  // The node of a key: null and a fault (told at the end) if it is missing.
  const Node* need(const std::string& key, const std::string& wanted);
  const Node* look(const std::string& key);
  // Like need and look, for a table.
  const Node* need_table(const std::string& key);
  const Node* look_table(const std::string& key);

  // SI value; NaN after a fault. With a fallback the key is optional.
  double value(const std::string& key, Want want);
  double value(const std::string& key, Want want, double fallback);
  std::optional<double> maybe(const std::string& key, Want want);
  // "0 0 10 mm", or [0.0, 0.0, 1.0] where dimensionless.
  std::vector<double> values(const std::string& key, Want want);
  std::vector<double> values(const std::string& key, Want want,
                             const std::vector<double>& fallback);
  Vec3 vector(const std::string& key, Dimension dimension);
  Vec3 vector(const std::string& key, Dimension dimension, const Vec3& fallback);
  Vec3 direction(const std::string& key);  // [1] normalised
  std::size_t count(const std::string& key, std::size_t smallest);
  std::size_t count(const std::string& key, std::size_t smallest, std::size_t fallback);
  bool flag(const std::string& key, bool fallback);
  std::string word(const std::string& key, const std::string& wanted);
  std::string word_or(const std::string& key, const std::string& fallback);
  // One of the words; "" after a fault.
  std::string choice(const std::string& key, const std::vector<std::string>& words);

  // The absolute name of a file; one that is relative starts from the folder of the file that it
  // stands in. "" after a fault, or where there is none.
  std::string file(const std::string& key, const std::string& wanted);
  std::string file_if_any(const std::string& key);

  // Says of a key (and of all in its table) that it moves no particle: titles, temperatures, heat,
  // gas, chemistry, instruments. Cases that differ in such keys alone share one mixing.
  const std::string& moves_nothing(const std::string& key);

  void fault(const std::string& key, const std::string& problem);  // at the key's place
  // After a fault that hides what the other keys mean.
  void ignore_rest();
  Reading& reading() { return reading_; }
  const Node& node() const { return node_; }
  const Place& place() const { return node_.place; }
  std::string path(const std::string& key) const;

 private:
  struct Missing {
    std::string key, wanted;
  };
  std::vector<double> read(const std::string& key, const Node& node, Want want);
  std::vector<double> read_figure(const std::string& key, const Node& node, Want want);
  std::vector<double> numbers(const std::string& key, const Node& node, Want want);
  double single(const std::string& key, const Node& node, Want want);
  void check_range(const std::string& key, const Node& node, Want want, double value);
  void report_unknown();

  Reading& reading_;
  const Node& node_;
  std::string path_;
  std::vector<std::string> asked_;
  std::vector<Missing> missing_;
};

// Calls read(table, name) for each table in the table `key` (none if the key is missing).
template <class Read>
void for_each_table(Table& parent, const std::string& key, const Read& read) {
  const Node* node = parent.look_table(key);
  if (node == nullptr) return;
  for (const auto& [name, member] : node->members) {
    const std::string path = joined(parent.path(key), name);
    if (!member.is_table()) {
      parent.reading().fault(member.place, path, "wanted a table");
      continue;
    }
    Table table(parent.reading(), member, path);
    read(table, name);
  }
}

// Calls take(A{}) for the law of a closed set, std::variant<A, B, ...>, whose name (A::name) stands
// at `key`; false after a fault. `take` must do for each, so a law without its reader does not
// compile.
template <class... Law, class Take>
bool choose_law(Table& table, const std::string& key, const std::variant<Law...>&,
                const Take& take) {
  const std::string chosen = table.choice(key, {Law::name...});
  ((chosen == Law::name ? take(Law{}) : void()), ...);
  return !chosen.empty();
}

}  // namespace pmr::casefile
