#include "sim/bed_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "physics/motion.hpp"
#include "physics/neighbours.hpp"
#include "physics/shapes.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::sim {
namespace {

// [1] of the radius. At the foot of the full charge grains of 5 MPa rest with up to 0.2 (LIGGGHTS and
// pmr alike); a diameter taken for a radius gives 1.
constexpr double largest_overlap = 0.5;

std::string place_of(const Particles& p, std::size_t i) {
  return fmt::format("particle {} of radius {:.4g} mm at ({:.6g}, {:.6g}, {:.6g}) mm", p.id[i],
                     1e3 * p.radius[i], 1e3 * p.position[i][0], 1e3 * p.position[i][1],
                     1e3 * p.position[i][2]);
}

void find_outside(const Case& c, const Particles& p, std::vector<Fault>& faults) {
  std::size_t outside = 0, first = 0;
  for (std::size_t i = p.size(); i-- > 0;) {
    const auto x = p.position[i].array();
    if ((x >= c.domain_low.array()).all() && (x <= c.domain_high.array()).all()) continue;
    ++outside;
    first = i;
  }
  if (outside > 0)
    faults.push_back({c.bed, "",
                      fmt::format("{} of {} particles lie outside the domain; the first, {}",
                                  outside, p.size(), place_of(p, first))});
}

void find_pairs(const Case& c, Bed& bed, std::vector<Fault>& faults) {
  const Particles& p = bed.particles;
  if (p.size() < 2) return;
  std::size_t excessive = 0;
  physics::NeighbourPair worst{0, 0, 0.0};
  double largest = 0.0;
  for (const auto& pair : physics::pairs_within(p, 0.0)) {
    const double ratio = -pair.gap / std::min(p.radius[pair.i], p.radius[pair.j]);
    excessive += ratio > largest_overlap ? 1 : 0;
    if (ratio <= largest) continue;
    largest = ratio;
    worst = pair;
  }
  bed.overlap_ratio = std::max(bed.overlap_ratio, largest);
  if (excessive > 0)
    faults.push_back(
        {c.bed, "",
         fmt::format(
             "{} pairs overlap by more than 50 % of the smaller radius; the largest, {:.1f} %, "
             "is of {} with {}",
             excessive, 100.0 * largest, place_of(p, worst.i), place_of(p, worst.j))});
}

// Overlaps [m] of all particles with one surface, and what is too much of it.
void find_in_wall(const Case& c, const Surface& surface, Bed& bed, std::vector<Fault>& faults) {
  const Particles& p = bed.particles;
  const physics::Pose pose = physics::pose(c.walls.bodies[surface.body].motion, bed.time);
  const auto ratio = [&](std::size_t i) {
    const Vec3 x = pose.to_body(p.position[i]);
    if (physics::is_surely_beyond(surface.shape, x, p.radius[i])) return 0.0;
    return 1.0 - (physics::closest_point(surface.shape, x) - x).norm() / p.radius[i];
  };
  const double largest = parallel_max(p.size(), 0.0, ratio);
  bed.overlap_ratio = std::max(bed.overlap_ratio, largest);
  if (largest <= largest_overlap) return;
  std::size_t excessive = 0, worst = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double overlap = ratio(i);
    excessive += overlap > largest_overlap ? 1 : 0;
    if (overlap == largest) worst = i;
  }
  faults.push_back(
      {c.bed, "",
       fmt::format("{} particles overlap wall '{}' by more than 50 % of their radius; the largest "
                   "overlap, {:.1f} %, is of {}",
                   excessive, surface.name, 100.0 * largest, place_of(p, worst))});
}

}  // namespace

std::vector<Fault> bed_faults(const Case& c, Bed& bed) {
  std::vector<Fault> faults;
  bed.overlap_ratio = 0.0;
  find_outside(c, bed.particles, faults);
  if (!faults.empty()) return faults;  // in another place or unit: overlaps say nothing
  find_pairs(c, bed, faults);
  for (const Surface& surface : c.walls.surfaces)
    if (surface.holds_particles && is_present(surface, bed.time))
      find_in_wall(c, surface, bed, faults);
  return faults;
}

}  // namespace pmr::sim
