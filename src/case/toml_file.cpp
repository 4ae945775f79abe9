// The only file that knows toml++.
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include "case/node.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::casefile {
namespace {

Place place_of(const toml::source_region& source, const std::string& file) {
  return {file, source.begin.line, source.begin.column};
}

Node convert(const toml::node& from, const std::string& file);

Node convert_table(const toml::table& from, const std::string& file) {
  Node node;
  node.is_inline = from.is_inline();
  for (const auto& [key, value] : from) {
    Node member = convert(value, file);
    member.place = place_of(key.source(), file);
    node.members.emplace(std::string(key.str()), std::move(member));
  }
  return node;
}

Node convert(const toml::node& from, const std::string& file) {
  Node node;
  if (const auto* table = from.as_table()) {
    node = convert_table(*table, file);
  } else if (const auto* array = from.as_array()) {
    node.kind = Node::Kind::array;
    for (const toml::node& item : *array) node.items.push_back(convert(item, file));
  } else if (const auto* string = from.as_string()) {
    node.kind = Node::Kind::string;
    node.text = string->get();
  } else if (const auto* integer = from.as_integer()) {
    node.kind = Node::Kind::number;
    node.is_integer = true;
    node.number = static_cast<double>(integer->get());
  } else if (const auto* real = from.as_floating_point()) {
    node.kind = Node::Kind::number;
    node.number = real->get();
  } else if (const auto* boolean = from.as_boolean()) {
    node.kind = Node::Kind::boolean;
    node.boolean = boolean->get();
  } else {
    node.kind = Node::Kind::other;  // dates and times: no key wants one
  }
  node.place = place_of(from.source(), file);
  return node;
}

}  // namespace

Node parse_toml(const std::string& text, const std::string& file) {
  try {
    Node root = convert_table(toml::parse(text, file), file);
    root.place = {file, 1, 1};
    return root;
  } catch (const toml::parse_error& error) {
    const std::string where = to_string(place_of(error.source(), file));
    throw CaseError({{where, "", "not TOML: " + std::string(error.description())}});
  }
}

}  // namespace pmr::casefile
