#include "physics/porous_bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/upright.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::physics {
namespace {

using PlanPoint = Eigen::Vector2d;
constexpr int corners = 16;  // of the polygon that stands for a sphere's circle, of the same area

double cross(const PlanPoint& o, const PlanPoint& a, const PlanPoint& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// Convex hull (Andrew's monotone chain).
Footprint hull_of(std::vector<PlanPoint> points) {
  std::sort(points.begin(), points.end(), [](const PlanPoint& a, const PlanPoint& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Footprint hull;
  const auto add = [&](const PlanPoint& p, std::size_t floor) {
    while (hull.size() >= floor + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const PlanPoint& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t k = points.size() - 1; k-- > 0;) add(points[k], lower);
  hull.pop_back();  // the first once more
  return hull;
}

// Part [1] of a sphere's volume that lies below the height h over its centre, in radii.
double part_below(double h) {
  const double x = std::clamp(h, -1.0, 1.0);
  return 0.25 * (2.0 + 3.0 * x - x * x * x);
}

}  // namespace

Footprint footprint(std::span<const Vec3> places, std::span<const double> radii) {
  std::vector<PlanPoint> points;
  const double swell = std::sqrt(2.0 * pi / corners / std::sin(2.0 * pi / corners));
  for (std::size_t i = 0; i < places.size(); ++i)
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * pi * k / corners;
      points.push_back(places[i].head<2>() +
                       swell * radii[i] * PlanPoint(std::cos(angle), std::sin(angle)));
    }
  return points.empty() ? Footprint{} : hull_of(std::move(points));
}

double area(const Footprint& hull) {
  double doubled = 0.0;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const PlanPoint &a = hull[k], &b = hull[(k + 1) % hull.size()];
    doubled += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * std::abs(doubled);
}

bool is_inside(const Footprint& hull, const PlanPoint& p) {
  for (std::size_t k = 0; k < hull.size(); ++k)
    if (cross(hull[k], hull[(k + 1) % hull.size()], p) < 0.0) return false;
  return !hull.empty();
}

double carman_kozeny(double sauter_diameter, double porosity) {
  const double solid = 1.0 - porosity;
  return sauter_diameter * sauter_diameter * porosity * porosity * porosity /
         (180.0 * solid * solid);
}

double capillary_radius(double permeability, double porosity, double tortuosity) {
  return std::sqrt(8.0 * tortuosity * permeability / porosity);
}

double slip_factor(double mean_free_path, double capillary_radius) {
  return 1.0 + 4.0 * mean_free_path / capillary_radius;
}

LayeredBed cut_in_layers(const Particles& p, std::size_t most, const Vec3& up, double part) {
  LayeredBed bed;
  ensure(p.size() > 0, "a bed has particles");
  const std::vector<Vec3> places = upright(p.position, up);
  std::vector<double> tops(p.size());
  double floor = places[0].z();
  for (std::size_t i = 0; i < p.size(); ++i) {
    tops[i] = places[i].z() + p.radius[i];
    floor = std::min(floor, places[i].z() - p.radius[i]);
  }
  const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(p.size() - 1));
  std::nth_element(tops.begin(), tops.begin() + rank, tops.end());
  const double whole = tops[static_cast<std::size_t>(rank)] - floor;
  const double largest = 2.0 * *std::max_element(p.radius.begin(), p.radius.end());
  constexpr double rounding = 1e-9;  // [1]
  const double fit = std::floor(whole / largest + rounding);
  const auto count = static_cast<std::size_t>(std::clamp(fit, 1.0, static_cast<double>(most)));
  const double height = whole / static_cast<double>(count);
  bed.layers.assign(count, {area(footprint(places, p.radius)), height, 0.0, 0.0, 0.0});
  bed.layer_of.resize(p.size());
  const auto last = static_cast<double>(count - 1);
  const auto layer_at = [&](double z) {
    return static_cast<std::size_t>(std::clamp(std::floor((z - floor) / height), 0.0, last));
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double z = places[i].z(), r = p.radius[i];
    const double volume = 4.0 / 3.0 * pi * r * r * r;
    bed.layer_of[i] = static_cast<std::uint32_t>(layer_at(z));
    double below = 0.0;  // [1]
    for (std::size_t k = layer_at(z - r); k <= layer_at(z + r); ++k) {
      const double ceiling = floor + static_cast<double>(k + 1) * height;
      const double up_to = k + 1 == count ? 1.0 : part_below((ceiling - z) / r);
      bed.layers[k].solid_volume += (up_to - below) * volume;
      bed.layers[k].surface += (up_to - below) * 3.0 * volume / r;
      below = up_to;
    }
  }
  for (BedLayer& layer : bed.layers)
    layer.sauter_diameter = layer.surface > 0.0 ? 6.0 * layer.solid_volume / layer.surface : 0.0;
  return bed;
}

}  // namespace pmr::physics
