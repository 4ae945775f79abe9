#include "io/series.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::io {
namespace {

void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

}  // namespace

bool Series::has(const std::string& name) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Column& column) { return column.name == name; });
}

const std::vector<double>& Series::values(const std::string& name) const {
  for (const Column& column : columns)
    if (column.name == name) return column.values;
  throw CaseError({Fault{"series", name, "no such column was recorded"}});
}

std::optional<Peak> peak_of(const Series& series, const std::string& name) {
  if (!series.has(name) || !series.has("time")) return std::nullopt;
  const std::vector<double>& values = series.values(name);
  std::optional<Peak> peak;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (std::isfinite(values[row]) && (!peak || values[row] > peak->value))
      peak = Peak{row, series.values("time")[row], values[row]};
  return peak;
}

double at_time(const Series& series, const std::string& name, double t) {
  const std::vector<double>&time = series.values("time"), &values = series.values(name);
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  if (after == time.end() || (after == time.begin() && *after > t)) return std::nan("");
  const auto k = static_cast<std::size_t>(after - time.begin());
  if (k == 0 || time[k] == t) return values[k];
  const double part = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

void write_csv(const std::filesystem::path& path, const Series& series) {
  std::string text;
  for (std::size_t c = 0; c < series.columns.size(); ++c)
    text += (c > 0 ? "," : "") + series.columns[c].name + " [" + series.columns[c].unit + "]";
  text += '\n';
  for (std::size_t row = 0; row < series.rows(); ++row) {
    for (std::size_t c = 0; c < series.columns.size(); ++c) {
      if (c > 0) text += ',';
      append_number(text, series.columns[c].values.at(row));
    }
    text += '\n';
  }
  replace_text(path, text);
}

}  // namespace pmr::io
