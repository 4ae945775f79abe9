// Where a sphere comes near the walls, and which of these places are one surface: the rule that
// forces and heat share (docs/theory.md, section 2).
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "physics/motion.hpp"
#include "physics/wall_tree.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::physics {

// The point of one surface that is nearest to a sphere's centre.
struct Foot {
  std::uint32_t surface;
  std::uint32_t place;  // where the caller finds the surface again
  Vec3 point;           // [m]
  Vec3 towards;         // [1] unit, from the centre to the point
  double distance;      // [m] of the centre, not 0
  double share = 1.0;   // [1] of a contact or link that it carries
};

// Part [1] in which b counts beside the nearer a: 0 while b, seen from the centre, stands out of
// the tangent plane of a by no more than two walls that meet under 15 degrees do, 1 from 25 degrees
// on, linear between (in the cosine), so that force and heat have no jump.
inline double part_beside(const Foot& a, const Foot& b) {
  constexpr double one_surface = 0.9659258262890683;           // cos 15 deg [1]
  constexpr double two_surfaces = 0.9063077870366499;          // cos 25 deg [1]
  const double depth = b.distance * b.towards.dot(a.towards);  // [m] along the normal of a
  return std::clamp(
      (one_surface * a.distance - depth) / ((one_surface - two_surfaces) * a.distance), 0.0, 1.0);
}

// True if the foot lies on one of the nearer surfaces [nearer, foot): an edge or seam that they
// share, no place of its own. Gaps of seams up to a micrometre count as closed: STL files store
// single precision (30 nm at 0.3 m), and the parts of a CAD model do not meet more exactly.
template <class DistanceTo>
bool lies_on_nearer(const Foot* nearer, const Foot* foot, double radius,
                    const DistanceTo& distance_to) {
  const double seam = std::min(1e-6, 0.01 * radius);  // [m]
  for (const Foot* other = foot; other-- != nearer;)  // neighbours have like distances: last first
    if (distance_to(*other, foot->point) <= seam) return true;
  return false;
}

// Leaves one foot for each surface: of all feet round a sphere of this radius [m], those that count
// (share > 0), nearest first, equal ones by their surface. `distance_to(foot, x)`: distance of the
// foot's surface from x [m].
template <class DistanceTo>
void keep_one_per_surface(std::vector<Foot>& feet, double radius, const DistanceTo& distance_to) {
  if (feet.size() < 2) return;
  std::sort(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.surface < b.surface;
  });
  std::size_t kept = 1;  // they stand in front; all before k are nearer than k
  for (std::size_t k = 1; k < feet.size(); ++k) {
    Foot& foot = feet[k];
    for (std::size_t a = 0; a < kept && foot.share > 0.0; ++a)
      foot.share = std::min(foot.share, 1.0 - feet[a].share * (1.0 - part_beside(feet[a], foot)));
    if (foot.share <= 0.0 || lies_on_nearer(feet.data(), &foot, radius, distance_to)) continue;
    std::swap(feet[kept++], foot);
  }
  feet.resize(kept);
}

// Walls as they stand at one moment, to be asked for the feet of any sphere.
class WallFeet {
 public:
  // Surfaces that hold no particles or are not there at time t [s] have no feet. Keeps references.
  WallFeet(const Walls& walls, double t);

  // One foot for each surface that is closer to x [m] than `reach` [m], nearest first.
  std::vector<Foot> near(const Vec3& x, double radius, double reach) const;

  // The same point in the frame of the foot's body [m].
  Vec3 in_body(const Foot& foot) const {
    return pose_[walls_.surfaces[foot.surface].body].to_body(foot.point);
  }

 private:
  const Walls& walls_;
  WallTree tree_;
  std::vector<Pose> pose_;             // [bodies]
  std::vector<std::uint8_t> present_;  // [surfaces]
};

}  // namespace pmr::physics
