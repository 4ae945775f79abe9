// Numbers and text for people: as many digits as they deserve, safe inside HTML.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pmr::report {

// What a number is, which decides its unit and digits on the page. Values are in SI.
enum class Quantity {
  temperature,             // [K], shown in degC
  temperature_difference,  // [K]
  delta,                   // [1]
  ratio,                   // [1] three digits
  share,                   // [1], shown in %
  residual,                // [1] scientific
  count,                   // [1] whole
  time,                    // [s]
  length,                  // [m], shown in mm
  mass,                    // [kg], shown with a prefix of g
  energy,                  // [J], with prefix
  pressure,                // [Pa], with prefix
  amount,                  // [mol], with prefix
  specific_amount,         // [mol/kg]
};

struct Shown {
  std::string number;  // "912.3"
  std::string unit;    // "°C", may be empty
};
Shown show(Quantity quantity, double value);               // "–" for a value that is not finite
std::string with_unit(Quantity quantity, double value);    // "912.3 °C", no break between them
std::string difference(Quantity quantity, double change);  // "+3.1 K", "−0.012", "±0"

std::string significant(double value, int digits);                         // "0.00312", "1.2e-09"
std::string fixed(double value, int decimals);                             // "3.10"
std::string grouped(std::uint64_t count);                                  // "173,769"
std::string with_prefix(double value, int digits, std::string_view unit);  // "3.31 kJ"

std::string escape(std::string_view text);  // & < > " for HTML
std::string base64(const std::vector<std::uint8_t>& bytes);
std::string join(const std::vector<std::string>& parts, std::string_view between);

// <tag attributes>content</tag>; the content is HTML already.
std::string element(std::string_view tag, std::string_view content,
                    std::string_view attributes = "");
// A table: head and rows of HTML cells; columns after the first are aligned as numbers.
std::string table(const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows,
                  std::string_view attributes = "");

}  // namespace pmr::report
