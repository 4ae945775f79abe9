// A bed of spheres as a porous medium for gas.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pmr/state/particles.hpp"

namespace pmr::physics {

// Carman and Kozeny: d^2 psi^3/(180 (1 - psi)^2) [m2] of spheres of Sauter diameter d [m] at
// porosity psi [1].
double carman_kozeny(double sauter_diameter, double porosity);

// Radius [m] of the straight capillaries that have this permeability [m2]: K = psi r^2/(8 tau).
double capillary_radius(double permeability, double porosity, double tortuosity);

// What slip at the capillaries' walls multiplies viscous flow by [1]: 1 + 4 lambda/r (Klinkenberg
// 1941).
double slip_factor(double mean_free_path, double capillary_radius);

// A horizontal layer of a bed at rest.
struct BedLayer {
  double area;             // [m2] of its cross-section, the convex hull of its spheres' circles
  double height;           // [m]
  double solid_volume;     // [m3]
  double surface;          // [m2] of its solids
  double sauter_diameter;  // [m] 6 V/A

  double pore_volume() const { return area * height - solid_volume; }
  double porosity() const { return pore_volume() / (area * height); }
};

struct LayeredBed {
  std::vector<BedLayer> layers;         // from the bottom
  std::vector<std::uint32_t> layer_of;  // by particle index: that of its centre
};

// Corners of the convex hull of the spheres' circles, seen along z, counter-clockwise [m].
using Footprint = std::vector<Eigen::Vector2d>;
Footprint footprint(std::span<const Vec3> places, std::span<const double> radii);
double area(const Footprint& corners);                               // [m2]
bool is_inside(const Footprint& corners, const Eigen::Vector2d& p);  // on the edge counts

// Cuts the bed from its lowest point to the height, along `up`, that `part` [1] of the particles
// stay below into layers of equal height: `most` of them, or as many as are no thinner than the
// largest diameter, since less is no porous medium; one at least. Spheres are cut where the layers
// are; what lies higher belongs to the uppermost as a whole. A layer's hull is that of all spheres,
// so that walls stay straight.
LayeredBed cut_in_layers(const Particles& particles, std::size_t most,
                         const Vec3& up = Vec3::UnitZ(), double part = 0.99);

}  // namespace pmr::physics
