#include "pmr/base/csr.hpp"

#include "pmr/base/parallel.hpp"

namespace pmr {

RoundedRows::RoundedRows(const Csr& matrix) : matrix_(&matrix), value_(matrix.entries()) {
  parallel_for(value_.size(),
               [&](std::size_t k) { value_[k] = static_cast<float>(matrix.value[k]); });
}

}  // namespace pmr
