#include "study/correlated.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "io/atomic_file.hpp"
#include "study/file_parts.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;
using casefile::Node;
using casefile::Table;

constexpr double reach = 3.0;  // [1] deviations to each side, of what is drawn

std::vector<std::string> read_words(Table& table, const std::string& key) {
  std::vector<std::string> words;
  const Node* node = table.need(key, "a list of texts, one to a variable");
  if (node == nullptr) return words;
  for (const Node& item : node->items) words.push_back(item.text);
  return words;
}

std::vector<std::vector<double>> read_matrix(Table& table, const std::string& key) {
  std::vector<std::vector<double>> rows;
  const Node* node = table.need(key, "a list of rows of numbers");
  if (node == nullptr) return rows;
  for (const Node& row : node->items) {
    rows.emplace_back();
    for (const Node& item : row.items) rows.back().push_back(item.number);
  }
  return rows;
}

bool is_positive(const std::vector<std::vector<double>>& correlation) {
  const auto n = static_cast<Eigen::Index>(correlation.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      matrix(i, j) = correlation[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return matrix.isApprox(matrix.transpose(), 1e-9) &&
         Eigen::LLT<Eigen::MatrixXd>(matrix).info() == Eigen::Success;
}

void read_group(Table& table, Study& study) {
  const auto names = read_words(table, "names"), keys = read_words(table, "keys");
  const auto units = read_words(table, "units");
  Correlated group;
  group.mean = table.values("values", casefile::a_number);
  const auto sd = table.values("deviations", casefile::a_positive_number);
  group.low = table.values("low", casefile::a_number);
  group.high = table.values("high", casefile::a_number);
  const auto correlation = read_matrix(table, "correlation");
  const std::size_t n = names.size();
  const bool are_all = keys.size() == n && units.size() == n && group.mean.size() == n &&
                       sd.size() == n && group.low.size() == n && group.high.size() == n &&
                       correlation.size() == n &&
                       std::all_of(correlation.begin(), correlation.end(),
                                   [&](const auto& row) { return row.size() == n; });
  if (n == 0 || !are_all)
    return table.fault("names",
                       "wanted as many keys, units, values, deviations, low, high and "
                       "rows of the correlation as names");
  if (!is_positive(correlation))
    return table.fault("correlation", "wanted symmetric and positive, with ones on its diagonal");
  for (std::size_t k = 0; k < n; ++k) {
    Variable v;
    v.name = v.label = names[k];
    v.key = keys[k];
    v.unit = units[k];
    v.low = std::max(group.low[k], group.mean[k] - reach * sd[k]);
    v.high = std::min(group.high[k], group.mean[k] + reach * sd[k]);
    group.variables.push_back(study.variables.size());
    study.variables.push_back(std::move(v));
    group.covariance.emplace_back();
    for (std::size_t l = 0; l < n; ++l)
      group.covariance.back().push_back(correlation[k][l] * sd[k] * sd[l]);
  }
  study.correlated.push_back(std::move(group));
}

}  // namespace

void read_correlated(Table& table, const std::string& name, Study& study) {
  if (study.design.kind == DesignKind::grid)
    table.fault("", "wants a sampled design: latin-hypercube or sobol");
  if (!table.has("file")) return read_group(table, study);
  const std::string word = table.word("file", "the contacts.toml of a calibration");
  if (word.empty()) return;
  const fs::path folder = fs::absolute(table.look("file")->place.file).parent_path();
  const std::string file = (folder / word).lexically_normal().string();
  if (!fs::is_regular_file(file)) return table.fault("file", "there is no file " + file);
  const Node found = casefile::parse_toml(io::read_text(file), file);
  const Node* record = found.find("calibration");
  if (record == nullptr || !record->is_table())
    return table.fault("file", "there is no [calibration] in " + file);
  Table inner(table.reading(), *record, "correlated." + name + ".calibration");
  for (const char* said : {"lab", "version", "tests", "young_modulus"}) inner.look(said);
  read_group(inner, study);
}

}  // namespace pmr::study
