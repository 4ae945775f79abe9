#include "physics/pair_forces.hpp"

namespace pmr::physics {

ContactBook pair_forces_avx512(const PairWork& work) { return pair_forces(work); }

}  // namespace pmr::physics
