#include "sim/heat_paths.hpp"

namespace pmr::sim {
namespace {

bool is_redox(const Case& c, std::size_t species) {
  return c.materials.list[c.species[species].material].redox.has_value();
}

bool has_both_kinds(const Case& c) {
  std::size_t redox = 0;
  for (std::size_t s = 0; s < c.species.size(); ++s) redox += is_redox(c, s) ? 1 : 0;
  return redox > 0 && redox < c.species.size();
}

// What species a gives to species b, a < b, counts with this sign [1]; 0: not at all.
double sign_of(const Case& c, std::size_t a, std::size_t b) {
  if (has_both_kinds(c)) return (is_redox(c, b) ? 1.0 : 0.0) - (is_redox(c, a) ? 1.0 : 0.0);
  return c.species[a].initial_temperature >= c.species[b].initial_temperature ? 1.0 : -1.0;
}

}  // namespace

HeatPaths heat_paths(const Case& c, const State& state) {
  const Breakdown& by = state.breakdown;
  const Groups groups{c.species.size()};
  HeatPaths paths;
  for (std::size_t a = 0; a < groups.species; ++a) {
    for (std::size_t b = a + 1; b < groups.species; ++b) {
      const double sign = sign_of(c, a, b);
      const std::size_t pair = groups.pair(a, b);
      paths.contact += sign * by.contact[pair];
      paths.gap += sign * by.gap[pair];
      paths.radiation += sign * by.radiation[pair];
    }
    const std::size_t wall = groups.pair(a, groups.walls());
    paths.to_walls += by.contact[wall] + by.gap[wall] + by.radiation[wall];
  }
  return paths;
}

std::vector<HeatPair> heat_pairs(const Case& c, const State& state) {
  std::vector<std::string> names;
  for (const Species& species : c.species) names.push_back(species.name);
  for (const char* other : {"walls", "surroundings", "gas"}) names.emplace_back(other);
  const Breakdown& by = state.breakdown;
  const Groups groups{c.species.size()};
  std::vector<HeatPair> pairs;
  for (std::size_t a = 0; a < groups.count(); ++a)
    for (std::size_t b = a + 1; b < groups.count(); ++b) {
      const std::size_t pair = groups.pair(a, b);
      pairs.push_back({names[a], names[b], by.contact[pair], by.gap[pair], by.radiation[pair]});
    }
  return pairs;
}

}  // namespace pmr::sim
