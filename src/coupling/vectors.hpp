// SUNDIALS vectors whose operations run on all cores, block by block: sums have the same bits on
// any number of threads, which SUNDIALS' own OpenMP and pthreads vectors don't promise.
#pragma once
#include <vector>

// SUNDIALS' own names of N_Vector and SUNContext, whose headers stay out of ours.
// NOLINTBEGIN(bugprone-reserved-identifier)
struct _generic_N_Vector;
struct _SUNContext;
// NOLINTEND(bugprone-reserved-identifier)

namespace pmr::coupling {

// A view of `data`, which must outlive it; the caller destroys it. Clones work likewise, on data of
// their own.
_generic_N_Vector* make_vector(std::vector<double>& data, _SUNContext* context);

}  // namespace pmr::coupling
