#include "report/value.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "report/text.hpp"

namespace pmr::report {
namespace {

// Item of an array at a place written in digits.
const Value* item(const Value::Array& items, std::string_view place) {
  std::size_t k = 0;
  const auto [end, error] = std::from_chars(place.data(), place.data() + place.size(), k);
  const bool is_place = error == std::errc() && end == place.data() + place.size();
  return is_place && k < items.size() ? &items[k] : nullptr;
}

const Value* member(const Value& value, std::string_view key) {
  if (const auto* items = std::get_if<Value::Array>(&value.data)) return item(*items, key);
  const auto* object = std::get_if<Value::Object>(&value.data);
  if (object == nullptr) return nullptr;
  const auto found =
      std::find_if(object->begin(), object->end(), [&](const Member& m) { return m.key == key; });
  return found == object->end() ? nullptr : &found->value;
}

}  // namespace

Value::Value() = default;
Value::Value(bool flag) : data(flag) {}
Value::Value(double number) : data(number) {}
Value::Value(int number) : data(static_cast<double>(number)) {}
Value::Value(std::size_t number) : data(static_cast<double>(number)) {}
Value::Value(const char* text) : data(std::string(text)) {}
Value::Value(std::string text) : data(std::move(text)) {}
Value::Value(Array items) : data(std::move(items)) {}
Value::Value(Object members) : data(std::move(members)) {}
Value::Value(const std::vector<double>& numbers) : data(Array(numbers.begin(), numbers.end())) {}
Value::Value(const Value& other) = default;
Value::Value(Value&& other) noexcept = default;
Value& Value::operator=(const Value& other) = default;
Value& Value::operator=(Value&& other) noexcept = default;
Value::~Value() = default;

const Value* Value::find(std::string_view path) const {
  const Value* here = this;
  while (here != nullptr && !path.empty()) {
    const auto slash = path.find('/');
    here = member(*here, path.substr(0, slash));
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
  }
  const bool is_null = here != nullptr && std::holds_alternative<std::monostate>(here->data);
  return is_null ? nullptr : here;
}

double Value::as_number() const {
  const auto* number = std::get_if<double>(&data);
  return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
}

std::string Value::as_text() const {
  if (const auto* text = std::get_if<std::string>(&data)) return *text;
  if (const auto* number = std::get_if<double>(&data)) return significant(*number, 6);
  if (const auto* flag = std::get_if<bool>(&data)) return *flag ? "yes" : "no";
  return "";
}

double Value::number(std::string_view path) const {
  const Value* value = find(path);
  return value == nullptr ? std::numeric_limits<double>::quiet_NaN() : value->as_number();
}

std::string Value::text(std::string_view path) const {
  const Value* value = find(path);
  return value == nullptr ? "" : value->as_text();
}

const Value::Array& Value::items(std::string_view path) const {
  static const Array none;
  const Value* value = find(path);
  const auto* array = value == nullptr ? nullptr : std::get_if<Array>(&value->data);
  return array == nullptr ? none : *array;
}

const Value::Object& Value::members(std::string_view path) const {
  static const Object none;
  const Value* value = find(path);
  const auto* object = value == nullptr ? nullptr : std::get_if<Object>(&value->data);
  return object == nullptr ? none : *object;
}

void Value::set(std::string key, Value value) {
  if (std::holds_alternative<std::monostate>(data)) data = Object();
  auto& members = std::get<Object>(data);
  std::erase_if(members, [&](const Member& member) { return member.key == key; });
  members.push_back({std::move(key), std::move(value)});
}

}  // namespace pmr::report
