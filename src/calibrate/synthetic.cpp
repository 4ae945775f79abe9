#include "calibrate/synthetic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/atomic_file.hpp"
#include "pmr/base/text.hpp"
#include "statistics/band.hpp"

namespace pmr::calibrate {
namespace {

using casefile::Node;
using casefile::quoted;

// "contacts.\"A|B\".friction" in words.
std::vector<std::string> words_of(const std::string& key) {
  std::vector<std::string> words{""};
  bool is_quoted = false;
  for (const char c : key) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == '.' && !is_quoted)
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

// The node at a key; "contacts." may be left out, as in the shipped file of contacts.
const Node* find(const Node& root, std::vector<std::string> words) {
  const auto walk = [&]() -> const Node* {
    const Node* node = &root;
    for (const std::string& word : words)
      if (node = node->is_table() ? node->find(word) : nullptr; node == nullptr) return nullptr;
    return node;
  };
  if (const Node* node = walk()) return node;
  if (words.front() != "contacts") return nullptr;
  words.erase(words.begin());
  return walk();
}

// A number, {value = ..}, or "4 l/s" in the parameter's own unit; none otherwise.
std::optional<double> number_of(const Node* node, const std::string& unit) {
  if (node != nullptr && node->is_table()) node = node->find("value");
  if (node == nullptr) return std::nullopt;
  if (node->kind == Node::Kind::number) return node->number;
  const auto number = leading_number(node->text);
  if (node->kind != Node::Kind::string || !number) return std::nullopt;
  const bool has_unit = trimmed(std::string_view(node->text).substr(number->length)) == unit;
  return has_unit ? std::optional(number->value) : std::nullopt;
}

study::Values truth_of(const Lab& lab, const std::filesystem::path& file) {
  const Node root = casefile::parse_toml(io::read_text(file), file.string());
  study::Values values = lab.constants;
  std::vector<Fault> faults;
  for (const Stage& stage : lab.stages)
    for (const Parameter& p : stage.parameters) {
      const Node* node = p.key.empty() ? nullptr : find(root, words_of(p.key));
      if (node == nullptr) node = root.find(p.name);
      const auto value = number_of(node, p.unit);
      if (value)
        values[p.name] = *value;
      else
        faults.push_back({file.string(), p.key.empty() ? p.name : p.key,
                          "wanted the value of this parameter of the lab, a number" +
                              (p.unit.empty() ? "" : " in " + p.unit)});
    }
  if (!faults.empty()) throw CaseError(std::move(faults));
  return completed(lab, std::move(values));
}

std::string result_of(const Lab& lab, TargetIndex at, const statistics::Band& band,
                      const std::string& source) {
  const double error = band.deviation / std::sqrt(static_cast<double>(band.count));
  return fmt::format(
      "\n[tests.{}.responses.{}]\nresult = {{value = {:.6g}, standard_error = {:.4g}, runs = {}, "
      "source = {}}}\n",
      lab.tests[at.test].name, lab.target(at).response.name, band.mean, error, band.count,
      quoted(source));
}

}  // namespace

std::string synthetic_lab(const Lab& lab, const std::filesystem::path& truth, bool is_full,
                          Runs& runs) {
  const study::Values values = truth_of(lab, truth);
  std::vector<Wanted> wanted;
  for (std::size_t t = 0; t < lab.tests.size(); ++t)
    for (std::size_t k = 0; k < lab.tests[t].synthetic; ++k)
      wanted.push_back({t, !is_full && !lab.tests[t].small.empty(), values, "synthetic",
                        first_synthetic_seed + k});
  const auto outcomes = runs.get(wanted);
  std::string text = fmt::format("extends = {}\ntitle = {}\n",
                                 quoted(std::filesystem::absolute(lab.file).string()),
                                 quoted(lab.title + ", from results made by the program"));
  if (!lab.constants.empty()) text += "\n[constants]\n";
  for (const auto& [name, value] : lab.constants) text += fmt::format("{} = {}\n", name, value);
  for (std::size_t t = 0; t < lab.tests.size(); ++t)
    for (std::size_t r = 0; r < lab.tests[t].targets.size(); ++r) {
      std::vector<double> results;
      for (const Outcome& o : outcomes) {
        if (o.test != t) continue;
        if (std::isfinite(o.responses[r]))
          results.push_back(o.responses[r]);
        else if (o.status == "completed" && lab.tests[t].targets[r].beyond)
          throw NumericsError(o.name + " ended beyond the limit of " + lab.target_name({t, r}) +
                              ": a mean cannot be told; give the test more time");
      }
      const auto band = statistics::band(results);
      if (band.count < 2)
        throw NumericsError(lab.target_name({t, r}) +
                            ": fewer than two runs at the parameters given have a result; see "
                            "runs.csv");
      text += result_of(lab, {t, r}, band,
                        "made by pmr at the parameters of " + truth.filename().string());
    }
  return text;
}

}  // namespace pmr::calibrate
