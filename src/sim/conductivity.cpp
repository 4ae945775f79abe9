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
#include "radiation/cells.hpp"

namespace pmr::sim {
namespace {

// The part of the bed that stands for its inside: the middle half of its height, three diameters
// away from the side, where the packing knows nothing of the walls.
struct Core {
  double low, high;  // [m]
  Eigen::Vector2d axis;
  double radius;  // [m]
  double volume() const { return pi * radius * radius * (high - low); }

  // The part of the way from a to b that lies inside [1].
  double part_inside(const Vec3& a, const Vec3& b) const {
    double from = 0.0, to = 1.0;
    const Vec3 way = b - a;
    const auto clip = [&](double begin, double end) {
      from = std::max(from, std::min(begin, end));
      to = std::min(to, std::max(begin, end));
    };
    if (way.z() != 0.0) clip((low - a.z()) / way.z(), (high - a.z()) / way.z());
    const Eigen::Vector2d p = a.head<2>() - axis, q = way.head<2>();
    const double square = q.squaredNorm(), half = p.dot(q);
    const double root = half * half - square * (p.squaredNorm() - radius * radius);
    if (root < 0.0) return 0.0;
    if (square > 0.0) clip((-half - std::sqrt(root)) / square, (-half + std::sqrt(root)) / square);
    return std::max(0.0, to - from);
  }
};

Core core_of(const Particles& p) {
  double foot = p.position.front().z(), top = foot, largest = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    foot = std::min(foot, p.position[i].z());
    top = std::max(top, p.position[i].z());
    largest = std::max(largest, 2.0 * p.radius[i]);
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& x : p.position) box.extend(x);
  const Vec3 middle = box.center();
  const instruments::Vessel vessel =
      instruments::enclosing_vessel(p, Vec3(middle.x(), middle.y(), foot));
  return {foot + 0.25 * (top - foot), top - 0.25 * (top - foot), middle.head<2>(),
          std::max(0.5 * vessel.radius, vessel.radius - 3.0 * largest)};
}

// Solid fraction of the core [1], by the share of a lattice of points that lie within a sphere.
double solid_fraction(const Particles& p, const Core& core) {
  std::vector<radiation::Sphere> spheres;
  for (std::size_t i = 0; i < p.size(); ++i) spheres.push_back({p.position[i], p.radius[i], 0});
  const radiation::Scene scene(spheres, {});
  const radiation::Cells cells(scene);
  constexpr int steps = 60;  // across the diameter: 1e5 points
  const double step = 2.0 * core.radius / steps;
  const int levels = std::max(1, static_cast<int>((core.high - core.low) / step));
  double points = 0.0, solid = 0.0;
  for (int k = 0; k < steps * steps * levels; ++k) {
    const int row = k / steps % steps, level = k / (steps * steps);
    const Eigen::Vector2d across(step * (k % steps + 0.5) - core.radius,
                                 step * (row + 0.5) - core.radius);
    if (across.norm() > core.radius) continue;
    const double z = core.low + (core.high - core.low) * (level + 0.5) / levels;
    const Vec3 point(core.axis.x() + across.x(), core.axis.y() + across.y(), z);
    points += 1.0;
    solid += cells.covering(point) == radiation::none ? 0.0 : 1.0;
  }
  return solid / points;
}

// The case with its plates at a temperature, and the state with every particle at it.
struct Bench {
  Case setup;
  State state;
  coupling::Nodes nodes;
  coupling::Gaps gaps;
  const ConductivityInstrument& tool;

  Bench(const Case& c, const State& s)
      : setup(c),
        state(s),
        nodes(coupling::number_nodes(c, s.opening.particles)),
        tool(*c.conductivity) {
    hold_plates(tool.temperatures.front());
    coupling::number_in_space(state.particles, nodes);
    gaps = coupling::find_gaps(setup, nodes, state);
  }

  void hold_plates(double T) {
    for (const std::uint32_t plate : {tool.hot, tool.cold})
      setup.walls.surfaces[plate].thermal = FixedTemperature{T};
  }

  void set_temperature(double T) {
    hold_plates(T);
    for (double& t : state.particles.temperature) t = T;
    state.exchange = coupling::retrace(setup, nodes, state, setup.models.radiation->rays_settled);
  }

  // Steady temperatures by node [K].
  std::vector<double> solve(double T, const std::vector<coupling::HeatLink>& links) const {
    std::vector<char> is_held(nodes.count(), 1);
    std::vector<double> temperature(nodes.count(), T);
    for (const ParticleId id : state.particles.id)
      for (std::size_t k = 0; k < nodes.shells; ++k) is_held[nodes.shell(id, k)] = 0;
    for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
      if (nodes.patches[k].surface == tool.hot)
        temperature[nodes.patch(k)] += 0.5 * tool.difference;
      if (nodes.patches[k].surface == tool.cold)
        temperature[nodes.patch(k)] -= 0.5 * tool.difference;
    }
    return coupling::steady_temperatures(links, &state.exchange.factor, is_held, temperature);
  }
};

// Slope dT/dz [K/m] of a least-squares line through the particles of the core's height.
double slope(const Bench& bench, const Core& core, const std::vector<double>& temperature) {
  const Particles& p = bench.state.particles;
  double n = 0.0, z = 0.0, T = 0.0, zz = 0.0, zT = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double at = p.position[i].z();
    if (at < core.low || at > core.high) continue;
    n += 1.0;
    z += at;
    const double there = temperature[bench.nodes.particle(p.id[i])];
    T += there;
    zz += at * at;
    zT += at * there;
  }
  return (n * zT - z * T) / (n * zz - z * z);
}

// Mean flux density [W/m2] down through the core by path: every link carries its heat along the
// line between its two centres, sum_links Q (z_a - z_b) (part inside)/V (Irving & Kirkwood, J.
// Chem. Phys. 18 (1950) 817). Walls stand outside of the core.
BedConductivity flux_densities(const Bench& bench, const Core& core,
                               const std::vector<coupling::HeatLink>& links,
                               const std::vector<double>& temperature) {
  const Particles& p = bench.state.particles;
  std::vector<Vec3> place(bench.nodes.particles);  // by node
  for (std::size_t i = 0; i < p.size(); ++i) place[bench.nodes.particle(p.id[i])] = p.position[i];
  const auto lever = [&](std::size_t a, std::size_t b) {
    if (a >= place.size() || b >= place.size()) return 0.0;
    return (place[a].z() - place[b].z()) * core.part_inside(place[a], place[b]) / core.volume();
  };
  BedConductivity sum{};
  for (const coupling::HeatLink& link : links) {
    const double fall = lever(link.a, link.b) * (temperature[link.a] - temperature[link.b]);
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
        sum.radiation += g.value[k] * lever(a, g.column[k]) * (emission(a) - emission(g.column[k]));
  return sum;
}

// By the correlation, for the bed's mean sphere: the properties of the species, by mass.
double correlation(const Bench& bench, double solid_fraction, double T) {
  const Particles& p = bench.state.particles;
  const ChamberCase& gas = *bench.setup.chamber;
  double mass = 0.0, volume = 0.0, surface = 0.0;  // [kg], [m3] and [m2] over pi
  physics::PackedBed bed{
      solid_fraction, 0.0, 0.0, 0.0, T, chemistry::gas_conductivity(gas.oxygen_fraction, T), 0.0};
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

BedConductivities measure_conductivity(const Case& c, const State& state) {
  Bench bench(c, state);
  const Core core = core_of(state.particles);
  BedConductivities measured{solid_fraction(state.particles, core), {}};
  for (const double T : bench.tool.temperatures) {
    bench.set_temperature(T);
    for (const double pressure : bench.tool.pressures) {
      bench.setup.chamber->pressure = pressure;
      const auto links = coupling::conduct(bench.setup, bench.nodes, bench.state, bench.gaps,
                                           coupling::look_ahead(bench.setup, bench.state, 0.0));
      const auto temperature = bench.solve(T, links);
      BedConductivity point = flux_densities(bench, core, links, temperature);
      const double gradient = slope(bench, core, temperature);
      point.contact /= gradient;
      point.gap /= gradient;
      point.radiation /= gradient;
      point.temperature = T;
      point.pressure = pressure;
      point.correlation = correlation(bench, measured.solid_fraction, T);
      measured.points.push_back(point);
    }
  }
  return measured;
}

}  // namespace pmr::sim
