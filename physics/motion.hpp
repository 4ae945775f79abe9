// Where a moving body is, and how fast its points move.
#pragma once
#include "physics/shapes.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::physics {

// Rigid position of a body against its frame at rest: x_world = rotation x_body + translation.
struct Pose {
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero();  // [m]
  Vec3 velocity = Vec3::Zero();     // [m/s] of the point at the pivot
  Vec3 spin = Vec3::Zero();         // [rad/s]
  Vec3 pivot = Vec3::Zero();        // [m] world frame
  bool is_turned = false;           // false: the rotation is the identity

  Vec3 to_world(const Vec3& x) const {
    return is_turned ? Vec3(rotation * x + translation) : Vec3(x + translation);
  }
  Vec3 to_body(const Vec3& x) const {
    return is_turned ? Vec3(rotation.transpose() * (x - translation)) : Vec3(x - translation);
  }
  // Velocity of the body's point that is at x [m] of the world.
  Vec3 velocity_at(const Vec3& x) const { return velocity + spin.cross(x - pivot); }
};

Pose pose(const Motion& motion, double t);

// Bound on how far any of the body's points within `domain` moves in [t0, t1] [m].
double displacement_bound(const Motion& motion, double t0, double t1, const Box& domain);

}  // namespace pmr::physics
