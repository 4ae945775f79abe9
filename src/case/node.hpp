// A TOML document as plain data, with the place of every value.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pmr::casefile {

// Where a value stands. A file that is no TOML document (a --set option) has line 0.
struct Place {
  std::string file;
  unsigned line = 0, column = 0;  // [1] from 1
};

// "file:line:column", or the file alone where there is no line.
std::string to_string(const Place& place);

struct Node {
  enum class Kind { table, array, string, number, boolean, other };
  Kind kind = Kind::table;
  bool is_inline = false;  // table written in braces
  bool is_integer = false;
  Place place;
  std::string text;  // of a string
  double number = 0.0;
  bool boolean = false;
  std::map<std::string, Node> members;  // of a table
  std::vector<Node> items;              // of an array

  const Node* find(const std::string& key) const;
  bool is_table() const { return kind == Kind::table; }
};

// "table.key", as keys are named in messages.
std::string joined(const std::string& table, const std::string& key);

// The table without the keys of these paths, and without tables that hold nothing else.
Node without(const Node& table, const std::set<std::string>& paths);

// The table with these texts instead of those of the keys of these paths.
Node with_texts(const Node& table, const std::map<std::string, std::string>& texts);

// Reads TOML text; throws CaseError with file:line:column of a mistake in the syntax.
Node parse_toml(const std::string& text, const std::string& file);

// Writes a table as TOML that parses back to the same values.
std::string write_toml(const Node& table);

// The text as TOML writes one.
std::string quoted(const std::string& text);

// The value as TOML on one line.
std::string write_value(const Node& node);

// Applies "dotted.key=TOMLVALUE" to the document; throws CaseError when it is not that. Missing
// tables are made (the reader then says whether the key is known); array elements go by index.
void apply_setting(Node& root, const std::string& setting);

// Lays `over` on `base`: tables are merged key by key; figures, and tables that name a law or a
// kind, replace what stood there. Where constants of a sourced table change, it is marked assumed.
void merge(Node& base, const Node& over);

}  // namespace pmr::casefile
