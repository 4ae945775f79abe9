// Which way is up: against gravity.
#pragma once
#include <optional>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr::physics {

// Unit vector [1]; none without gravity [m/s2].
std::optional<Vec3> up_against(const Vec3& gravity);

// True where up is +z, to rounding.
bool is_z(const Vec3& up);

// Turns `up` to +z: rows are the axes of the upright frame. Exactly the identity where it is z.
Eigen::Matrix3d upright_frame(const Vec3& up);

// Places [m] in that frame.
std::vector<Vec3> upright(const std::vector<Vec3>& places, const Vec3& up);

}  // namespace pmr::physics
