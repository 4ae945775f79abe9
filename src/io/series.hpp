// Series: their peaks, and as comma-separated values.
#pragma once
#include <filesystem>
#include <optional>

#include "io/run_file.hpp"

namespace pmr::io {

// The first row in which a column has its largest value.
struct Peak {
  std::size_t row;
  double time, value;  // [s], [unit of the column]
};
// None without such a column, without times and where no value is finite.
std::optional<Peak> peak_of(const Series& series, const std::string& name);

// Value of a column at time t [s], straight between rows; NaN outside of them. CaseError without
// such a column.
double at_time(const Series& series, const std::string& name, double t);

// First line "name [unit]" per column, then a line a row; shortest digits that give back the same
// double; "nan" and "inf" where a value is not finite. Replaced atomically.
void write_csv(const std::filesystem::path& path, const Series& series);

}  // namespace pmr::io
