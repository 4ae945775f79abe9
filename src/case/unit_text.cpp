#include "case/unit_text.hpp"

#include <cctype>
#include <cmath>

#include "pmr/base/text.hpp"

namespace pmr::casefile {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
// As UDUNITS has them in names; bytes of UTF-8 count ("µm", "°C", "m²").
bool is_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalpha(byte) != 0 || byte >= 0x80 ||
         std::string_view("_%'\"").find(c) != std::string_view::npos;
}

class UnitText {
 public:
  explicit UnitText(std::string_view text) : text_(text) {}

  bool has_whole_exponents() {
    while (at(0) == '(') ++at_;
    if (at(0) == '1' && !is_digit(at(1)) && at(1) != '.') ++at_;
    while (at_ < text_.size()) {
      const bool has_base = is_letter(at(0)) || at(0) == ')';
      if (is_letter(at(0)))
        pass_name();
      else if (has_base || std::string_view(" /*.-(").find(at(0)) != std::string_view::npos)
        ++at_;
      else
        return false;
      if (has_base && !pass_exponent()) return false;
    }
    return true;
  }

 private:
  char at(std::size_t further) const {
    return at_ + further < text_.size() ? text_[at_ + further] : '\0';
  }
  // Digits within a name belong to it: "cmH2O".
  void pass_name() {
    while (is_letter(at(0))) {
      ++at_;
      std::size_t digits = 0;
      while (is_digit(at(digits))) ++digits;
      if (digits > 0 && is_letter(at(digits))) at_ += digits;
    }
  }
  // False where what follows a name or a bracket is no whole exponent, nor the end of the factor.
  bool pass_exponent() {
    const std::size_t power = at(0) == '^' ? 1 : at(0) == '*' && at(1) == '*' ? 2 : 0;
    const std::size_t sign = at(power) == '-' || at(power) == '+' ? 1 : 0;
    if (!is_digit(at(power + sign))) return power == 0;
    at_ += power + sign;
    while (is_digit(at(0))) ++at_;
    return !(at(0) == '.' && is_digit(at(1)));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

NumbersAndUnit split(std::string_view text) {
  NumbersAndUnit out;
  while (true) {
    text = trimmed(text);
    const auto number = leading_number(text);
    if (!number) break;
    const std::string_view rest = text.substr(number->length);
    const char next = rest.empty() ? ' ' : rest.front();
    const bool is_in_unit = std::string_view("/*^.").find(next) != std::string_view::npos;
    const bool is_in_name = !std::isfinite(number->value) && is_letter(next);  // "nanometre"
    if (is_in_unit || is_in_name) break;
    out.numbers.push_back(number->value);
    text = rest;
  }
  out.unit = text;
  return out;
}

bool has_whole_exponents(std::string_view unit) { return UnitText(unit).has_whole_exponents(); }

}  // namespace pmr::casefile
