// The forces of listed pairs of spheres, several at a time: the inner loop of the program. It is
// compiled for AVX2 and for AVX-512 and chosen when the program starts, so that one executable
// serves all nodes of a cluster; both give the same bits (IEEE operations in the same order).
// Plain data only: what both translation units see must hold no code that they would share.
#pragma once
#include <cstddef>
#include <cstdint>

#include "physics/contact_force.hpp"

namespace pmr::physics {

// Eight pairs under one law and their springs, field by field. Spheres are named by their index
// times `index_step`, which is what addresses need.
struct alignas(64) PairGroup {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t index_step = 8;
  std::uint32_t i[count], j[count];  // unused lanes repeat the first
  double tangential[3][count];       // [m] zero where the pair does not touch
  double rolling[3][count];          // [N m] likewise
  std::uint32_t law;                 // index into the laws
  std::uint8_t used;                 // bit per lane
  std::uint8_t touching;             // bit per lane, since the last evaluation
  std::uint8_t own_i, own_j;         // bit per lane: the sphere is one whose load is added up
};

struct PairWork {
  const double* sphere;    // [4 per sphere] centre [m], radius [m]
  const double* kinetics;  // [8 per sphere] velocity [m/s], 1/mass [1/kg], spin [rad/s], -
  double* load;            // [8 per own sphere] force [N], -, torque [N m], -: added to
  std::uint32_t first;     // first own sphere times PairGroup::index_step
  const ContactLaw* laws;
  PairGroup* groups;
  std::size_t group_count;
  double dt;  // [s]
};

// Sums of one force pass.
struct ContactBook {
  double elastic = 0.0;        // [J] energy of the Hertz springs
  double wall_work = 0.0;      // [J] done by moving walls on particles in the step
  double overlap_ratio = 0.0;  // [1] largest overlap over the smaller radius
};

// Evaluates all pairs and adds their forces to the loads of their own spheres; a pair's elastic
// energy counts where sphere i is an own one.
using PairKernel = ContactBook (*)(const PairWork&);

// Which of ForceLaw and of RollingLaw: their places in the sets.
struct LawPair {
  std::size_t force, rolling;
};
LawPair places_of(const ContactModel& model);

PairKernel pair_kernel_avx2(LawPair laws);
PairKernel pair_kernel_avx512(LawPair laws);

// The fastest that this processor can run.
PairKernel best_pair_kernel(LawPair laws);

}  // namespace pmr::physics
