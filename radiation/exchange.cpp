#include "radiation/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"
#include "radiation/dealing.hpp"
#include "radiation/emission.hpp"
#include "radiation/symmetry.hpp"

namespace pmr::radiation {
namespace {

constexpr int longest_flight = 10000;          // [1] reflections before a ray is given back
constexpr std::uint64_t rays_per_unit = 4096;  // [1] of one emitter, done in one go
constexpr std::size_t units_per_block = 16;    // [1] of one parallel task

// A run of rays of one emitter.
struct Unit {
  std::uint32_t node;
  std::uint64_t first, last;  // rays
};

struct UnitResult {
  CountRow hits;
  std::uint64_t unfinished = 0;
};

// Everything a flight needs, fixed for the tracing.
struct Setup {
  const ExchangeInput& input;
  const Tracer& tracer;
  const Emitters& emitters;
  const std::vector<std::uint64_t>& rays;  // [1] per node
};

double emission(const ExchangeInput& input, std::uint32_t node) {
  return input.emissivity[node] * input.area[node];  // [m2]
}

struct Rays {
  std::vector<std::uint64_t> sent;  // [1] per node; 0: does not emit
  std::vector<double> thinning;     // [1] per node, at least 1: wanted over sent
};

// In proportion to what each node emits, at least one, measured by the sphere that emits least.
Rays deal_rays(const ExchangeInput& input, const Emitters& emitters) {
  double least_sphere = std::numeric_limits<double>::infinity();  // [m2]
  const auto emits = [&](std::uint32_t node) {
    const bool reservoir = !input.reservoir.empty() && input.reservoir[node] != 0;
    return !reservoir && emission(input, node) > 0.0 && emitters.has_surface(node);
  };
  for (const Sphere& s : input.spheres)
    if (emits(s.node)) least_sphere = std::min(least_sphere, emission(input, s.node));
  std::vector<std::uint32_t> nodes;
  std::vector<double> emissions;  // [m2]
  for (std::uint32_t node = 0; node + 1 < input.nodes; ++node)
    if (emits(node)) {
      nodes.push_back(node);
      emissions.push_back(emission(input, node));
    }
  Rays rays{std::vector<std::uint64_t>(input.nodes, 0), std::vector<double>(input.nodes, 1.0)};
  if (nodes.empty()) return rays;
  const double least = std::isfinite(least_sphere)
                           ? least_sphere
                           : *std::min_element(emissions.begin(), emissions.end());
  const Dealing dealing = deal(emissions, least, input.rays);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double sent = dealing.sent(emissions[k]);
    rays.sent[nodes[k]] = static_cast<std::uint64_t>(sent);
    rays.thinning[nodes[k]] = dealing.wanted(emissions[k]) / sent;
  }
  return rays;
}

std::vector<Unit> cut_into_units(const std::vector<std::uint64_t>& rays, const Emitters& emitters) {
  std::vector<Unit> units;
  for (const std::uint32_t node : emitters.in_order())
    for (std::uint64_t first = 0; first < rays[node]; first += rays_per_unit)
      units.push_back({node, first, std::min(rays[node], first + rays_per_unit)});
  return units;
}

// The node that absorbs one ray; `none` if none has after `longest_flight` reflections.
std::uint32_t fly(const Setup& setup, Departure departure, std::uint32_t node, std::uint64_t ray) {
  const ExchangeInput& input = setup.input;
  Random random(input.seed, Purpose::rays, (static_cast<std::uint64_t>(node) << 32) | ray,
                input.step);
  for (int flight = 0; flight < longest_flight; ++flight) {
    const Landing landing = setup.tracer.land(departure);
    if (landing.is_empty()) return input.nodes - 1;
    const std::uint32_t met = setup.tracer.scene().node_of(landing.primitive);
    const double emissivity = input.emissivity[met];
    if (emissivity >= 1.0 || random.uniform() < emissivity) return met;
    const Hit hit = setup.tracer.hit_of(landing);
    const double u = random.uniform();
    const double v = random.uniform();
    departure = {hit.primitive, hit.point, hit.normal, diffuse(hit.normal, u, v)};
  }
  return none;
}

UnitResult trace_unit(const Setup& setup, const Unit& unit) {
  setup.input.stop.check();
  const QuasiPoints quasi(setup.input.seed, unit.node, setup.input.step);
  const auto rays = static_cast<double>(setup.rays[unit.node]);
  UnitResult result;
  Tally absorbers(unit.last - unit.first);
  const auto fly_one = [&](const Departure& departure, std::uint64_t ray) {
    const std::uint32_t absorber = fly(setup, departure, unit.node, ray);
    result.unfinished += absorber == none ? 1 : 0;
    absorbers.add(absorber == none ? unit.node : absorber);
  };
  const Scene& scene = setup.tracer.scene();
  if (const auto sphere = setup.emitters.only_sphere(scene, unit.node)) {
    for (std::uint64_t first = unit.first; first < unit.last; first += lanes) {
      const SphereDepartures eight = leave_sphere(quasi, first);
      for (int lane = 0; lane < lanes && first + static_cast<std::uint64_t>(lane) < unit.last;
           ++lane)
        fly_one(departure_of(scene, *sphere, eight, lane),
                first + static_cast<std::uint64_t>(lane));
    }
  } else {
    for (std::uint64_t ray = unit.first; ray < unit.last; ++ray) {
      const double fraction = (static_cast<double>(ray) + quasi.offset()) / rays;
      const std::uint32_t primitive = setup.emitters.pick(unit.node, fraction);
      fly_one(emit(scene, primitive, quasi.point(ray)), ray);
    }
  }
  result.hits = absorbers.row();
  return result;
}

void check(const ExchangeInput& input) {
  ensure(input.nodes >= 1, "there is a node for the surroundings");
  ensure(input.emissivity.size() == input.nodes && input.area.size() == input.nodes,
         "emissivity and area are given for each node");
  ensure(input.reservoir.empty() || input.reservoir.size() == input.nodes,
         "reservoirs are given for each node or not at all");
  for (std::uint32_t node = 0; node + 1 < input.nodes; ++node) {
    ensure(input.emissivity[node] >= 0.0 && input.emissivity[node] <= 1.0,
           "emissivities are within [0, 1]");
    ensure(input.area[node] >= 0.0, "areas are not negative");
  }
  for (const Sphere& s : input.spheres)
    ensure(s.node + 1 < input.nodes && input.area[s.node] > 0.0,
           "a sphere's node has an area and is below the surroundings'");
  for (const Triangle& t : input.triangles)
    ensure(t.node + 1 < input.nodes && input.area[t.node] > 0.0,
           "a triangle's node has an area and is below the surroundings'");
}

}  // namespace

Exchange trace(const ExchangeInput& input) {
  check(input);
  const Tracer tracer(input.spheres, input.triangles);
  const Emitters emitters(tracer.scene(), input.nodes);
  Rays rays = deal_rays(input, emitters);
  const Setup setup{input, tracer, emitters, rays.sent};
  const std::vector<Unit> units = cut_into_units(rays.sent, emitters);
  std::vector<UnitResult> results(units.size());
  parallel_for(
      units.size(), [&](std::size_t k) { results[k] = trace_unit(setup, units[k]); },
      units_per_block);

  Exchange traced;
  std::vector<CountRow> counts(input.nodes);
  std::vector<double> emissions(input.nodes, 0.0);  // [m2] of the nodes that emit
  for (std::size_t k = 0; k < units.size(); ++k) {
    add_counts(counts[units[k].node], std::move(results[k].hits));
    traced.unfinished += static_cast<double>(results[k].unfinished);
    traced.rays += static_cast<double>(units[k].last - units[k].first);
    emissions[units[k].node] = emission(input, units[k].node);
  }
  Symmetric symmetric = symmetrise(
      {std::move(counts), std::move(rays.sent), std::move(rays.thinning), std::move(emissions)});
  traced.factor = std::move(symmetric.factor);
  traced.emissivity = traced.traced_emissivity = input.emissivity;
  traced.relative_error = symmetric.relative_error;
  traced.self = std::move(symmetric.self);
  traced.row_sum_error = symmetric.row_sum_error;
  return traced;
}

void rescale(std::vector<double> emissivity, const std::vector<double>& emission,
             Exchange& exchange) {
  exchange.row_sum_error = balance(emission, exchange.factor, exchange.self);
  exchange.emissivity = std::move(emissivity);
}

std::vector<std::uint64_t> view_counts(const Tracer& tracer, std::uint32_t primitive,
                                       std::uint64_t rays, std::uint64_t seed,
                                       std::uint32_t nodes) {
  const QuasiPoints quasi(seed, primitive, 0);
  const std::uint64_t blocks = (rays + rays_per_unit - 1) / rays_per_unit;
  std::vector<CountRow> rows(blocks);
  parallel_for(
      blocks,
      [&](std::uint64_t b) {
        Tally landed(rays_per_unit);
        for (std::uint64_t r = b * rays_per_unit; r < std::min(rays, (b + 1) * rays_per_unit);
             ++r) {
          const Landing landing = tracer.land(emit(tracer.scene(), primitive, quasi.point(r)));
          landed.add(landing.is_empty() ? nodes - 1 : tracer.scene().node_of(landing.primitive));
        }
        rows[b] = landed.row();
      },
      1);
  std::vector<std::uint64_t> counts(nodes, 0);
  for (const CountRow& row : rows)
    for (const Count& c : row) counts[c.node] += c.rays;
  return counts;
}

std::vector<double> row_sums(const Csr& matrix) {
  std::vector<double> sums(matrix.rows(), 0.0);
  for (std::size_t row = 0; row < matrix.rows(); ++row)
    for (const double value : matrix.values(row)) sums[row] += value;
  return sums;
}

}  // namespace pmr::radiation
