#include "coupling/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "physics/motion.hpp"
#include "physics/neighbours.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

void find_between_particles(const Nodes& nodes, const Particles& p, double reach,
                            std::vector<Gap>& gaps) {
  for (const auto& pair : physics::pairs_within(p, reach)) {
    const Node i = nodes.particle(p.id[pair.i]), j = nodes.particle(p.id[pair.j]);
    gaps.push_back(i < j ? Gap{i, j, pair.i, pair.j, pair.gap}
                         : Gap{j, i, pair.j, pair.i, pair.gap});
  }
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

void find_at_walls(const Case& c, const Nodes& nodes, const State& state, double reach,
                   std::size_t i, std::vector<Gap>& found) {
  const Particles& p = state.particles;
  std::vector<Foot> accepted;
  for (const Foot& foot : feet_of(c, state, p.position[i], p.radius[i] * (1.0 + reach))) {
    if (is_shared_edge(c, state, accepted, foot, p.radius[i])) continue;
    accepted.push_back(foot);
    const Surface& surface = c.walls.surfaces[foot.surface];
    if (std::holds_alternative<Adiabatic>(surface.thermal)) continue;
    const std::uint32_t patch = nodes.first_patch[foot.surface] + patch_at(surface, foot.body);
    found.push_back({nodes.particle(p.id[i]), nodes.patch(patch), static_cast<std::uint32_t>(i),
                     patch, foot.distance - p.radius[i]});
  }
}

}  // namespace

Gaps find_gaps(const Case& c, const Nodes& nodes, const State& state) {
  Gaps gaps;
  gaps.found_at = state.time;
  if (!c.models.conduction) return gaps;
  const double reach = c.models.conduction->gap ? c.models.conduction->gap_reach : 0.0;
  find_between_particles(nodes, state.particles, reach, gaps.all);
  std::vector<std::vector<Gap>> found(state.particles.size());
  parallel_for(found.size(),
               [&](std::size_t i) { find_at_walls(c, nodes, state, reach, i, found[i]); });
  for (const auto& row : found) gaps.all.insert(gaps.all.end(), row.begin(), row.end());
  std::sort(gaps.all.begin(), gaps.all.end(),
            [](const Gap& p, const Gap& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  return gaps;
}

bool walls_stand(const Case& c, const Gaps& gaps, double now) {
  if (!std::isfinite(gaps.found_at)) return false;
  const physics::Box everywhere{c.domain_low, c.domain_high};
  return std::all_of(c.walls.surfaces.begin(), c.walls.surfaces.end(), [&](const Surface& surface) {
    const bool was_there = is_present(surface, gaps.found_at);
    if (was_there != is_present(surface, now)) return false;
    return !was_there || physics::displacement_bound(c.walls.bodies[surface.body].motion,
                                                     gaps.found_at, now, everywhere) == 0.0;
  });
}

}  // namespace pmr::coupling
