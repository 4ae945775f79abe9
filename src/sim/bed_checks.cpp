#include "sim/bed_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "physics/neighbours.hpp"
#include "physics/wall_overlaps.hpp"

namespace pmr::sim {
namespace {

// [1] of the radius. At the foot of the full charge grains of 5 MPa rest with up to 0.2 (LIGGGHTS
// and pmr alike); a diameter taken for a radius gives 1.
constexpr double largest_overlap_of_bed = 0.5;

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
                                  outside, p.size(), physics::place_of(p, first))});
}

void find_pairs(const Case& c, Bed& bed, std::vector<Fault>& faults) {
  const Particles& p = bed.particles;
  if (p.size() < 2) return;
  std::size_t excessive = 0;
  physics::NeighbourPair worst{0, 0, 0.0};
  double largest = 0.0;
  for (const auto& pair : physics::pairs_within(p, 0.0)) {
    const double ratio = -pair.gap / std::min(p.radius[pair.i], p.radius[pair.j]);
    excessive += ratio > largest_overlap_of_bed ? 1 : 0;
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
             excessive, 100.0 * largest, physics::place_of(p, worst.i),
             physics::place_of(p, worst.j))});
}

void find_in_walls(const Case& c, Bed& bed, std::vector<Fault>& faults) {
  const auto is_there = [&](const Surface& surface) { return is_present(surface, bed.time); };
  const auto found =
      physics::wall_overlaps(bed.particles, c.walls, bed.time, largest_overlap_of_bed, is_there);
  bed.overlap_ratio = std::max(bed.overlap_ratio, found.largest);
  for (const auto& deep : found.excessive)
    faults.push_back({c.bed, "", to_text(deep, bed.particles, c.walls, largest_overlap_of_bed)});
  const auto grains =
      physics::grain_overlaps(bed.particles, c.walls, bed.time, largest_overlap_of_bed);
  bed.overlap_ratio = std::max(bed.overlap_ratio, grains.largest);
  for (const auto& deep : grains.excessive)
    faults.push_back(
        {c.bed, "",
         "by its grains, " + to_text(deep, bed.particles, c.walls, largest_overlap_of_bed)});
}

}  // namespace

std::vector<Fault> bed_faults(const Case& c, Bed& bed) {
  std::vector<Fault> faults;
  bed.overlap_ratio = 0.0;
  find_outside(c, bed.particles, faults);
  if (!faults.empty()) return faults;  // in another place or unit: overlaps say nothing
  find_pairs(c, bed, faults);
  find_in_walls(c, bed, faults);
  return faults;
}

}  // namespace pmr::sim
