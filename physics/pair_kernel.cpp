#include "physics/pair_kernel.hpp"

namespace pmr::physics {

PairKernel best_pair_kernel(LawPair laws) {
  __builtin_cpu_init();
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  return has_avx512 ? pair_kernel_avx512(laws) : pair_kernel_avx2(laws);
}

}  // namespace pmr::physics
