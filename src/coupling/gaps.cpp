#include "coupling/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "physics/gap.hpp"
#include "physics/motion.hpp"
#include "physics/neighbours.hpp"
#include "physics/wall_feet.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

void find_between_particles(const Nodes& nodes, const Particles& p, double reach,
                            std::vector<Gap>& gaps) {
  for (const auto& pair : physics::pairs_within(p, reach)) {
    const Node i = nodes.particle(p.id[pair.i]), j = nodes.particle(p.id[pair.j]);
    gaps.push_back(i < j ? Gap{i, j, pair.i, pair.j, pair.gap, 1.0}
                         : Gap{j, i, pair.j, pair.i, pair.gap, 1.0});
  }
}

struct WallGap {
  Gap gap;
  Vec3 towards;   // [1] from the particle to the wall
  double lens;    // [m] radius of the lens of gas between them
  bool is_close;  // as near as neighbours are, so that nothing fits between
  bool is_hidden = false;
};

void find_at_walls(const Case& c, const Nodes& nodes, const State& state,
                   const physics::WallFeet& walls, std::size_t i, std::vector<WallGap>& found) {
  const Particles& p = state.particles;
  const ConductionModel& model = *c.models.conduction;
  const double radius = p.radius[i], close = model.gap ? model.gap_reach : 0.0;
  const double reach = model.gap ? physics::wall_fade_end : 0.0;
  for (const auto& foot : walls.near(p.position[i], radius, radius * (1.0 + reach))) {
    const Surface& surface = c.walls.surfaces[foot.surface];
    if (std::holds_alternative<Adiabatic>(surface.thermal)) continue;
    const std::uint32_t patch =
        nodes.first_patch[foot.surface] + patch_at(surface, walls.in_body(foot));
    const double width = foot.distance - radius;
    found.push_back({{nodes.particle(p.id[i]), nodes.patch(patch), static_cast<std::uint32_t>(i),
                      patch, width, foot.share},
                     foot.towards,
                     physics::wall_lens_radius(radius, foot.distance, model.bed_solid_fraction),
                     width <= close * radius});
  }
}

// A wall farther off than neighbours are is hidden from a particle by any neighbour that reaches
// into the lens of gas between them.
void hide_walls(const Particles& p, std::uint32_t i, std::uint32_t neighbour,
                std::vector<WallGap>& at_walls) {
  const Vec3 way = p.position[neighbour] - p.position[i];
  for (WallGap& wall : at_walls) {
    const double along = way.dot(wall.towards);
    const bool is_between = along > 0.0 && along < wall.gap.width + p.radius[i];
    const double aside = (way - along * wall.towards).norm();
    if (!wall.is_close && is_between && aside < wall.lens + p.radius[neighbour])
      wall.is_hidden = true;
  }
}

}  // namespace

Gaps find_gaps(const Case& c, const Nodes& nodes, const State& state) {
  Gaps gaps;
  gaps.found_at = state.time;
  if (!c.models.conduction) return gaps;
  const Particles& p = state.particles;
  const double reach =
      c.models.conduction->gap ? physics::pair_fade_end * c.models.conduction->gap_reach : 0.0;
  find_between_particles(nodes, p, reach, gaps.all);
  const physics::WallFeet walls(c.walls, state.time);
  std::vector<std::vector<WallGap>> found(p.size());
  parallel_for(found.size(),
               [&](std::size_t i) { find_at_walls(c, nodes, state, walls, i, found[i]); });
  for (const Gap& pair : gaps.all) {
    if (!found[pair.particle].empty())
      hide_walls(p, pair.particle, pair.other, found[pair.particle]);
    if (!found[pair.other].empty()) hide_walls(p, pair.other, pair.particle, found[pair.other]);
  }
  for (const auto& row : found)
    for (const WallGap& wall : row)
      if (!wall.is_hidden) gaps.all.push_back(wall.gap);
  std::sort(gaps.all.begin(), gaps.all.end(),
            [](const Gap& a, const Gap& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; });
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
