#include "physics/pair_forces.hpp"

namespace pmr::physics {

ContactBook pair_forces_avx2(const PairWork& work) { return pair_forces(work); }

}  // namespace pmr::physics
