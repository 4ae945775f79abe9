#include "coupling/ray_count.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include "coupling/nodes.hpp"
#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"
#include "radiation/dealing.hpp"

namespace pmr::coupling {
namespace {

// eps A [m2] of each particle, at its first temperature.
std::vector<double> sphere_emissions(const Case& c) {
  std::vector<double> emissions;
  for (const Species& species : c.species) {
    const Material& material = c.materials.list[species.material];
    const double delta = material.redox ? initial_delta(c, species) : 0.0;
    const double emissivity = material.emissivity(species.initial_temperature, delta);
    for (std::size_t k = 0; k < species.count; ++k) {
      const double d = species.diameters.empty() ? species.diameter : species.diameters[k];
      emissions.push_back(emissivity * pi * d * d);
    }
  }
  return emissions;
}

// The same of each piece of wall whose temperature is computed: the others send no rays.
void add_wall_emissions(const Case& c, std::vector<double>& emissions) {
  for (const Patch& patch : number_nodes(c, 0).patches) {
    const Surface& surface = c.walls.surfaces[patch.surface];
    const auto* lining = std::get_if<Lining>(&surface.thermal);
    if (lining != nullptr)
      emissions.push_back(patch.area * c.materials.list[surface.material].emissivity(
                                           lining->initial_temperature, 0.0));
  }
}

}  // namespace

RayCount count_rays(const Case& c, double rays) {
  std::vector<double> emissions = sphere_emissions(c);
  const std::size_t spheres = emissions.size();
  add_wall_emissions(c, emissions);
  const auto none = [](double e) { return !(e > 0.0); };
  const bool has_spheres = spheres > 0;
  double least = 0.0;  // [m2]
  for (std::size_t k = 0; k < (has_spheres ? spheres : emissions.size()); ++k)
    if (!none(emissions[k]) && (least == 0.0 || emissions[k] < least)) least = emissions[k];
  emissions.erase(std::remove_if(emissions.begin(), emissions.end(), none), emissions.end());
  if (least == 0.0) return {};
  const radiation::Dealing dealing = radiation::deal(emissions, least, rays);
  RayCount count;
  for (const double e : emissions) {
    count.sent += dealing.sent(e);
    count.wanted += dealing.wanted(e);
  }
  return count;
}

}  // namespace pmr::coupling
