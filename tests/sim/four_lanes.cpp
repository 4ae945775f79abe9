// Linked before the library's own choice: the program then has four lanes (AVX2) on any processor.
#include "physics/pair_kernel.hpp"

namespace pmr::physics {

PairKernel best_pair_kernel(LawPair laws) { return pair_kernel_avx2(laws); }

}  // namespace pmr::physics
