// The mechanics' working copy of the particles: what the sub-steps read and write, packed by who
// reads it. Lives for one call of Mechanics::advance.
#pragma once
#include <cstdint>
#include <vector>

#include "pmr/base/vec3.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::physics {

// Read by every search and every distance test (32 bytes).
struct Sphere {
  Vec3 position;  // [m]
  double radius;  // [m]
};

// Read by contacts (64 bytes).
struct Kinetics {
  Vec3 velocity;        // [m/s]
  double inverse_mass;  // [1/kg]
  Vec3 spin;            // [rad/s]
  std::uint32_t species;
  ParticleId id;
};

// Written by contacts, read by kicks (64 bytes).
struct Load {
  Vec3 force;              // [N] of contacts; weight is added by the kick
  double inverse_mass;     // [1/kg]
  Vec3 torque;             // [N m]
  double inverse_inertia;  // [1/kg/m2] of 2/5 m R^2
};

struct Spheres {
  std::vector<Sphere> sphere;
  std::vector<Kinetics> kinetics;
  std::vector<Load> load;
  std::size_t size() const { return sphere.size(); }
};

Spheres gather_spheres(const Particles& particles);
void put_back(const Spheres& spheres, Particles& particles);

// Sums of one block of a force pass, added up block by block.
struct ContactBook {
  double dissipated = 0.0;     // [J]
  double overlap_ratio = 0.0;  // [1] largest overlap over the smaller radius
};

inline constexpr std::size_t force_block = 512;  // [particles] of one block of a force pass

}  // namespace pmr::physics
