#include "physics/gap.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pmr/base/constants.hpp"

namespace pmr::physics {
namespace {

constexpr int points = 8;
using Row = Eigen::Array<double, points, 1>;

// Gauss-Legendre rule on [0, 1].
struct Rule {
  Row node, weight;  // [1]
};

// Newton's method on the Legendre polynomial P_n (Bonnet's recursion), from Chebyshev's guesses.
Rule gauss_legendre() {
  Rule rule;
  for (int i = 0; i < points; ++i) {
    double x = -std::cos(pi * (i + 0.75) / (points + 0.5)), slope = 0.0;
    for (int iteration = 0; iteration < 10; ++iteration) {
      double before = 1.0, value = x;
      for (int n = 2; n <= points; ++n)
        before = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * before) / n);
      slope = points * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    rule.node[i] = 0.5 * (1.0 + x);
    rule.weight[i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

// The lens of one pair: symbols of the header's equation; 1 is the smaller sphere.
struct Lens {
  double R1, R2, d;  // [m]
  double slope1;     // D1/r_ij [1]
  double slope2;     // D2/r_ij' [1], 0 for a wall
  double r_sf;       // [m]
  bool faces_wall;
};

double cell_radius(double radius, double solid_fraction) {
  return 0.560 * radius / std::cbrt(solid_fraction);
}

double rim(double radius, double cell, double to_radical_plane) {
  return radius * cell / std::hypot(cell, to_radical_plane);
}

Lens lens_of(const GapPair& pair) {
  const auto [R1, R2] = std::minmax(pair.radius_1, pair.radius_2);
  const double d = pair.distance;
  const bool faces_wall = std::isinf(R2);
  const double D1 = faces_wall ? d : (R1 * R1 - R2 * R2 + d * d) / (2.0 * d);
  const double r_ij = cell_radius(R1, pair.solid_fraction);
  const double r_sf = rim(R1, r_ij, D1);
  const double slope2 = faces_wall ? 0.0 : std::sqrt(R2 * R2 - r_sf * r_sf) / r_sf;
  return {R1, R2, d, D1 / r_ij, slope2, r_sf, faces_wall};
}

// Scale b [m] of the lens: its resistance on the axis doubles about there, r^2 = b^2.
double lens_scale(const Lens& lens, double per_k1, double per_k2, double jump) {
  const double touching = lens.faces_wall ? lens.R1 : lens.R1 + lens.R2;
  const double solids = lens.R1 * per_k1 + (lens.faces_wall ? 0.0 : lens.R2 * per_k2);
  const double curvature = 0.5 / lens.R1 + 0.5 / lens.R2;  // [1/m]
  return std::sqrt((solids + std::max(lens.d - touching, 0.0) + jump) / curvature);
}

}  // namespace

double true_distance(double radius_1, double radius_2, double soft_distance) {
  const double touching = std::isinf(radius_2) ? radius_1 : radius_1 + radius_2;
  return std::max(touching, soft_distance);
}

double wall_lens_radius(double radius, double distance, double solid_fraction) {
  return rim(radius, cell_radius(radius, solid_fraction), distance);
}

double gap_conductance(const GapPair& pair, const GapMedium& medium) {
  static const Rule rule = gauss_legendre();
  const Lens lens = lens_of(pair);
  if (pair.contact_radius >= lens.r_sf) return 0.0;
  // Resistances of the solids relative to the gas [1].
  double per_k1 = medium.conductivity_gas / medium.conductivity_1;
  double per_k2 = medium.conductivity_gas / medium.conductivity_2;
  if (pair.radius_2 < pair.radius_1) std::swap(per_k1, per_k2);
  // r = r_c + (r_sf - r_c) c u/(1 + c - u): with c in proportion to b the integrand's poles, at
  // about r = +-i b, keep their distance from u in [0, 1] however thin the lens is.
  const double width = lens.r_sf - pair.contact_radius;
  const double c = std::max(3.0 * lens_scale(lens, per_k1, per_k2, medium.jump) / width, 1e-3);
  const Row u = rule.node;
  const Row bend = (1.0 + c - u).inverse();
  const Row r = pair.contact_radius + width * c * u * bend;
  const Row weight = rule.weight * (width * c * (1.0 + c)) * bend.square();
  const Row beta1 = (lens.R1 * lens.R1 - r.square()).sqrt();
  Row resistance = (beta1 - lens.slope1 * r) * per_k1 + (lens.d + medium.jump - beta1);
  if (!lens.faces_wall) {
    const Row beta2 = (lens.R2 * lens.R2 - r.square()).sqrt();
    resistance += (beta2 - lens.slope2 * r) * per_k2 - beta2;
  }
  return 2.0 * pi * medium.conductivity_gas * (weight * r / resistance).sum();
}

}  // namespace pmr::physics
