#include "pmr/base/text.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace pmr {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// std::from_chars knows no plus sign; behind one it would take a minus.
std::optional<LeadingNumber> leading_number(std::string_view text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* const first = text.data() + (has_plus ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return LeadingNumber{value, static_cast<std::size_t>(end - text.data())};
}

std::optional<double> finite_number(std::string_view text) {
  const auto number = leading_number(text);
  const bool is_good = number && number->length == text.size() && std::isfinite(number->value);
  return is_good ? std::optional(number->value) : std::nullopt;
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc{} && end == last ? std::optional(value) : std::nullopt;
}

void skip_byte_order_mark(std::istream& in) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const auto begin = in.tellg();
  std::string found(mark.size(), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (in && found == mark) return;
  in.clear();
  in.seekg(begin);
}

bool next_line(std::istream& in, std::string& line) {
  if (!std::getline(in, line)) return false;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

}  // namespace pmr
