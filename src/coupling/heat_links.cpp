#include "coupling/heat_links.hpp"

#include <algorithm>
#include <cmath>

#include "chemistry/gas.hpp"
#include "coupling/tessellate.hpp"
#include "coupling/thermal_state.hpp"
#include "physics/conduction.hpp"
#include "physics/gap.hpp"
#include "physics/motion.hpp"
#include "physics/neighbours.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// One side of a link.
struct Side {
  const Material* material;
  double radius;       // [m], physics::plane_wall for a wall
  double temperature;  // [K]
};

// What all links of one moment share.
struct Context {
  const Case& kase;
  const ConductionModel& model;
  Atmosphere gas;
};

double jump(const Context& context, const Side& side, double T) {
  return chemistry::jump_length(context.gas.oxygen_fraction, T, context.gas.pressure,
                                side.material->accommodation);
}

// Conductances of a pair whose surfaces are `gap` [m] apart (negative: the soft overlap).
HeatLink link(const Context& context, const Side& one, const Side& two, double gap) {
  const double k1 =
      physics::conductivity(one.material->conductivity, one.temperature, context.gas.pressure);
  const double k2 =
      physics::conductivity(two.material->conductivity, two.temperature, context.gas.pressure);
  const bool to_wall = two.radius == physics::plane_wall;
  const double radius =
      physics::contact_radius(physics::reduced_radius(one.radius, two.radius), -gap,
                              physics::contact_softening(*one.material, *two.material));
  HeatLink result{0, 0, 0.0, 0.0};
  if (context.model.contact) result.contact = physics::contact_conductance(k1, k2, radius);
  if (!context.model.gap || context.gas.pressure <= 0.0) return result;
  const double T = 0.5 * (one.temperature + two.temperature);  // [K] of the gas between
  const double soft = gap + one.radius + (to_wall ? 0.0 : two.radius);
  result.gap = physics::gap_conductance(
      {one.radius, two.radius, physics::true_distance(one.radius, two.radius, soft), radius,
       context.model.bed_solid_fraction},
      {k1, k2, chemistry::gas_conductivity(context.gas.oxygen_fraction, T),
       jump(context, one, T) + jump(context, two, T)});
  return result;
}

Side side_of(const Case& c, const Particles& p, std::size_t i) {
  return {&c.materials.list[c.species[p.species[i]].material], p.radius[i], p.temperature[i]};
}

void link_particles(const Context& context, const State& state, std::vector<HeatLink>& links) {
  const Particles& p = state.particles;
  const auto pairs = physics::pairs_within(p, context.model.gap ? context.model.gap_reach : 0.0);
  std::vector<HeatLink> found(pairs.size());
  parallel_for(pairs.size(), [&](std::size_t k) {
    const auto& pair = pairs[k];
    found[k] =
        link(context, side_of(context.kase, p, pair.i), side_of(context.kase, p, pair.j), pair.gap);
    found[k].a = std::min(p.id[pair.i], p.id[pair.j]);
    found[k].b = std::max(p.id[pair.i], p.id[pair.j]);
  });
  links.insert(links.end(), found.begin(), found.end());
}

// Where a particle comes near a wall.
struct Foot {
  std::size_t surface;
  Vec3 world, body;  // [m] nearest point of the surface, in the frames of the world and its body
  double distance;   // [m] from the particle's centre
};

std::vector<Foot> feet_of(const Case& c, const State& state, const Vec3& centre, double reach) {
  std::vector<Foot> feet;
  for (std::size_t s = 0; s < c.walls.surfaces.size(); ++s) {
    const Surface& surface = c.walls.surfaces[s];
    if (!surface.holds_particles || !is_present(surface, state.time)) continue;
    const physics::Pose pose = physics::pose(c.walls.bodies[surface.body].motion, state.time);
    const Vec3 x = pose.to_body(centre);
    if (physics::is_surely_beyond(surface.shape, x, reach)) continue;
    const Vec3 foot = physics::closest_point(surface.shape, x);
    const double distance = (x - foot).norm();
    if (distance < reach) feet.push_back({s, pose.to_world(foot), foot, distance});
  }
  std::stable_sort(feet.begin(), feet.end(),
                   [](const Foot& a, const Foot& b) { return a.distance < b.distance; });
  return feet;
}

// A foot that lies on a nearer foot's surface is an edge the two share: one link, not two.
bool is_shared_edge(const Case& c, const State& state, const std::vector<Foot>& nearer,
                    const Foot& foot, double radius) {
  return std::any_of(nearer.begin(), nearer.end(), [&](const Foot& other) {
    const Surface& surface = c.walls.surfaces[other.surface];
    const physics::Pose pose = physics::pose(c.walls.bodies[surface.body].motion, state.time);
    const Vec3 x = pose.to_body(foot.world);
    return (physics::closest_point(surface.shape, x) - x).norm() < 1e-6 * radius;
  });
}

// Links of one particle to the walls that are near.
void link_walls(const Context& context, const Nodes& nodes, const State& state,
                const std::vector<double>& faces, std::size_t i, std::vector<HeatLink>& found) {
  const Case& c = context.kase;
  const Particles& p = state.particles;
  const double reach = p.radius[i] * (1.0 + (context.model.gap ? context.model.gap_reach : 0.0));
  std::vector<Foot> accepted;
  for (const Foot& foot : feet_of(c, state, p.position[i], reach)) {
    if (is_shared_edge(c, state, accepted, foot, p.radius[i])) continue;
    accepted.push_back(foot);
    const Surface& surface = c.walls.surfaces[foot.surface];
    if (std::holds_alternative<Adiabatic>(surface.thermal)) continue;
    const std::size_t patch = nodes.first_patch[foot.surface] + patch_at(surface, foot.body);
    HeatLink result = link(context, side_of(c, p, i),
                           {&c.materials.list[surface.material], physics::plane_wall, faces[patch]},
                           foot.distance - p.radius[i]);
    result.a = p.id[i];
    result.b = nodes.patch(patch);
    found.push_back(result);
  }
}

void link_all_walls(const Context& context, const Nodes& nodes, const State& state,
                    std::vector<HeatLink>& links) {
  const auto faces = patch_temperatures(context.kase, nodes, state.walls);
  std::vector<std::vector<HeatLink>> found(state.particles.size());
  parallel_for(found.size(),
               [&](std::size_t i) { link_walls(context, nodes, state, faces, i, found[i]); });
  for (const auto& row : found) links.insert(links.end(), row.begin(), row.end());
}

constexpr double bed_part = 0.99;  // [1] of the particles lie below the bed's top

// Height that `bed_part` of the centres do not rise above [m]: a grain stuck higher is no bed.
double top_of_bed(const Particles& p) {
  std::vector<double> heights;
  for (const Vec3& x : p.position) heights.push_back(x.z());
  const auto rank = static_cast<std::ptrdiff_t>(bed_part * static_cast<double>(p.size() - 1));
  std::nth_element(heights.begin(), heights.begin() + rank, heights.end());
  return heights[static_cast<std::size_t>(rank)];
}

// A film of gas over the bed's top: the particles whose centres lie within one largest diameter of
// it or above, each with its cross-section; and over the walls of the closed chamber.
void link_gas(const Case& c, const Nodes& nodes, const State& state, std::vector<HeatLink>& links) {
  const Particles& p = state.particles;
  if (!c.chamber || state.phase != Phase::react || p.size() == 0) return;
  const double film = c.chamber->film_coefficient;
  if (film <= 0.0) return;
  const double largest = 2.0 * *std::max_element(p.radius.begin(), p.radius.end());
  const double top = top_of_bed(p);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.position[i].z() > top - largest)
      links.push_back({p.id[i], nodes.gas(), 0.0, film * pi * p.radius[i] * p.radius[i]});
  if (!state.gas.closed) return;
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
    const Surface& surface = c.walls.surfaces[nodes.patches[k].surface];
    if (is_present(surface, state.time) && !std::holds_alternative<Adiabatic>(surface.thermal))
      links.push_back({nodes.patch(k), nodes.gas(), 0.0, film * nodes.patches[k].area});
  }
}

}  // namespace

std::vector<HeatLink> conduct(const Case& c, const Nodes& nodes, const State& state) {
  std::vector<HeatLink> links;
  if (c.models.conduction) {
    const Context context{c, *c.models.conduction, atmosphere(c, state)};
    link_particles(context, state, links);
    link_all_walls(context, nodes, state, links);
  }
  link_gas(c, nodes, state, links);
  std::sort(links.begin(), links.end(), [](const HeatLink& a, const HeatLink& b) {
    return a.a != b.a ? a.a < b.a : a.b < b.b;
  });
  return links;
}

}  // namespace pmr::coupling
