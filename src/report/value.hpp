// A JSON value as plain data: what summary.json holds and what the page's scripts read.
// nlohmann-json stays in json.cpp.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace pmr::report {

struct Member;

struct Value {
  using Array = std::vector<Value>;
  using Object = std::vector<Member>;  // in the order of the file
  std::variant<std::monostate, bool, double, std::string, Array, Object> data;

  // Defined where Member is complete.
  Value();
  Value(bool flag);
  Value(double number);
  Value(int number);
  Value(std::size_t number);
  Value(const char* text);
  Value(std::string text);
  Value(Array items);
  Value(Object members);
  Value(const std::vector<double>& numbers);
  Value(const Value& other);
  Value(Value&& other) noexcept;
  Value& operator=(const Value& other);
  Value& operator=(Value&& other) noexcept;
  ~Value();

  // The value at "thermal/temperature_mean/SrFeO3" or, in an array, "homogeneity/layers/0/mass";
  // null where any part is missing.
  const Value* find(std::string_view path) const;
  bool has(std::string_view path) const { return find(path) != nullptr; }
  double number(std::string_view path) const;          // NaN where absent or not a number
  std::string text(std::string_view path) const;       // "" where absent; numbers as text
  const Array& items(std::string_view path) const;     // empty where absent or not an array
  const Object& members(std::string_view path) const;  // empty where absent or not an object
  double as_number() const;                            // NaN where it is none
  std::string as_text() const;                         // "" where it has no short text

  // Sets a member of an object, in place of one of that name (a null value becomes an object).
  void set(std::string key, Value value);
};

struct Member {
  std::string key;
  Value value;
};

Value parse_json(const std::string& text);  // throws CaseError when it is not JSON
std::string to_json(const Value& value);    // numbers to 8 digits; not finite ones as null

}  // namespace pmr::report
