// Vectors of space: plain Eigen values, 24 bytes, no alignment demands.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace pmr {
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
}  // namespace pmr
