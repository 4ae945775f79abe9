// Walls: bodies that move, made of surfaces that have a shape, a material and a thermal boundary.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr {

// --- Shapes, in the frame of the body at rest. All are thin shells that touch from both sides.
// `normal` points to the side that faces particles and gas; only that side emits radiation.

// Infinite plane.
struct Plane {
  Vec3 point;   // [m]
  Vec3 normal;  // [1] unit
};

// Segment (r0, z0)-(r1, z1) of a half plane, turned about an axis: a cylinder (r0 = r1), a cone, a
// disc or ring (z0 = z1). Facing side: with t the unit tangent from point 0 to point 1 in (r, z),
// the normal is (t_z, -t_r) times `facing` (+1 or -1): a cylinder from z0 < z1 with facing -1
// faces inwards; a disc from r0 < r1 with facing -1 faces up the axis.
struct Revolved {
  Vec3 origin;    // [m]
  Vec3 axis;      // [1] unit
  double r0, z0;  // [m] from the axis; along the axis from origin
  double r1, z1;  // [m]
  double facing;  // +1 or -1 [1]
};

// One flat surface of triangles, all in one plane: contacts are one per facet.
struct Facet {
  std::vector<std::array<Vec3, 3>> triangles;  // [m], counter-clockwise seen from the facing side
  Vec3 normal;                                 // [1] unit
};

using Shape = std::variant<Plane, Revolved, Facet>;

// --- Motions, functions of the simulation time t [s].
struct Rest {};
// Falls freely from `release` by `stroke` along `direction`, then stops dead.
struct Fall {
  double release;       // [s]
  double stroke;        // [m]
  Vec3 direction;       // [1] unit
  double acceleration;  // [m/s2]
};
struct Translate {
  Vec3 velocity;         // [m/s]
  double begin, finish;  // [s]
};
// x = amplitude sin(2 pi frequency (t - begin)) from begin on.
struct Oscillate {
  Vec3 amplitude;    // [m]
  double frequency;  // [Hz]
  double begin;      // [s]
};
struct Rotate {
  Vec3 pivot;            // [m]
  Vec3 axis;             // [1] unit
  double rate;           // [rad/s]
  double begin, finish;  // [s]
};
using Motion = std::variant<Rest, Fall, Translate, Oscillate, Rotate>;

// --- Thermal boundaries.
struct Adiabatic {};  // re-radiates all it receives
struct FixedTemperature {
  double temperature;
};  // [K] a reservoir: heat to it is booked
struct LiningLayer {
  std::uint32_t material;  // index into Materials
  double thickness;        // [m]
};
// Transient 1-D profile through layers (the first faces the bed) to a convective outside.
struct Lining {
  std::vector<LiningLayer> layers;
  double initial_temperature;       // [K]
  double outside_film_coefficient;  // [W/m2/K]
  double outside_temperature;       // [K]
};
using ThermalBoundary = std::variant<Adiabatic, FixedTemperature, Lining>;

struct Surface {
  std::string name;  // "chamber.floor"
  Shape shape;
  std::uint32_t body = 0;      // index into Walls::bodies
  std::uint32_t material = 0;  // index into Materials: contact parameters and emissivity
  ThermalBoundary thermal = Adiabatic{};
  double from = -std::numeric_limits<double>::infinity();  // [s] present in [from, until)
  double until = std::numeric_limits<double>::infinity();  // [s]
  std::array<std::uint32_t, 2> patches{1, 1};  // Revolved: along the segment, round the axis
  bool holds_particles = true;  // false: seen by radiation only (openings' covers, doors)
};

struct Body {
  std::string name;
  Motion motion = Rest{};
};

// A sphere that adheres to a body: it moves as the body does and gives way to nothing. Particles
// meet it as they meet each other; it takes no part in heat, radiation and chemistry.
struct Grain {
  std::uint32_t body;      // index into Walls::bodies
  std::uint32_t material;  // index into Materials: contact parameters
  double radius;           // [m]
  Vec3 centre;             // [m] in the frame of the body at rest
};

struct Walls {
  std::vector<Body> bodies;
  std::vector<Surface> surfaces;
  std::vector<Grain> grains;
};

// What acts on a body.
struct Wrench {
  Vec3 force = Vec3::Zero();   // [N]
  Vec3 torque = Vec3::Zero();  // [N m] about the world's origin
};

// True while the surface is part of the rig at time t [s].
inline bool is_present(const Surface& surface, double t) {
  return surface.from <= t && t < surface.until;
}

}  // namespace pmr
