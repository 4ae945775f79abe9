#include "physics/upright.hpp"

#include <Eigen/Geometry>

namespace pmr::physics {

std::optional<Vec3> up_against(const Vec3& gravity) {
  const double size = gravity.norm();
  if (!(size > 0.0)) return std::nullopt;
  return Vec3(-gravity / size);
}

bool is_z(const Vec3& up) { return (up - Vec3::UnitZ()).norm() < 1e-9; }

Eigen::Matrix3d upright_frame(const Vec3& up) {
  if (is_z(up)) return Eigen::Matrix3d::Identity();
  return Eigen::Quaterniond::FromTwoVectors(up, Vec3::UnitZ()).toRotationMatrix();
}

std::vector<Vec3> upright(const std::vector<Vec3>& places, const Vec3& up) {
  const Eigen::Matrix3d frame = upright_frame(up);
  std::vector<Vec3> turned;
  turned.reserve(places.size());
  for (const Vec3& place : places) turned.push_back(is_z(up) ? place : Vec3(frame * place));
  return turned;
}

}  // namespace pmr::physics
