// Who touches whom in a bed, layer by layer: what heat by contact has to go by.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/series.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::instruments {

// Particles whose centres lie within a range of heights, and the particles that these touch,
// wherever those lie.
struct ContactLayer {
  double top, bottom;                  // [m] above the lowest point of the bed
  std::vector<std::size_t> particles;  // [1] by species
  std::vector<std::size_t> partners;   // [1] by species that touches, then species touched

  // Mean number of particles of `other` that one of `species` touches [1]; NaN without any.
  double touched(std::size_t species, std::size_t other) const;
  // The same of all species, and of all but its own.
  double touched(std::size_t species) const;
  double touched_of_others(std::size_t species) const;
};

// `count` layers of one height between the bed's lowest point and its height along `up` [1]
// (bed.hpp), the first on top; what rises above that counts to it. Two particles touch where their
// surfaces meet or overlap. Walls do not count. None without particles.
std::vector<ContactLayer> contact_layers(const Particles& bed, std::size_t species, const Vec3& up,
                                         std::size_t count);
// All of them as one.
ContactLayer whole_bed(const std::vector<ContactLayer>& layers);

// A row a layer: particles of each species, and what one of them touches.
io::Series contact_table(const std::vector<ContactLayer>& layers,
                         const std::vector<std::string>& species);

}  // namespace pmr::instruments
