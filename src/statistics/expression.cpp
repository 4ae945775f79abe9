#include "statistics/expression.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <openturns/SymbolicFunction.hxx>
#include <stdexcept>
#include <string_view>

#include "pmr/base/errors.hpp"

namespace pmr::statistics {
namespace {

constexpr std::array<std::string_view, 8> functions = {"abs",   "cbrt", "exp", "log",
                                                       "log10", "max",  "min", "sqrt"};

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

template <class Names>
std::string listed(const Names& names) {
  std::string list;
  for (const auto& name : names) (list += list.empty() ? "" : ", ") += name;
  return list;
}

// Reads a formula and writes it again with the variables named v0, v1, ... : the parser behind
// takes no notice of capitals, has many reserved words, assigns, and reads "2x" as a product.
//   formula := value { operator value }
//   value   := { sign } ( number | name | name "(" formula { "," formula } ")" | "(" formula ")" )
class Reader {
 public:
  Reader(std::string_view text, const std::vector<std::string>& variables)
      : text_(text), variables_(variables), is_used_(variables.size(), false) {
    formula();
    if (peek() == ')') fail("the bracket closed at " + place() + " was not opened");
    if (peek() != '\0') fail("an operator is wanted instead of " + here());
  }

  const std::string& written() const { return written_; }
  // Arguments of all functions, as written.
  const std::vector<std::string>& arguments() const { return arguments_; }
  const std::vector<bool>& is_used() const { return is_used_; }

 private:
  void formula() {
    value();
    while (peek() != '\0' && std::string_view("+-*/^").find(peek()) != std::string_view::npos) {
      written_ += text_[at_++];
      value();
    }
  }

  void value() {
    bool is_negative = false;
    for (; peek() == '+' || peek() == '-'; ++at_) is_negative ^= text_[at_] == '-';
    if (is_negative) written_ += '-';
    if (is_digit(peek()) || peek() == '.')
      number();
    else if (starts_name(peek()))
      named();
    else if (peek() == '(')
      bracket();
    else
      fail("a number, a name or '(' is wanted instead of " + here());
  }

  void number() {
    double read = 0.0;
    const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), read);
    if (result.ec == std::errc::result_out_of_range)
      fail("the number at " + place() + " is beyond all bounds");
    if (result.ec != std::errc()) fail("a number is wanted instead of " + here());
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    std::array<char, 32> digits;
    written_.append(digits.data(), std::to_chars(digits.data(), digits.data() + 32, read).ptr);
  }

  void named() {
    const std::size_t first = at_;
    while (at_ < text_.size() &&
           (starts_name(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '.'))
      ++at_;
    const std::string name(text_.substr(first, at_ - first));
    if (peek() == '(') return call(name);
    const auto found = std::find(variables_.begin(), variables_.end(), name);
    if (found == variables_.end())
      fail("no variable is named '" + name + "'; there " +
           (variables_.empty() ? "are none" : "is " + listed(variables_)));
    const auto index = found - variables_.begin();
    is_used_[static_cast<std::size_t>(index)] = true;
    written_ += "v" + std::to_string(index);
  }

  void call(const std::string& name) {
    if (std::find(functions.begin(), functions.end(), name) == functions.end())
      fail("no function is named '" + name + "'; there is " + listed(functions));
    written_ += name;
    const std::string opened = open();
    std::size_t count = 0;
    do {
      if (count++ > 0) written_ += text_[at_++];
      const std::size_t first = written_.size();
      formula();
      arguments_.push_back(written_.substr(first));
    } while (peek() == ',');
    close(opened);
    if (count > 1 && name != "min" && name != "max")
      fail(name + " takes one argument, not " + std::to_string(count));
  }

  void bracket() {
    const std::string opened = open();
    formula();
    close(opened);
  }

  std::string open() {
    std::string where = place();
    written_ += text_[at_++];
    return where;
  }

  void close(const std::string& opened) {
    if (peek() == '\0') fail("the bracket opened at " + opened + " is not closed");
    if (peek() != ')') fail("an operator or ')' is wanted instead of " + here());
    written_ += text_[at_++];
  }

  // Next character that is no blank, '\0' at the end.
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  std::string place() const { return "character " + std::to_string(at_ + 1); }
  std::string here() {
    if (peek() == '\0') return "the end";
    return "'" + std::string(1, text_[at_]) + "' at " + place();
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw std::invalid_argument("'" + std::string(text_) + "': " + problem);
  }

  std::string_view text_;
  const std::vector<std::string>& variables_;
  std::size_t at_ = 0;
  std::string written_;
  std::vector<std::string> arguments_;
  std::vector<bool> is_used_;
};

}  // namespace

struct Expression::Compiled {
  OT::SymbolicFunction function;  // the value, then what must be finite besides
  std::size_t variables;
  std::vector<std::size_t> used;
};

Expression::Expression(const std::string& formula, const std::vector<std::string>& variables) {
  const Reader reader(formula, variables);
  Compiled compiled{{}, variables.size(), {}};
  OT::Description names;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (!reader.is_used()[k]) continue;
    compiled.used.push_back(k);
    names.add("v" + std::to_string(k));
  }
  if (compiled.used.empty()) names.add("none");  // a constant: the library wants a variable
  // max(1, log(-1)) would be 1 unless the arguments were asked for, too.
  OT::Description formulas(1, reader.written());
  for (const std::string& argument : reader.arguments()) formulas.add(argument);
  try {
    compiled.function = OT::SymbolicFunction(names, formulas);
  } catch (const std::exception&) {
    throw std::invalid_argument("'" + formula +
                                "': cannot be evaluated, it may be nested too deep");
  }
  compiled_ = std::make_shared<const Compiled>(std::move(compiled));
}

double Expression::operator()(std::span<const double> values) const {
  ensure(values.size() == compiled_->variables, "every variable of an expression has a value");
  OT::Point arguments(std::max<std::size_t>(1, compiled_->used.size()));
  for (std::size_t k = 0; k < compiled_->used.size(); ++k) {
    arguments[k] = values[compiled_->used[k]];
    // max(1, NaN) would be 1.
    if (std::isnan(arguments[k])) return arguments[k];
  }
  try {
    return compiled_->function(arguments)[0];
  } catch (const std::exception&) {  // what the library does with a result that is not finite
    return std::numeric_limits<double>::quiet_NaN();
  }
}

const std::vector<std::size_t>& Expression::variables_used() const { return compiled_->used; }

}  // namespace pmr::statistics
