// The decomposition tool of the demonstrator: the bed is taken off in layers from the top, each cut
// into sectors; what is left on the floor is the residuum. A particle belongs to the section that
// holds its centre.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::instruments {

// Whose masses are divided, by species: beads (Al2O3) over granules (SrFeO3).
enum class Side : std::uint8_t { beads, granules };
using Sides = std::vector<Side>;

// All inert species are beads and all redox species granules; where a case has but one of these
// kinds, its first species against all others; none with fewer than two species.
std::optional<Sides> beads_and_granules(const Case& setup);

// Contents of a layer or of one of its sections.
struct Portion {
  double bead_mass = 0.0;     // [kg]
  double granule_mass = 0.0;  // [kg]
  std::size_t beads = 0;      // [1]
  std::size_t granules = 0;   // [1]

  double mass() const { return bead_mass + granule_mass; }  // [kg]
  // w = bead mass / granule mass [1]; infinite without granules, NaN when empty.
  double mass_ratio() const;
};

struct Layer {
  Portion content;
  double mass = 0.0;                                 // [kg] of all species
  double top = 0.0, bottom = 0.0;                    // [m] heights of the cuts above the axis point
  std::vector<Portion> sectors;                      // by azimuth, the first at the ramp
  double thickness() const { return top - bottom; }  // [m]
};

struct BedSections {
  std::vector<Layer> layers;  // from the top
  Layer residuum;             // down to the floor
};

// Cuts so that each layer holds its fraction of the bed's mass to within half a particle. The top
// of layer 1 is the bed's height (bed.hpp), the bottom of the residuum the axis point's height.
BedSections decompose(const Particles& bed, const Decomposition& tool, const Sides& sides);

// Azimuth of the centre of a sector from the ramp [rad], in [0, 2 pi).
double sector_azimuth(const Decomposition& tool, std::size_t sector);

}  // namespace pmr::instruments
