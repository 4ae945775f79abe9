#include "physics/pair_forces.hpp"

namespace pmr::physics {

PairKernel pair_kernel_avx2(LawPair laws) {
  return kernel_of(laws, static_cast<const ForceLaw*>(nullptr));
}

}  // namespace pmr::physics
