// History of contacts: what the tangential and rolling springs remember. Rows follow the particles'
// order; within a row entries are sorted by partner. A pair of particles stands once, in the row of
// the lower id, partner the higher id. A wall contact stands in the particle's row, partner the
// index of the surface. Only touching contacts are kept.
#pragma once
#include <cstdint>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr {

struct ContactHistory {
  std::vector<std::uint32_t> start{0};  // [particles + 1]
  std::vector<std::uint32_t> partner;   // [contacts] particle id or surface index
  std::vector<Vec3> tangential;         // [contacts] tangential displacement d_t [m]
  std::vector<Vec3> rolling;            // [contacts] rolling spring torque [N m]
};

}  // namespace pmr
