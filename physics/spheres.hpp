// The mechanics' working copy of the particles: what the sub-steps read and write, packed by who
// reads it. Lives for one call of Mechanics::advance.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/shapes.hpp"
#include "pmr/base/vec3.hpp"
#include "pmr/state/particles.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::physics {

// Read by every search and every distance test (32 bytes).
struct Sphere {
  Vec3 position;  // [m]
  double radius;  // [m]
};

// Read by contacts (64 bytes).
struct Kinetics {
  Vec3 velocity;           // [m/s]
  double inverse_mass;     // [1/kg]
  Vec3 spin;               // [rad/s]
  double inverse_inertia;  // [1/kg/m2] of 2/5 m R^2
};

// What contacts do to a particle in one sub-step (64 bytes).
struct Load {
  Vec3 force = Vec3::Zero();  // [N] of contacts; weight is added by the kick
  double unused_force = 0.0;
  Vec3 torque = Vec3::Zero();  // [N m]
  double unused_torque = 0.0;
};

// What a load on a sphere at x [m] does to what it leans on, in `passed` [s]: added to an impulse
// [N s, N m s].
inline void add_reaction(const Load& load, const Vec3& x, double passed, Wrench& impulse) {
  impulse.force -= passed * load.force;
  impulse.torque -= passed * (x.cross(load.force) + load.torque);
}

// Read when lists are built.
struct Label {
  std::uint32_t kind;  // of sphere: its species, or beyond them that of an adhered grain
  ParticleId id;
};

// What changes in every sub-step.
struct Places {
  std::vector<Sphere> sphere;
  std::vector<Kinetics> kinetics;
  std::vector<Box> block_box, run_box;                      // [blocks], [runs] of the centres [m]
  std::vector<VelocityRange> block_velocity, run_velocity;  // likewise, in the drift that led here
  void resize(std::size_t particles, std::size_t blocks);
};

struct Spheres : Places {
  std::vector<Label> label;
  std::vector<Load> load;               // at the borders of Mechanics::advance only
  std::size_t adhered_from = SIZE_MAX;  // spheres from this one on adhere to walls
  std::size_t size() const { return sphere.size(); }
};

Spheres gather_spheres(const Particles& particles);
// Sets the boxes of blocks and their runs to the places, the ranges to the velocities.
void bound(Spheres& spheres, const std::vector<Block>& blocks);

void put_back(const Spheres& spheres, Particles& particles);

}  // namespace pmr::physics
