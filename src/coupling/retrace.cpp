#include "coupling/retrace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/heat_links.hpp"
#include "coupling/tessellate.hpp"
#include "physics/motion.hpp"
#include "physics/neighbours.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"
#include "radiation/exchange.hpp"

namespace pmr::coupling {
namespace {

std::vector<radiation::Sphere> spheres_of(const Nodes& nodes, const Particles& p) {
  std::vector<radiation::Sphere> spheres;
  for (std::size_t i = 0; i < p.size(); ++i)
    spheres.push_back({p.position[i], p.radius[i], nodes.particle(p.id[i])});
  return spheres;
}

std::vector<radiation::Triangle> walls_now(const Case& c, const Nodes& nodes, double t) {
  std::vector<radiation::Triangle> triangles;
  for (std::size_t s = 0; s < c.walls.surfaces.size(); ++s) {
    const Surface& surface = c.walls.surfaces[s];
    if (!is_present(surface, t)) continue;
    const physics::Pose pose = physics::pose(c.walls.bodies[surface.body].motion, t);
    for (const FlatTriangle& flat : tessellate(surface, c.domain_low, c.domain_high))
      triangles.push_back({{pose.to_world(flat.corner[0]), pose.to_world(flat.corner[1]),
                            pose.to_world(flat.corner[2])},
                           nodes.patch(nodes.first_patch[s] + flat.patch)});
  }
  return triangles;
}

// Areas by node [m2]; 0 for walls that are not there and for the surroundings.
std::vector<double> areas_of(const Case& c, const Nodes& nodes, const State& state) {
  std::vector<double> area(nodes.radiating(), 0.0);
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    area[nodes.particle(p.id[i])] = 4.0 * pi * p.radius[i] * p.radius[i];
  for (std::size_t k = 0; k < nodes.patches.size(); ++k)
    if (is_present(c.walls.surfaces[nodes.patches[k].surface], state.time))
      area[nodes.patch(k)] = nodes.patches[k].area;
  return area;
}

std::vector<char> reservoirs(const Case& c, const Nodes& nodes) {
  std::vector<char> reservoir(nodes.radiating(), 0);
  for (std::size_t k = 0; k < nodes.patches.size(); ++k)
    if (std::holds_alternative<FixedTemperature>(
            c.walls.surfaces[nodes.patches[k].surface].thermal))
      reservoir[nodes.patch(k)] = 1;
  return reservoir;
}

// How other codes have it: a particle radiates to the mean of its neighbours within one and a half
// diameters, whatever stands between, and walls see nothing. Both ends' shares are averaged, so
// that energy is kept, which those codes do not see to.
Exchange to_neighbours(const Nodes& nodes, const State& state, std::vector<double> emissivity,
                       const std::vector<double>& area) {
  const Particles& p = state.particles;
  const auto pairs = physics::pairs_within(p, 1.0);
  std::vector<double> neighbours(p.size(), 0.0);
  for (const auto& pair : pairs) {
    neighbours[pair.i] += 1.0;
    neighbours[pair.j] += 1.0;
  }
  const auto share = [&](std::size_t i) {  // [m2]
    const Node node = nodes.particle(p.id[i]);
    return emissivity[node] * area[node] / neighbours[i];
  };
  std::vector<HeatLink> links;
  for (const auto& pair : pairs) {
    const auto [a, b] = std::minmax({nodes.particle(p.id[pair.i]), nodes.particle(p.id[pair.j])});
    links.push_back({a, b, 0.5 * (share(pair.i) + share(pair.j)), 0.0});
  }
  std::sort(links.begin(), links.end(), comes_before);
  Exchange exchange;
  exchange.factor = symmetric_rows(links, nodes.radiating());
  exchange.self.assign(nodes.radiating(), 0.0);
  exchange.emissivity = exchange.traced_emissivity = std::move(emissivity);
  return exchange;
}

}  // namespace

std::vector<double> emissivities(const Case& c, const Nodes& nodes, const State& state) {
  std::vector<double> emissivity(nodes.radiating(), 0.0);
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    emissivity[nodes.particle(p.id[i])] =
        c.materials.list[c.species[p.species[i]].material].emissivity(p.temperature[i], p.delta[i]);
  const auto faces = patch_temperatures(c, nodes, state.walls);
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
    const Surface& surface = c.walls.surfaces[nodes.patches[k].surface];
    if (!std::holds_alternative<Adiabatic>(surface.thermal))
      emissivity[nodes.patch(k)] = c.materials.list[surface.material].emissivity(faces[k], 0.0);
  }
  emissivity[nodes.surroundings()] = 1.0;
  return emissivity;
}

double mean_change(const Case& c, const Nodes& nodes, const State& state,
                   const std::vector<double>& now, const std::vector<double>& then) {
  if (then.size() != now.size()) return std::numeric_limits<double>::infinity();
  const std::vector<double> area = areas_of(c, nodes, state);
  double change = 0.0, emission = 0.0;  // [W/sigma]
  const auto add = [&](std::size_t node, double T) {
    const double weight = area[node] * now[node] * T * T * T * T;
    if (!(weight > 0.0)) return;
    change += weight * std::abs(now[node] - then[node]);
    emission += weight;
  };
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i) add(nodes.particle(p.id[i]), p.temperature[i]);
  const auto faces = patch_temperatures(c, nodes, state.walls);
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) add(nodes.patch(k), faces[k]);
  return emission > 0.0 ? change / emission : 0.0;
}

double mean_displacement(const State& state) {
  const Particles& p = state.particles;
  const std::vector<Vec3>& then = state.exchange.traced_place;
  if (then.empty()) return std::numeric_limits<double>::infinity();
  const double sum = parallel_sum(p.size(), [&](std::size_t i) {
    return (p.position[i] - then[p.id[i]]).norm() / (2.0 * p.radius[i]);
  });
  return sum / static_cast<double>(p.size());
}

void rescale(const Case& c, const Nodes& nodes, State& state) {
  std::vector<double> emissivity = emissivities(c, nodes, state);
  std::vector<double> emission = areas_of(c, nodes, state);
  const std::vector<char> reservoir = reservoirs(c, nodes);
  for (std::size_t i = 0; i < emission.size(); ++i)
    emission[i] = reservoir[i] != 0 ? 0.0 : emission[i] * emissivity[i];
  radiation::rescale(std::move(emissivity), emission, state.exchange);
}

Exchange retrace(const Case& c, const Nodes& nodes, const State& state, double rays,
                 StopToken stop) {
  std::vector<double> emissivity = emissivities(c, nodes, state);
  std::vector<double> area = areas_of(c, nodes, state);
  Exchange exchange;
  if (c.models.radiation->law == RadiationLaw::environment) {
    exchange = to_neighbours(nodes, state, std::move(emissivity), area);
  } else {
    const auto spheres = spheres_of(nodes, state.particles);
    const auto triangles = walls_now(c, nodes, state.time);
    exchange = radiation::trace({spheres, triangles, std::move(emissivity), std::move(area),
                                 static_cast<std::uint32_t>(nodes.radiating()), rays, c.seed,
                                 state.interval, reservoirs(c, nodes), stop});
  }
  exchange.traced_at = state.time;
  exchange.traced_place.resize(nodes.particles);
  for (std::size_t i = 0; i < state.particles.size(); ++i)
    exchange.traced_place[state.particles.id[i]] = state.particles.position[i];
  return exchange;
}

}  // namespace pmr::coupling
