#include "instruments/bed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::instruments {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
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

Particles within(const Particles& all, const Vessel& vessel) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (distance_from_axis(all.position[i], vessel.floor) <= vessel.radius) inside.push_back(i);
  Particles bed;
  for (const std::size_t i : inside) {
    bed.id.push_back(all.id[i]);
    bed.radius.push_back(all.radius[i]);
    bed.mass.push_back(all.mass[i]);
    bed.position.push_back(all.position[i]);
  }
  return bed;
}

}  // namespace

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

double solid_fraction(const Particles& bed, const Vessel& vessel) {
  const Particles inside = within(bed, vessel);
  if (inside.size() == 0) return nan;
  const double diameter = 2.0 * *std::max_element(inside.radius.begin(), inside.radius.end());
  const double height = bed_height(inside, vessel.floor);
  const double floor = vessel.floor.z();
  return solid_fraction(inside,
                        Slab{floor + diameter, floor + std::min(0.9 * height, height - diameter),
                             pi * vessel.radius * vessel.radius});
}

Vessel enclosing_vessel(const Particles& bed, const Vec3& floor) {
  double reach = 0.0;
  for (std::size_t i = 0; i < bed.size(); ++i)
    reach = std::max(reach, distance_from_axis(bed.position[i], floor) + bed.radius[i]);
  return {floor, reach};
}

double coordination_number(const State& state) {
  if (state.particles.size() == 0) return 0.0;
  return 2.0 * static_cast<double>(state.pair_contacts.partner.size()) /
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
  std::vector<double> mass, temperature, delta;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.species[i] != species) continue;
    mass.push_back(particles.mass[i]);
    temperature.push_back(particles.temperature[i]);
    delta.push_back(particles.delta[i]);
  }
  return {mass.size(), std::accumulate(mass.begin(), mass.end(), 0.0),
          weighted_spread(temperature, mass), weighted_spread(delta, mass)};
}

}  // namespace pmr::instruments
