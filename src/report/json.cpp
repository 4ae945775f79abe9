// The one place that knows nlohmann-json.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "pmr/base/errors.hpp"
#include "report/value.hpp"

namespace pmr::report {
namespace {

using Json = nlohmann::ordered_json;

Value from(const Json& json) {
  if (json.is_boolean()) return Value(json.get<bool>());
  if (json.is_number()) return Value(json.get<double>());
  if (json.is_string()) return Value(json.get<std::string>());
  if (json.is_array()) {
    Value::Array items;
    for (const Json& item : json) items.push_back(from(item));
    return Value(std::move(items));
  }
  if (!json.is_object()) return Value();
  Value::Object members;
  for (const auto& [key, item] : json.items()) members.push_back({key, from(item)});
  return Value(std::move(members));
}

// Eight digits are more than any plot can show, and halve the page's data.
double short_of(double number) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.8g", number);
  return std::strtod(digits, nullptr);
}

Json from_number(double number) {
  if (!std::isfinite(number)) return Json();
  const double short_number = short_of(number);
  const bool whole = std::abs(short_number) < 1e9 && short_number == std::floor(short_number);
  return whole ? Json(static_cast<long long>(short_number)) : Json(short_number);
}

Json to(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag;
  if (const auto* number = std::get_if<double>(&value.data)) return from_number(*number);
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  if (const auto* items = std::get_if<Value::Array>(&value.data)) {
    Json array = Json::array();
    for (const Value& item : *items) array.push_back(to(item));
    return array;
  }
  const auto* members = std::get_if<Value::Object>(&value.data);
  if (members == nullptr) return Json();
  Json object = Json::object();
  for (const Member& m : *members) object[m.key] = to(m.value);
  return object;
}

}  // namespace

Value parse_json(const std::string& text) {
  try {
    return from(Json::parse(text));
  } catch (const Json::exception& error) {
    throw CaseError({{"summary.json", "", std::string("is not valid JSON: ") + error.what()}});
  }
}

std::string to_json(const Value& value) {
  return to(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace pmr::report
