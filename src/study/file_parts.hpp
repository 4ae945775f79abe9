// What the files of studies and of calibrations have in common.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "case/reader.hpp"
#include "study/study.hpp"

namespace pmr::study {

inline constexpr const char* wanted_formula =
    "wanted an expression in quotes such as \"(scale * ratio)^(1/3)\"";

// Members of a table in the order of the file; none of a null.
std::vector<std::pair<std::string, const casefile::Node*>> in_order(const casefile::Node* table);

// Calls read(table, name) for each table in the table `key`, in the order of the file.
template <class Read>
void for_each_in_order(casefile::Table& parent, const std::string& key, const Read& read) {
  for (const auto& [name, node] : in_order(parent.look_table(key))) {
    const std::string path = casefile::joined(parent.path(key), name);
    if (!node->is_table()) {
      parent.reading().fault(node->place, path, "wanted a table");
      continue;
    }
    casefile::Table table(parent.reading(), *node, path);
    read(table, name);
  }
}

std::vector<Setting> read_settings(casefile::Table& table, const std::string& key = "settings");

// Whether a word can stand in an expression.
bool is_name(const std::string& word);
// A fault where the name of the table cannot.
void check_name(casefile::Table& table, const std::string& name);

std::map<std::string, double> read_constants(casefile::Table& root);

// Label, unit, factor and offset of a figure that is shown.
template <class Shown>
void read_shown(casefile::Table& table, Shown& shown) {
  shown.label = table.word_or("label", shown.name);
  shown.unit = table.word_or("unit", "");
  shown.factor = table.value("factor", casefile::a_number, 1.0);
  shown.offset = table.value("offset", casefile::a_number, 0.0);
}
Response read_response(casefile::Table& table, const std::string& name);

// Absolute name of the case file that `case` names, from the folder of the file that says so.
std::filesystem::path read_case_name(casefile::Table& table);

// The whole file as a document, laid on the one that it extends, which may extend another: tables
// are merged, anything else is replaced. `noun` is what such a file is called ("study"); `depth`
// [1] files lie on this one.
casefile::Node document_of(const std::filesystem::path& file, const std::string& noun,
                           int depth = 0);

// "scale=1" changes a constant of that name; what is left are settings of every case.
std::vector<std::string> apply_to_constants(const std::vector<std::string>& sets,
                                            std::map<std::string, double>& constants);

}  // namespace pmr::study
