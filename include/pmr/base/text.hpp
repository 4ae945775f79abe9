// Text from outside, read in one way by every reader of files (case, CSV, dump, study).
#pragma once
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace pmr {

// Without the blanks round it.
std::string_view trimmed(std::string_view text);

// A decimal number at the beginning of a text: "1", "+1.0", "-2.5e-3"; nan and inf count.
struct LeadingNumber {
  double value;
  std::size_t length;  // [1] characters that it takes
};
std::optional<LeadingNumber> leading_number(std::string_view text);

// The whole text as a finite decimal number; none if anything else stands there.
std::optional<double> finite_number(std::string_view text);

// The whole text as a number of digits alone; none if anything else stands there.
std::optional<std::uint64_t> whole_number(std::string_view text);

// Passes over a byte order mark at the beginning of a file in UTF-8, as spreadsheets write it.
void skip_byte_order_mark(std::istream& in);

// The next line without its end, be that "\n" or "\r\n"; false at the file's end.
bool next_line(std::istream& in, std::string& line);

}  // namespace pmr
