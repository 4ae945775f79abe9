#include "pmr/base/csr.hpp"

#include <algorithm>

namespace pmr {

Csr assemble(std::size_t rows, std::vector<Triplet> triplets) {
  std::stable_sort(triplets.begin(), triplets.end(), [](const Triplet& a, const Triplet& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  Csr csr;
  csr.start.assign(rows + 1, 0);
  for (std::size_t k = 0; k < triplets.size(); ++k) {
    const Triplet& t = triplets[k];
    const bool repeated =
        k > 0 && triplets[k - 1].row == t.row && triplets[k - 1].column == t.column;
    if (repeated) {
      csr.value.back() += t.value;
      continue;
    }
    csr.column.push_back(t.column);
    csr.value.push_back(t.value);
    ++csr.start[t.row + 1];
  }
  for (std::size_t row = 0; row < rows; ++row) csr.start[row + 1] += csr.start[row];
  return csr;
}

}  // namespace pmr
