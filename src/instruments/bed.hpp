// Figures of a bed at rest: height, packing, contacts, and how a species is spread.
#pragma once
#include <cstddef>
#include <vector>

#include "pmr/state/particles.hpp"
#include "pmr/state/state.hpp"

namespace pmr::instruments {

// Height above `floor` that 99 % of the mass does not rise above with its spheres' tops [m]: a
// grain stuck on a wall does not lift it. 0 without particles.
double bed_height(const Particles& bed, const Vec3& floor);

// The bed with `up` as its z axis: what all figures of a bed count as vertical.
Particles upright(const Particles& bed, const Vec3& up);
// The height [m] of the lowest point of any sphere.
double lowest_point(const Particles& bed);

// A horizontal slab of a vertical vessel.
struct Slab {
  double low, high;  // [m] z
  double area;       // [m2] cross-section of the vessel
};
// Volume of the spheres inside the slab over the slab's volume [1]; caps are cut exactly. NaN for
// a slab without volume.
double solid_fraction(const Particles& bed, const Slab& slab);

// Of the region that the bed fills, whatever vessel it lies in: from a largest diameter above
// `floor` [m] up to 90 % of the height and at least a diameter below the top, where the wall and
// the free surface loosen the packing, over the convex hull of the spheres there. NaN where they
// do not fill that: a heap, a bed round a rod or on a slope; where there is a hole of two largest
// diameters' size.
double solid_fraction(const Particles& bed, double floor);

// A round vertical vessel.
struct Vessel {
  Vec3 floor;     // [m] point of the axis
  double radius;  // [m]
};
// The vessel that just holds all particles: the chamber's radius to within an overlap.
Vessel enclosing_vessel(const Particles& bed, const Vec3& floor);

// Mean number of particles that a particle touches [1]: 2 contacts / particles; 0 without any.
double coordination_number(const State& state);

// Distribution of a quantity over a species, each particle weighted with its mass.
struct Spread {
  double mean, deviation;  // [unit of the quantity] deviation: root of the weighted variance
  double low, high;        // [same] 10 and 90 % of the mass lie at or below
};
struct SpeciesFigures {
  std::size_t count = 0;  // [1]
  double mass = 0.0;      // [kg]
  Spread temperature;     // [K]
  Spread delta;           // [1]
};
// Spreads are NaN for a species without particles.
SpeciesFigures species_figures(const Particles& particles, SpeciesIndex species);
// Of all the species that are chosen, by their index.
SpeciesFigures species_figures(const Particles& particles, const std::vector<bool>& chosen);

// Spread of values [any unit] with weights > 0 [any unit].
Spread weighted_spread(const std::vector<double>& values, const std::vector<double>& weights);

}  // namespace pmr::instruments
