#include "instruments/bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "physics/adhered.hpp"
#include "physics/porous_bed.hpp"
#include "physics/upright.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::instruments {
namespace {

constexpr double height_share = 0.99;  // [1] of the mass

// Smallest value at or below which `share` of the weight lies; `order` sorts the values.
double quantile(const std::vector<double>& values, const std::vector<double>& weights,
                const std::vector<std::size_t>& order, double share) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0.0;
  for (const std::size_t i : order) {
    sum += weights[i];
    if (sum >= share * total) return values[i];
  }
  return values[order.back()];
}

std::vector<std::size_t> ascending(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

// Volume of a sphere below the plane at height h above its centre [m3]:
// pi (2 r^3/3 + r^2 h - h^3/3), |h| <= r.
double volume_below(double radius, double height) {
  const double h = std::clamp(height, -radius, radius);
  return pi * (2.0 / 3.0 * radius * radius * radius + radius * radius * h - h * h * h / 3.0);
}

double distance_from_axis(const Vec3& position, const Vec3& axis_point) {
  return std::hypot(position.x() - axis_point.x(), position.y() - axis_point.y());
}

// Spheres that reach into a range of heights.
Particles within(const Particles& all, double low, double high) {
  Particles bed;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double z = all.position[i].z(), r = all.radius[i];
    if (z + r <= low || z - r >= high) continue;
    bed.position.push_back(all.position[i]);
    bed.radius.push_back(all.radius[i]);
    bed.id.push_back(all.id[i]);
  }
  return bed;
}

// True when each cell of `size` [m] that lies wholly inside the hull and the slab holds a centre.
bool fills(const Particles& bed, const physics::Footprint& hull, const Slab& slab, double size) {
  Eigen::AlignedBox2d box;
  for (const auto& corner : hull) box.extend(corner);
  const auto cells = [&](double length) {
    return std::max(1, static_cast<int>(std::floor(length / size)));
  };
  const Eigen::Vector2d extent = box.sizes();
  const std::array<int, 3> count{cells(extent.x()), cells(extent.y()), cells(slab.high - slab.low)};
  const Vec3 low(box.min().x(), box.min().y(), slab.low);
  const Vec3 step(extent.x() / count[0], extent.y() / count[1], (slab.high - slab.low) / count[2]);
  const auto place = [&](int x, int y, int z) {
    const Eigen::Index row = Eigen::Index{z} * count[1] + y;
    return static_cast<std::size_t>(row * count[0] + x);
  };
  std::vector<char> is_met(place(0, 0, count[2]), 0);
  for (const Vec3& x : bed.position) {
    std::array<int, 3> at{};
    bool is_in = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      at[k] = static_cast<int>(std::floor((x[axis] - low[axis]) / step[axis]));
      is_in = is_in && at[k] >= 0 && at[k] < count[k];
    }
    if (is_in) is_met[place(at[0], at[1], at[2])] = 1;
  }
  for (int y = 0; y < count[1]; ++y)
    for (int x = 0; x < count[0]; ++x) {
      bool is_inner = true;
      for (const int dx : {0, 1})
        for (const int dy : {0, 1})
          is_inner = is_inner && physics::is_inside(hull, {low.x() + (x + dx) * step.x(),
                                                           low.y() + (y + dy) * step.y()});
      for (int z = 0; is_inner && z < count[2]; ++z)
        if (is_met[place(x, y, z)] == 0) return false;
    }
  return true;
}

}  // namespace

Particles upright(const Particles& bed, const Vec3& up) {
  Particles turned = bed;
  turned.position = physics::upright(bed.position, up);
  return turned;
}

double lowest_point(const Particles& bed) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bed.size(); ++i)
    lowest = std::min(lowest, bed.position[i].z() - bed.radius[i]);
  return lowest;
}

double bed_height(const Particles& bed, const Vec3& floor) {
  if (bed.size() == 0) return 0.0;
  std::vector<double> tops(bed.size());
  for (std::size_t i = 0; i < bed.size(); ++i)
    tops[i] = bed.position[i].z() + bed.radius[i] - floor.z();
  return quantile(tops, bed.mass, ascending(tops), height_share);
}

double solid_fraction(const Particles& bed, const Slab& slab) {
  const double volume = slab.area * (slab.high - slab.low);
  if (!(volume > 0.0)) return nan;
  double solid = 0.0;
  for (std::size_t i = 0; i < bed.size(); ++i) {
    const double z = bed.position[i].z(), radius = bed.radius[i];
    solid += volume_below(radius, slab.high - z) - volume_below(radius, slab.low - z);
  }
  return solid / volume;
}

double solid_fraction(const Particles& bed, double floor) {
  if (bed.size() == 0) return nan;
  const double diameter = 2.0 * *std::max_element(bed.radius.begin(), bed.radius.end());
  const double height = bed_height(bed, Vec3(0.0, 0.0, floor));
  Slab slab{floor + diameter, floor + std::min(0.9 * height, height - diameter), 0.0};
  if (!(slab.high > slab.low)) return nan;
  const Particles inside = within(bed, slab.low, slab.high);
  const physics::Footprint hull = physics::footprint(inside.position, inside.radius);
  if (!fills(inside, hull, slab, 2.0 * diameter)) return nan;
  slab.area = physics::area(hull);
  return solid_fraction(inside, slab);
}

Vessel enclosing_vessel(const Particles& bed, const Vec3& floor) {
  double reach = 0.0;
  for (std::size_t i = 0; i < bed.size(); ++i)
    reach = std::max(reach, distance_from_axis(bed.position[i], floor) + bed.radius[i]);
  return {floor, reach};
}

double coordination_number(const State& state) {
  if (state.particles.size() == 0) return 0.0;
  const auto& partner = state.pair_contacts.partner;  // adhered grains are no particles
  const auto adhered = std::count_if(partner.begin(), partner.end(), [](std::uint32_t id) {
    return id >= physics::first_adhered_id;
  });
  return static_cast<double>(2 * partner.size() - static_cast<std::size_t>(adhered)) /
         static_cast<double>(state.particles.size());
}

Spread weighted_spread(const std::vector<double>& values, const std::vector<double>& weights) {
  ensure(values.size() == weights.size(), "each value has a weight");
  if (values.empty()) return {nan, nan, nan, nan};
  double total = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    total += weights[i];
    sum += weights[i] * (values[i] - values.front());  // shifted: equal values spread exactly 0
  }
  const double mean = values.front() + sum / total;
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += weights[i] * (values[i] - mean) * (values[i] - mean);
  const std::vector<std::size_t> order = ascending(values);
  return {mean, std::sqrt(squares / total), quantile(values, weights, order, 0.1),
          quantile(values, weights, order, 0.9)};
}

SpeciesFigures species_figures(const Particles& particles, SpeciesIndex species) {
  std::vector<bool> chosen(species + std::size_t{1}, false);
  chosen[species] = true;
  return species_figures(particles, chosen);
}

SpeciesFigures species_figures(const Particles& particles, const std::vector<bool>& chosen) {
  std::vector<double> mass, temperature, delta;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.species[i] >= chosen.size() || !chosen[particles.species[i]]) continue;
    mass.push_back(particles.mass[i]);
    temperature.push_back(particles.temperature[i]);
    delta.push_back(particles.delta[i]);
  }
  return {mass.size(), std::accumulate(mass.begin(), mass.end(), 0.0),
          weighted_spread(temperature, mass), weighted_spread(delta, mass)};
}

}  // namespace pmr::instruments
