// Compressed sparse rows.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pmr {

struct Csr {
  std::vector<std::uint64_t> start{0};  // [rows + 1], row i holds entries start[i]..start[i+1]
  std::vector<std::uint32_t> column;    // [entries], ascending within a row
  std::vector<double> value;            // [entries], unit of the matrix

  std::size_t rows() const { return start.size() - 1; }
  std::size_t entries() const { return column.size(); }
  std::span<const std::uint32_t> columns(std::size_t row) const {
    return {column.data() + start[row], column.data() + start[row + 1]};
  }
  std::span<const double> values(std::size_t row) const {
    return {value.data() + start[row], value.data() + start[row + 1]};
  }
};

}  // namespace pmr
