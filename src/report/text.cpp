#include "report/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "pmr/base/constants.hpp"

namespace pmr::report {
namespace {

constexpr const char* minus = "\u2212";
constexpr const char* narrow_space = "\u202f";

std::string print(const char* format, int digits, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, digits, value);
  std::string text = buffer.data();
  if (!text.empty() && text.front() == '-') text.replace(0, 1, minus);
  return text;
}

// As it reads once it has been cut to so many digits, so that 999.96 counts as 1000 where prefix,
// unit or form is chosen.
double rounded(double value, int digits) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*e", digits - 1, value);
  return std::strtod(buffer.data(), nullptr);
}

Shown prefixed(double exact, int digits, const char* unit) {
  static constexpr std::array<const char*, 9> prefixes{"p", "n", "µ", "m", "", "k", "M", "G", "T"};
  const double value = rounded(exact, digits);
  if (value == 0.0) return {"0", unit};
  const double power = std::floor(std::log10(std::abs(value)) / 3.0 + 1e-9);
  const double step = std::clamp(power, -4.0, 4.0);
  const double scaled = value / std::pow(10.0, 3.0 * step);
  return {significant(scaled, digits),
          prefixes[static_cast<std::size_t>(step + 4.0)] + std::string(unit)};
}

// "3.1·10⁻⁹"
std::string scientific(double exact) {
  static constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
  const double value = rounded(exact, 2);
  if (value == 0.0) return "0";
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
  const std::string digits = print("%.*f", 1, value / std::pow(10.0, power));
  std::string text = digits == "1.0" ? "10" : digits + "·10";
  if (power < 0) text += "⁻";
  for (const char c : std::to_string(std::abs(power)))
    text += raised[static_cast<std::size_t>(c - '0')];
  return text;
}

// Whole per cents from ten on.
std::string per_cent(double share) {
  return std::abs(share) >= 0.0995 ? fixed(100.0 * share, 0) : significant(100.0 * share, 2);
}

Shown shown_pressure(double pascal) {
  const double size = std::abs(rounded(pascal, 4));
  if (size >= 1.0 && size < 1e4) return {significant(pascal, 4), "Pa"};
  return prefixed(pascal, 4, "Pa");
}

std::string without_trailing_zeros(std::string number) {
  if (number.find('.') == std::string::npos || number.find('e') != std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

Shown shown_time(double seconds) {
  const double size = std::abs(rounded(seconds, 3));
  if (size >= 600.0) return {without_trailing_zeros(significant(seconds / 60.0, 3)), "min"};
  if (size >= 100.0) return {fixed(seconds, 0), "s"};
  return {without_trailing_zeros(significant(seconds, 3)), "s"};
}

}  // namespace

std::string fixed(double value, int decimals) { return print("%.*f", decimals, value); }

std::string significant(double exact, int digits) {
  const double value = rounded(exact, digits);
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= 1e6 || size < 1e-4) return print("%.*e", digits - 1, value);
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return fixed(value, std::max(0, digits - before));
}

std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

std::string with_prefix(double value, int digits, std::string_view unit) {
  const Shown shown = prefixed(value, digits, std::string(unit).c_str());
  return shown.number + narrow_space + shown.unit;
}

Shown show(Quantity quantity, double value) {
  if (!std::isfinite(value)) return {"\u2013", ""};
  switch (quantity) {
    case Quantity::temperature:
      return {fixed(value - zero_celsius, 1), "°C"};
    case Quantity::temperature_difference:
      return {fixed(value, std::abs(rounded(value, 2)) < 1 ? 2 : 1), "K"};
    case Quantity::delta:
      return {fixed(value, 4), ""};
    case Quantity::ratio:
      return {significant(value, 3), ""};
    case Quantity::share:
      return {per_cent(value), "%"};
    case Quantity::residual:
      return {scientific(value), ""};
    case Quantity::count:
      return {grouped(static_cast<std::uint64_t>(std::llround(value))), ""};
    case Quantity::time:
      return shown_time(value);
    case Quantity::length:
      return {significant(1e3 * value, 3), "mm"};
    case Quantity::mass:
      return prefixed(1e3 * value, 4, "g");
    case Quantity::energy:
      return prefixed(value, 3, "J");
    case Quantity::pressure:
      return shown_pressure(value);
    case Quantity::amount:
      return prefixed(value, 3, "mol");
    case Quantity::specific_amount:
      if (std::abs(value) < 0.01) return prefixed(value, 3, "mol/kg");
      return {significant(value, 3), "mol/kg"};
  }
  return {};
}

std::string with_unit(Quantity quantity, double value) {
  const Shown shown = show(quantity, value);
  if (shown.unit.empty()) return shown.number;
  return shown.number + narrow_space + shown.unit;
}

std::string difference(Quantity quantity, double change) {
  if (!std::isfinite(change)) return "\u2013";
  if (change == 0.0) return "±0";
  const Quantity kind =
      quantity == Quantity::temperature ? Quantity::temperature_difference : quantity;
  const std::string size = with_unit(kind, std::abs(change));
  return (change > 0.0 ? "+" : minus) + size;
}

std::string escape(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8) | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[(word >> (18 - 6 * k)) & 63u] : '=';
  }
  return text;
}

std::string join(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) {
    if (!text.empty()) text += between;
    text += part;
  }
  return text;
}

std::string element(std::string_view tag, std::string_view content, std::string_view attributes) {
  std::string html = "<";
  html += tag;
  if (!attributes.empty()) (html += ' ') += attributes;
  ((html += '>') += content) += "</";
  return (html += tag) += ">\n";
}

std::string table(const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows, std::string_view attributes) {
  std::string cells;
  for (const std::string& title : head) cells += element("th", title, "scope=\"col\"");
  std::string body;
  for (const auto& row : rows) {
    std::string line;
    for (const std::string& cell : row) line += element("td", cell);
    body += element("tr", line);
  }
  const std::string top = head.empty() ? "" : element("thead", element("tr", cells));
  const std::string inside = element("table", top + element("tbody", body), attributes);
  return element("div", inside, "class=\"scroll\"");
}

}  // namespace pmr::report
