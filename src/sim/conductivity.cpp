#include "sim/conductivity.hpp"

#include <algorithm>
#include <cmath>

#include "chemistry/gas.hpp"
#include "coupling/heat_links.hpp"
#include "coupling/retrace.hpp"
#include "coupling/steady.hpp"
#include "instruments/bed.hpp"
#include "physics/bed_conductivity.hpp"
#include "physics/conduction.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::sim {
namespace {

// The part of the bed in which the slope and the flow are read.
struct Slab {
  double low, high;       // [m]
  double area;            // [m2] cross-section
  double solid_fraction;  // [1]

  // How much of the slab's height lies between two heights [1].
  double share(double z1, double z2) const {
    const double top = std::min(high, std::max(z1, z2)), foot = std::max(low, std::min(z1, z2));
    return std::max(0.0, top - foot) / (high - low);
  }
};

Slab middle_of(const Particles& p) {
  double foot = p.position.front().z(), top = foot;
  for (const Vec3& x : p.position) {
    foot = std::min(foot, x.z());
    top = std::max(top, x.z());
  }
  const instruments::Vessel vessel = instruments::enclosing_vessel(p, Vec3(0.0, 0.0, foot));
  const double area = pi * vessel.radius * vessel.radius;
  const double low = foot + 0.25 * (top - foot), high = top - 0.25 * (top - foot);
  return {low, high, area, instruments::solid_fraction(p, instruments::Slab{low, high, area})};
}

// The case with its plates at a temperature, and the state with every particle at it.
struct Bench {
  Case setup;
  State state;
  coupling::Nodes nodes;
  const ConductivityInstrument& tool;

  Bench(const Case& c, const State& s)
      : setup(c),
        state(s),
        nodes(coupling::number_nodes(c, s.opening.particles)),
        tool(*c.conductivity) {}

  void set_temperature(double T) {
    for (double& t : state.particles.temperature) t = T;
    for (const std::uint32_t plate : {tool.hot, tool.cold})
      setup.walls.surfaces[plate].thermal = FixedTemperature{T};
    state.exchange = coupling::retrace(setup, nodes, state, setup.models.radiation->rays_settled);
  }

  // Steady temperatures by node [K].
  std::vector<double> solve(double T, const std::vector<coupling::HeatLink>& links) const {
    std::vector<char> is_held(nodes.count(), 1);
    std::vector<double> temperature(nodes.count(), T);
    for (const ParticleId id : state.particles.id) is_held[id] = 0;
    for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
      if (nodes.patches[k].surface == tool.hot)
        temperature[nodes.patch(k)] += 0.5 * tool.difference;
      if (nodes.patches[k].surface == tool.cold)
        temperature[nodes.patch(k)] -= 0.5 * tool.difference;
    }
    return coupling::steady_temperatures(links, &state.exchange.factor, is_held, temperature);
  }
};

// Slope dT/dz [K/m] of a least-squares line through the particles of the slab.
double slope(const Particles& p, const Slab& slab, const std::vector<double>& temperature) {
  double n = 0.0, z = 0.0, T = 0.0, zz = 0.0, zT = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double at = p.position[i].z();
    if (at < slab.low || at > slab.high) continue;
    n += 1.0;
    z += at;
    T += temperature[p.id[i]];
    zz += at * at;
    zT += at * temperature[p.id[i]];
  }
  return (n * zT - z * T) / (n * zz - z * z);
}

// Mean flow [W] down through the slab's planes, by path. Links between particles alone: walls stand
// outside of the slab or are insulated.
BedConductivity flows(const Bench& bench, const Slab& slab,
                      const std::vector<coupling::HeatLink>& links,
                      const std::vector<double>& temperature) {
  const Particles& p = bench.state.particles;
  std::vector<double> height(bench.nodes.particles, 0.0);  // [m] by id
  for (std::size_t i = 0; i < p.size(); ++i) height[p.id[i]] = p.position[i].z();
  // towards the lower of the two, weighted with how much of the slab the link spans
  const auto down = [&](std::size_t a, std::size_t b) {
    if (a >= height.size() || b >= height.size()) return 0.0;
    return slab.share(height[a], height[b]) * (height[a] > height[b] ? 1.0 : -1.0);
  };
  BedConductivity sum{};
  for (const coupling::HeatLink& link : links) {
    const double fall = down(link.a, link.b) * (temperature[link.a] - temperature[link.b]);
    sum.contact += link.contact * fall;
    sum.gap += link.gap * fall;
  }
  const Csr& g = bench.state.exchange.factor;
  const auto emission = [&](std::size_t node) {
    return stefan_boltzmann * std::pow(temperature[node], 4);
  };
  for (std::size_t a = 0; a < g.rows(); ++a)
    for (std::uint64_t k = g.start[a]; k < g.start[a + 1]; ++k)
      if (g.column[k] > a)
        sum.radiation += g.value[k] * down(a, g.column[k]) * (emission(a) - emission(g.column[k]));
  return sum;
}

// By the correlation, for the bed's mean sphere: the properties of the species, by mass.
double correlation(const Bench& bench, const Slab& slab, double T) {
  const Particles& p = bench.state.particles;
  const ChamberCase& gas = *bench.setup.chamber;
  double mass = 0.0, volume = 0.0, surface = 0.0;  // [kg], [m3] and [m2] over pi
  physics::PackedBed bed{slab.solid_fraction,
                         0.0,
                         0.0,
                         0.0,
                         T,
                         chemistry::gas_conductivity(gas.oxygen_fraction, T),
                         0.0};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Material& m = bench.setup.materials.list[bench.setup.species[p.species[i]].material];
    const double d = 2.0 * p.radius[i];
    mass += p.mass[i];
    volume += d * d * d / 6.0;
    surface += d * d;
    bed.solid_conductivity += p.mass[i] * physics::conductivity(m.conductivity, T, gas.pressure);
    bed.emissivity += p.mass[i] * m.emissivity(T, p.delta[i]);
    bed.jump += p.mass[i] * 2.0 *
                chemistry::jump_length(gas.oxygen_fraction, T, gas.pressure, m.accommodation);
  }
  bed.diameter = 6.0 * volume / surface;  // Sauter
  bed.solid_conductivity /= mass;
  bed.emissivity /= mass;
  bed.jump /= mass;
  return physics::zehner_bauer_schluender(bed);
}

}  // namespace

std::vector<BedConductivity> measure_conductivity(const Case& c, const State& state) {
  Bench bench(c, state);
  const Slab slab = middle_of(state.particles);
  std::vector<BedConductivity> points;
  for (const double T : bench.tool.temperatures) {
    bench.set_temperature(T);
    for (const double pressure : bench.tool.pressures) {
      bench.setup.chamber->pressure = pressure;
      const auto links = coupling::conduct(bench.setup, bench.nodes, bench.state);
      const auto temperature = bench.solve(T, links);
      BedConductivity point = flows(bench, slab, links, temperature);
      const double per_flow = 1.0 / (slab.area * slope(state.particles, slab, temperature));
      point.contact *= per_flow;
      point.gap *= per_flow;
      point.radiation *= per_flow;
      point.temperature = T;
      point.pressure = pressure;
      point.correlation = correlation(bench, slab, T);
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace pmr::sim
