#include "physics/wall_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "physics/adhered.hpp"
#include "physics/motion.hpp"
#include "physics/neighbours.hpp"
#include "physics/shapes.hpp"
#include "physics/wall_tree.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

struct Depth {
  double ratio = 0.0;  // [1] of the radius
  std::uint32_t body = 0;
};

Vec3 nearest_point(const Surface& surface, const WallPart& part, const Vec3& x) {
  if (part.triangle == WallPart::whole) return closest_point(surface.shape, x);
  return closest_point(std::get<Facet>(surface.shape), std::span(&part.triangle, 1), x);
}

// By body, of what is deeper than the limit.
WallOverlaps by_body(const std::vector<Depth>& depths, const Walls& walls, double limit) {
  WallOverlaps found;
  std::vector<DeepInWall> bodies;
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b) bodies.push_back({b, 0, 0, 0.0});
  for (std::size_t i = 0; i < depths.size(); ++i) {
    found.largest = std::max(found.largest, depths[i].ratio);
    if (depths[i].ratio <= limit) continue;
    DeepInWall& deep = bodies[depths[i].body];
    ++deep.count;
    if (depths[i].ratio > deep.overlap) deep = {deep.body, deep.count, i, depths[i].ratio};
  }
  for (const DeepInWall& deep : bodies)
    if (deep.count > 0) found.excessive.push_back(deep);
  return found;
}

}  // namespace

WallOverlaps wall_overlaps(const Particles& p, const Walls& walls, double time, double limit,
                           const std::function<bool(const Surface&)>& counts) {
  std::vector<Pose> poses;
  for (const Body& body : walls.bodies) poses.push_back(pose(body.motion, time));
  const WallTree tree(walls);
  std::vector<Depth> depths(p.size());
  parallel_for(p.size(), [&](std::size_t i) {
    for (const WallPart& part : tree.near(p.position[i], p.radius[i], poses)) {
      const Surface& surface = walls.surfaces[part.surface];
      if (!counts(surface)) continue;
      const Vec3 x = poses[surface.body].to_body(p.position[i]);
      const double ratio = 1.0 - (nearest_point(surface, part, x) - x).norm() / p.radius[i];
      if (ratio > depths[i].ratio) depths[i] = {ratio, surface.body};
    }
  });
  return by_body(depths, walls, limit);
}

WallOverlaps grain_overlaps(const Particles& p, const Walls& walls, double time, double limit) {
  if (walls.grains.empty() || p.size() == 0) return {};
  Particles all;
  const std::vector<Vec3> places = adhered_places(walls, time);
  resize(all, p.size() + places.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_free = i < p.size();
    all.id[i] = static_cast<ParticleId>(i);
    all.position[i] = is_free ? p.position[i] : places[i - p.size()];
    all.radius[i] = is_free ? p.radius[i] : walls.grains[i - p.size()].radius;
    all.mass[i] = 1.0;
  }
  std::vector<Depth> depths(p.size());
  for (const NeighbourPair& pair : pairs_within(all, 0.0)) {
    if (pair.i >= p.size() || pair.j < p.size()) continue;
    const double ratio = -pair.gap / std::min(all.radius[pair.i], all.radius[pair.j]);
    if (ratio > depths[pair.i].ratio)
      depths[pair.i] = {ratio, walls.grains[pair.j - p.size()].body};
  }
  return by_body(depths, walls, limit);
}

std::string to_text(const DeepInWall& deep, const Particles& p, const Walls& walls, double limit) {
  return fmt::format(
      "{} particles overlap wall '{}' by more than {:.3g} % of their radius; the deepest, {}, by "
      "{:.1f} %",
      deep.count, walls.bodies[deep.body].name, 100.0 * limit, place_of(p, deep.deepest),
      100.0 * deep.overlap);
}

std::string place_of(const Particles& p, std::size_t i) {
  return fmt::format("particle {} of radius {:.4g} mm at ({:.6g}, {:.6g}, {:.6g}) mm", p.id[i],
                     1e3 * p.radius[i], 1e3 * p.position[i][0], 1e3 * p.position[i][1],
                     1e3 * p.position[i][2]);
}

}  // namespace pmr::physics
