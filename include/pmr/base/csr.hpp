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

// The same rows with values in single precision, 8 bytes an entry to read instead of 12. Rounding
// is the same at (i, j) as at (j, i).
class RoundedRows {
 public:
  RoundedRows() = default;
  // Keeps referring to `matrix` for rows and columns.
  explicit RoundedRows(const Csr& matrix);

  bool is_empty() const { return matrix_ == nullptr; }
  std::size_t rows() const { return is_empty() ? 0 : matrix_->rows(); }
  std::span<const std::uint32_t> columns(std::size_t row) const { return matrix_->columns(row); }
  std::span<const float> values(std::size_t row) const {
    return {value_.data() + matrix_->start[row], value_.data() + matrix_->start[row + 1]};
  }

 private:
  const Csr* matrix_ = nullptr;
  std::vector<float> value_;  // [entries], unit of the matrix
};

// Sum over a row's entries of term(column, value), in four chains that do not wait for each other.
template <class Rows, class Term>
double sum_row(const Rows& matrix, std::size_t row, const Term& term) {
  const auto column = matrix.columns(row);
  const auto value = matrix.values(row);
  std::size_t k = 0;
  const std::size_t end = column.size();
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
  for (; k + 4 <= end; k += 4) {
    a += term(column[k], value[k]);
    b += term(column[k + 1], value[k + 1]);
    c += term(column[k + 2], value[k + 2]);
    d += term(column[k + 3], value[k + 3]);
  }
  for (; k < end; ++k) a += term(column[k], value[k]);
  return (a + b) + (c + d);
}

}  // namespace pmr
