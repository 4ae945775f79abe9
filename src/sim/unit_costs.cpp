#include "sim/unit_costs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/heat_links.hpp"
#include "coupling/network.hpp"
#include "coupling/outlook.hpp"
#include "coupling/retrace.hpp"
#include "coupling/thermal_state.hpp"
#include "physics/mechanics.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/timer.hpp"
#include "sim/schedule.hpp"

namespace pmr::sim {
namespace {

constexpr double most = 2e4;    // [1] particles in the lattice: larger ones take seconds to set up
constexpr double enough = 3e6;  // [1] particle-steps to be measured
constexpr double few_rays = 4.0;     // [1] of each sphere, at least ...
constexpr double enough_rays = 2e5;  // [1] ... and of all, so that setting out is no matter

double number_of_particles(const Case& c) {
  double count = static_cast<double>(c.particles.size());
  for (const Species& s : c.species) count += static_cast<double>(s.count);
  return count;
}

// Nothing but the particles: no walls, no weight, no gas of its own.
Case without_surroundings(const Case& c) {
  Case lattice = c;
  lattice.walls = {};
  lattice.particles.clear();
  lattice.gravity = Vec3::Zero();
  lattice.chamber.reset();
  lattice.models.bed_gas.reset();
  lattice.domain_low = Vec3::Constant(-1e3);
  lattice.domain_high = Vec3::Constant(1e3);
  return lattice;
}

// A simple cubic lattice, six contacts a sphere, of the species in turn as they are mixed. All have
// the smallest species' radius: what costs time is their number.
State lattice_of(const Case& c, double count) {
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(std::max(8.0, count))));
  const double all = std::max(1.0, number_of_particles(c));
  double radius = std::numeric_limits<double>::infinity();
  for (const Species& s : c.species) radius = std::min(radius, 0.5 * s.diameter);
  State state;
  Particles& p = state.particles;
  resize(p, side * side * side);
  std::vector<double> share(c.species.size(), 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    std::size_t species = 0;
    for (std::size_t s = 0; s < share.size(); ++s) {
      share[s] += static_cast<double>(c.species[s].count) / all;
      if (share[s] > share[species]) species = s;
    }
    share[species] -= 1.0;
    const Species& s = c.species[species];
    p.id[i] = static_cast<ParticleId>(i);
    p.species[i] = static_cast<SpeciesIndex>(species);
    p.radius[i] = radius;
    p.mass[i] = 4.0 / 3.0 * pi * radius * radius * radius * c.materials.list[s.material].density;
    p.temperature[i] = s.initial_temperature;
    const std::size_t row = i / side, layer = row / side;
    p.position[i] = 1.995 * radius *
                    Vec3(static_cast<double>(i % side), static_cast<double>(row % side),
                         static_cast<double>(layer));
  }
  return state;
}

// Pairs and motion alone: lists and walls go with the bed, not with the machine.
double measure_mechanics(const Case& lattice, double count) {
  State state = lattice_of(lattice, std::min(count, most));
  const auto particles = static_cast<double>(state.particles.size());
  const auto steps = static_cast<std::uint64_t>(std::clamp(enough / particles, 10.0, 1e4));
  physics::Mechanics mechanics(lattice);
  Timings first, timings;
  mechanics.advance(state, 1, first);  // memory is touched for the first time
  mechanics.advance(state, steps, timings);
  double seconds = 0.0;
  for (const auto& [stage, sum] : timings.stages())
    if (stage == "mechanics.pairs" || stage == "mechanics.kick") seconds += sum;
  return seconds / static_cast<double>(steps) / particles;
}

void measure_heat(const Case& lattice, double count, UnitCosts& costs) {
  State state = lattice_of(lattice, std::min(count, most));
  const auto nodes = coupling::number_nodes(lattice, state.particles.size());
  const auto particles = static_cast<double>(state.particles.size());
  coupling::begin_thermal_state(lattice, nodes, state);
  Stopwatch watch;
  if (lattice.models.radiation) {
    state.exchange =
        coupling::retrace(lattice, nodes, state, std::max(few_rays, enough_rays / particles));
    const double seconds = watch.lap();
    if (state.exchange.rays > 0.0) costs.ray = seconds / state.exchange.rays;
  }
  const auto outlook = coupling::look_ahead(lattice, state, 0.0);
  auto links =
      coupling::conduct(lattice, nodes, state, coupling::find_gaps(lattice, nodes, state), outlook);
  costs.links = watch.lap() / particles;
  const double length = lattice.mix ? lattice.mix->heat_interval : lattice.react->first_interval;
  try {
    coupling::advance_network(lattice, nodes, outlook, std::move(links), {}, 0.0, length, state);
  } catch (const NumericsError&) {  // the time until then will do: a run tells what is wrong
  }
  costs.network = watch.lap() / particles;
}

}  // namespace

UnitCosts measure_costs(const Case& c) {
  UnitCosts costs;
  const double count = number_of_particles(c);
  if (c.species.empty() || count == 0.0) return costs;
  const Case lattice = without_surroundings(c);
  if (c.fill || c.mix) costs.particle_step = measure_mechanics(lattice, count);
  if (has_heat(c) && (c.mix || c.react)) measure_heat(lattice, count, costs);
  return costs;
}

}  // namespace pmr::sim
