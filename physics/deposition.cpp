#include "physics/deposition.hpp"

#include <algorithm>
#include <optional>

namespace pmr::physics {
namespace {

constexpr int places_tried = 32;    // [1] of one sphere, the lowest is taken
constexpr int most_draws = 4000;    // [1] for these, where most fall beside the region
constexpr double distance = 1.001;  // [1] of touching spheres' centres over the sum of radii

struct Resting {
  Vec3 position;  // [m]
  double radius;  // [m]
  double top() const { return position[2] + distance * radius; }
};

// Columns as wide as the largest sphere, each with the spheres centred in it, the highest last.
class Heap {
 public:
  Heap(const Ground& ground, double largest)
      : low_(ground.centre.head<2>().array() - ground.reach),
        side_(2.0 * distance * largest),
        cells_(static_cast<std::size_t>(2.0 * ground.reach / side_) + 1),
        floor_(ground.centre[2]),
        columns_(cells_ * cells_) {}

  // Height [m] at which a sphere let down at (x, y) comes to rest.
  double height_at(const Eigen::Vector2d& at, double radius) const {
    double z = floor_ + radius;
    const std::size_t i = place(at[0], 0), j = place(at[1], 1);
    for (std::size_t k = i > 0 ? i - 1 : 0; k <= std::min(i + 1, cells_ - 1); ++k)
      for (std::size_t l = j > 0 ? j - 1 : 0; l <= std::min(j + 1, cells_ - 1); ++l)
        z = raised(columns_[k * cells_ + l], at, radius, z);
    return z;
  }

  void add(const Vec3& position, double radius) {
    auto& column = columns_[place(position[0], 0) * cells_ + place(position[1], 1)];
    const Resting sphere{position, radius};
    const auto above = [](const Resting& a, const Resting& b) { return a.top() < b.top(); };
    column.insert(std::upper_bound(column.begin(), column.end(), sphere, above), sphere);
  }

 private:
  static double raised(const std::vector<Resting>& column, const Eigen::Vector2d& at, double radius,
                       double z) {
    for (auto other = column.rbegin(); other != column.rend(); ++other) {
      if (other->top() + distance * radius <= z) break;  // nor do those below
      const double reach = distance * (radius + other->radius);
      const double aside = (other->position.head<2>() - at).squaredNorm();
      if (aside < reach * reach)
        z = std::max(z, other->position[2] + std::sqrt(reach * reach - aside));
    }
    return z;
  }

  std::size_t place(double x, int axis) const {
    const double cell = (x - low_[axis]) / side_;
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells_ - 1)));
  }

  Eigen::Vector2d low_;  // [m] lower corner
  double side_;          // [m] of a column
  std::size_t cells_;    // [1] along each axis
  double floor_;         // [m]
  std::vector<std::vector<Resting>> columns_;
};

// The lowest of a few places; none when the region has no room for the radius.
std::optional<Vec3> lowest_place(const Ground& ground, const Heap& heap, double radius,
                                 Random random) {
  std::optional<Vec3> best;
  for (int draw = 0, tried = 0; draw < most_draws && tried < places_tried; ++draw) {
    const double u = 2.0 * random.uniform() - 1.0, v = 2.0 * random.uniform() - 1.0;
    Vec3 x = ground.centre + ground.reach * Vec3(u, v, 0.0);
    if (!ground.holds(x, radius)) continue;
    ++tried;
    x[2] = heap.height_at(x.head<2>(), radius);
    if (!best || x[2] < (*best)[2]) best = x;
  }
  return best;
}

}  // namespace

std::vector<Vec3> deposit(const Ground& ground, std::span<const double> radii, std::uint64_t seed,
                          std::uint64_t key) {
  std::vector<Vec3> places;
  if (radii.empty()) return places;
  Heap heap(ground, *std::max_element(radii.begin(), radii.end()));
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const auto place =
        lowest_place(ground, heap, radii[k], Random(seed, Purpose::insertion, key, k));
    if (!place) return places;
    heap.add(*place, radii[k]);
    places.push_back(*place);
  }
  return places;
}

}  // namespace pmr::physics
