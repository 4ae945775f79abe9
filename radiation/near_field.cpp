#include "radiation/near_field.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pmr/base/parallel.hpp"
#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

constexpr double reach_in_units = 1.0;  // [1] of the scene's unit: of the mean diameter
constexpr float nowhere = 1e15F;        // [1] units: where unused lanes stand

}  // namespace

NearField::NearField(const Scene& scene, const SphereGrid& grid)
    : scene_(&scene), reach_(reach_in_units * scene.unit()) {
  const std::size_t n = scene.spheres().size();
  std::vector<std::vector<Packet>> packets(n);
  std::vector<std::vector<std::uint32_t>> walls(n);
  parallel_for(n, [&](std::size_t i) {
    const Sphere& s = scene.spheres()[i];
    packets[i] = packets_around(static_cast<std::uint32_t>(i), grid);
    scene.find_triangles(s.centre, s.radius + reach_, walls[i]);
    std::sort(walls[i].begin(), walls[i].end());
  });
  first_packet_.assign(1, 0);
  first_wall_.assign(1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    first_packet_.push_back(first_packet_.back() + packets[i].size());
    first_wall_.push_back(first_wall_.back() + walls[i].size());
  }
  packet_.resize(first_packet_.back());
  wall_.resize(first_wall_.back());
  parallel_for(n, [&](std::size_t i) {
    std::copy(packets[i].begin(), packets[i].end(), &packet_[first_packet_[i]]);
    std::copy(walls[i].begin(), walls[i].end(), &wall_[first_wall_[i]]);
  });
}

std::vector<NearField::Packet> NearField::packets_around(std::uint32_t sphere,
                                                         const SphereGrid& grid) const {
  const std::vector<Sphere>& all = scene_->spheres();
  const Sphere& own = all[sphere];
  std::vector<std::uint32_t> found;
  grid.find(all, own.centre, own.radius + reach_, found);
  std::erase(found, sphere);
  std::vector<std::pair<float, std::uint32_t>> by_gap;  // [units]
  by_gap.reserve(found.size());
  for (const std::uint32_t j : found)
    by_gap.emplace_back(
        static_cast<float>(((all[j].centre - own.centre).norm() - own.radius - all[j].radius) /
                           scene_->unit()),
        j);
  std::sort(by_gap.begin(), by_gap.end());
  std::vector<Packet> packets((by_gap.size() + lanes - 1) / lanes);
  for (std::size_t k = 0; k < lanes * packets.size(); ++k) {
    Packet& p = packets[k / lanes];
    const std::size_t l = k % lanes;
    const bool is_used = k < by_gap.size();
    const Sphere& s = all[is_used ? by_gap[k].second : sphere];
    const Vec3 at = (s.centre - own.centre) / scene_->unit();
    p.x[l] = is_used ? static_cast<float>(at.x()) : nowhere;
    p.y[l] = static_cast<float>(at.y());
    p.z[l] = static_cast<float>(at.z());
    p.radius[l] = static_cast<float>(s.radius / scene_->unit());
    p.sphere[l] = is_used ? by_gap[k].second : sphere;
    if (l == 0) p.gap = by_gap[k].first;
  }
  return packets;
}

std::optional<NearField::Meeting> NearField::first(std::uint32_t sphere, const Vec3& start,
                                                   const Vec3& direction) const {
  const Vec3& centre = scene_->spheres()[sphere].centre;
  if (const auto cut = wall_within(sphere, centre, start)) return Meeting{cut->primitive, 0.0};
  const Vec3 from = (start - centre) / scene_->unit();
  const auto all = [](double a) { return _mm256_set1_ps(static_cast<float>(a)); };
  const __m256 ox = all(from.x()), oy = all(from.y()), oz = all(from.z());
  const __m256 dx = all(direction.x()), dy = all(direction.y()), dz = all(direction.z());
  const __m256 zero = _mm256_setzero_ps();
  // distance, or minus the depth of a start within a sphere
  float nearest = static_cast<float>(reach_in_units);
  std::uint32_t met = none;
  for (const Packet& p : packets(sphere)) {
    if (p.gap >= nearest) break;
    const __m256 x = _mm256_load_ps(p.x) - ox, y = _mm256_load_ps(p.y) - oy,
                 z = _mm256_load_ps(p.z) - oz, r = _mm256_load_ps(p.radius);
    const __m256 along = x * dx + y * dy + z * dz;
    const __m256 squared = x * x + y * y + z * z;
    const __m256 outside = squared - r * r;  // positive if the start lies outside
    const __m256 inner = along * along - outside;
    const __m256 is_in = _mm256_cmp_ps(outside, zero, _CMP_LT_OQ);
    const __m256 is_ahead = _mm256_and_ps(_mm256_cmp_ps(inner, zero, _CMP_GE_OQ),
                                          _mm256_cmp_ps(along, zero, _CMP_GT_OQ));
    if (_mm256_movemask_ps(_mm256_or_ps(is_in, is_ahead)) == 0) continue;
    const __m256 ahead = along - _mm256_sqrt_ps(_mm256_max_ps(inner, zero));
    const __m256 distance = _mm256_blendv_ps(ahead, _mm256_sqrt_ps(squared) - r, is_in);
    const __m256 is_nearer = _mm256_and_ps(_mm256_or_ps(is_in, is_ahead),
                                           _mm256_cmp_ps(distance, all(nearest), _CMP_LT_OQ));
    alignas(32) float of_lane[lanes];
    _mm256_store_ps(of_lane, distance);
    for (auto left = static_cast<unsigned>(_mm256_movemask_ps(is_nearer)); left != 0;
         left &= left - 1) {
      const auto l = static_cast<std::size_t>(__builtin_ctz(left));
      if (of_lane[l] >= nearest) continue;
      nearest = of_lane[l];
      met = p.sphere[l];
    }
  }
  const double distance = std::max(0.0, static_cast<double>(nearest)) * scene_->unit();
  if (distance > 0.0)
    if (const auto wall = wall_within(sphere, start, start + distance * direction))
      return Meeting{wall->primitive, wall->distance};
  if (met == none) return std::nullopt;
  return Meeting{met, distance};
}

// The triangle of the list that is crossed first on the way.
std::optional<NearField::Meeting> NearField::wall_within(std::uint32_t sphere, const Vec3& from,
                                                         const Vec3& to) const {
  std::optional<Meeting> first;
  double nearest = std::numeric_limits<double>::infinity();  // [1] of the way
  for (const std::uint32_t w : walls(sphere)) {
    const auto fraction = crossing(scene_->triangle(w), from, to);
    if (!fraction || *fraction >= nearest) continue;
    nearest = *fraction;
    first = {w, nearest * (to - from).norm()};
  }
  return first;
}

}  // namespace pmr::radiation
