// SUNDIALS vectors whose operations run on all cores, block by block: sums have the same bits on
// any number of threads, which SUNDIALS' own OpenMP and pthreads vectors don't promise.
#pragma once
#include <nvector/nvector_serial.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace pmr::coupling {

using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, void (*)(N_Vector)>;

// A view of `data`, which must outlive it. Its clones work likewise, on data of their own.
Vector make_vector(std::vector<double>& data, SUNContext context);

}  // namespace pmr::coupling
