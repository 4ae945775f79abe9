#include "study/settings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "statistics/expression.hpp"

namespace pmr::study {
namespace {

using casefile::Node;

bool is_one_expression(const std::string& text) {
  return text.rfind("${", 0) == 0 && text.find('}') == text.size() - 1;
}

Node filled(Node node, const Values& values) {
  if (node.kind == Node::Kind::string && is_one_expression(node.text)) {
    node.number = evaluated(node.text.substr(2, node.text.size() - 3), values);
    node.kind = Node::Kind::number;
    node.is_integer = node.number == std::round(node.number) && std::abs(node.number) < 1e15;
  } else if (node.kind == Node::Kind::string) {
    node.text = study::filled(node.text, values);
  }
  for (auto& [key, member] : node.members) member = filled(member, values);
  for (Node& item : node.items) item = filled(item, values);
  return node;
}

}  // namespace

double evaluated(const std::string& formula, const Values& values) {
  std::vector<std::string> names;
  std::vector<double> numbers;
  for (const auto& [name, value] : values) {
    names.push_back(name);
    numbers.push_back(value);
  }
  const double result = statistics::Expression(formula, names)(numbers);
  if (!std::isfinite(result))
    throw std::invalid_argument(fmt::format("${{{}}} is not finite here", formula));
  return result;
}

void derive(std::vector<std::pair<std::string, std::string>> left, Values& known) {
  while (!left.empty()) {
    const std::size_t before = left.size();
    std::string problem;
    std::erase_if(left, [&](const auto& entry) {
      try {
        known[entry.first] = evaluated(entry.second, known);
        return true;
      } catch (const std::invalid_argument& error) {
        if (problem.empty()) problem = "derived." + entry.first + ": " + error.what();
        return false;
      }
    });
    if (left.size() == before) throw std::invalid_argument(problem);
  }
}

std::string filled(const Setting& setting, const Values& values) {
  return setting.key + "=" + casefile::write_value(filled(setting.value, values));
}

std::string filled(const std::string& text, const Values& values) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find("${", at);
    out += text.substr(at, open - at);
    if (open == std::string::npos) break;
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) throw std::invalid_argument("a ${ without its } in: " + text);
    out += fmt::format("{}", evaluated(text.substr(open + 2, close - open - 2), values));
    at = close + 1;
  }
  return out;
}

}  // namespace pmr::study
