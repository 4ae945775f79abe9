#include "physics/gap.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
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

// The lens of one pair; 1 is the smaller sphere, and 2 may be a plane wall.
struct Lens {
  double R1, R2;   // [m]
  double r_sf;     // [m] of the rim
  double nearest;  // [m] of the surfaces, with the jump
  bool faces_wall;
  double log_t1 = std::log(r_sf / R1), log_t2 = faces_wall ? 0.0 : std::log(r_sf / R2);

  // Of the surfaces, with the jump, at distances from the axis given by their squares [m].
  Row gap(const Row& r2) const {
    Row h = nearest + R1 - (R1 * R1 - r2).sqrt();
    if (!faces_wall) h += R2 - (R2 * R2 - r2).sqrt();
    return h;
  }
  // How much wider it is at the rim than on the axis [m].
  double rise_to_rim() const {
    const double own = R1 - std::sqrt(R1 * R1 - r_sf * r_sf);
    return faces_wall ? own : own + R2 - std::sqrt(R2 * R2 - r_sf * r_sf);
  }
  // Sum over the solids of a function of their radius and ln(r_sf/R), over their conductivity.
  template <class F>
  double over(const std::array<double, 2>& per_k, F&& of) const {
    return per_k[0] * of(R1, log_t1) + (faces_wall ? 0.0 : per_k[1] * of(R2, log_t2));
  }
};

double cell_radius(double radius, double solid_fraction) {
  return 0.560 * radius / std::cbrt(solid_fraction);
}

double rim(double radius, double cell, double to_radical_plane) {
  return radius * cell / std::sqrt(cell * cell + to_radical_plane * to_radical_plane);
}

Lens lens_of(const GapPair& pair, double jump) {
  const auto [R1, R2] = std::minmax(pair.radius_1, pair.radius_2);
  const double d = pair.distance;
  const bool faces_wall = std::isinf(R2);
  const double D1 = faces_wall ? d : (R1 * R1 - R2 * R2 + d * d) / (2.0 * d);
  const double touching = faces_wall ? R1 : R1 + R2;
  return {R1, R2, rim(R1, cell_radius(R1, pair.solid_fraction), D1), d - touching + jump,
          faces_wall};
}

// Scale c [m] of the flux, q ~ 1/(r^2 + c^2), where the solids' resistance is as that of a gap
// s = m c sum(k_f/k): the best m from 0.8 to 2.5 within what H minds, which is little.
double flux_scale(const Lens& lens, double solids, double curvature) {
  double m = 1.2, c = 0.0;
  for (int pass = 0; pass < 2; ++pass) {
    const double half = 0.5 * m * solids / curvature;
    c = half + std::sqrt(half * half + lens.nearest / curvature);
    m = 0.5 + 0.5 * std::sqrt(std::sqrt(lens.r_sf / c));
  }
  return std::max(c, 1e-9 * lens.r_sf);
}

// k r_sf S/Q^2 [1] of a flux q ~ 1/(r^2 + c^2) within r_sf of the pole of a sphere whose equator is
// isothermal: S = int int q q' G dA dA'. Fit (scripts/fit-spreading) to sums of 2,000 to 60,000
// Legendre polynomials for c/r_sf from 0.003, r_sf/R of 0.06 to 0.68: within 0.25 %. First term:
// half-space (c to infinity: 8/(3 pi^2), a disc of even flux); the others: the sphere.
class Spreading {
 public:
  explicit Spreading(double c_per_rim) : L_(std::log1p(1.0 / (c_per_rim * c_per_rim))) {
    half_space_ = 8.0 / (3.0 * pi * pi) *
                  std::exp(L_ * (0.066506 + L_ * (0.047157 + L_ * 0.011556)) /
                           (1.0 + L_ * (0.47218 + L_ * 0.022672)));
  }
  // t = r_sf/R, and its logarithm.
  double operator()(double t, double log_t) const {
    const double sphere = -log_t / (4.0 * pi) + 0.059872 + 0.013767 * L_ * L_ / (L_ + 2.5823);
    return half_space_ + t * (sphere - 0.087271 * t / (1.0 + 0.18050 * L_));
  }

 private:
  double L_, half_space_;
};

// A flux through the lens as the gap and the solids' spreading shape it, and what it meets.
struct LensFlux {
  double resistance;  // [m K/W] times k_f: of the gas and of the solids that it spreads in
  double on_axis;     // [m K/W] times k_f: what it makes of the solids' temperatures at the pole
};

LensFlux flux_through(const Lens& lens, double contact_radius, const std::array<double, 2>& per_k) {
  static const Rule rule = gauss_legendre();
  const double curvature = 0.5 / lens.R1 + 0.5 / lens.R2;  // [1/m]: gap = nearest + curvature r^2
  const double solids = lens.over(per_k, [](double, double) { return 1.0; });
  const double c = flux_scale(lens, solids, curvature);
  const double s = std::max(0.0, c * c * curvature - lens.nearest);
  // Over v = ln(1 + r^2/c^2), in which r dr q is nearly even however thin the lens is.
  const double c2 = c * c;
  const double low = contact_radius > 0.0 ? std::log1p(contact_radius * contact_radius / c2) : 0.0;
  const double high = std::log1p(lens.r_sf * lens.r_sf / c2);
  const Row wide = c2 * (low + (high - low) * rule.node).exp();  // r^2 + c^2
  const Row h = lens.gap(wide - c2);
  const Row per_gap = (h + s).inverse();
  const Row q = pi * (high - low) * rule.weight * wide * per_gap;  // with 2 pi r dr
  const double Q = q.sum();
  const double gas = (q * h * per_gap).sum() / (Q * Q);
  const Spreading spreading(std::sqrt((lens.nearest + s) / lens.rise_to_rim()));
  const double spread =
      lens.over(per_k, [&](double R, double log_t) { return spreading(lens.r_sf / R, log_t); });
  if (contact_radius <= 0.0) return {gas + spread / lens.r_sf, 0.0};
  const double inner =
      std::atan((lens.r_sf - contact_radius) * c / (c2 + lens.r_sf * contact_radius));
  const double axis =
      solids * inner / (pi * (high - low) * c) +
      lens.over(per_k, [](double R, double log_t) { return (0.05 - log_t / (4.0 * pi)) / R; });
  return {gas + spread / lens.r_sf, axis};
}

// Of the contact spot alone, times k_f [m K/W]: that of two half-spaces, and the spheres' part.
double spot_resistance(const Lens& lens, double contact_radius,
                       const std::array<double, 2>& per_k) {
  const double log_a = std::log(lens.r_sf / contact_radius);
  return (per_k[0] + per_k[1]) / (4.0 * contact_radius) +
         lens.over(per_k, [&](double R, double log_t) {
           return (0.06 + (log_a - log_t) / (4.0 * pi)) / R;
         });
}

std::array<double, 2> relative(const GapPair& pair, const GapMedium& medium, double conductivity) {
  std::array<double, 2> per_k{conductivity / medium.conductivity_1,
                              conductivity / medium.conductivity_2};
  if (pair.radius_2 < pair.radius_1) std::swap(per_k[0], per_k[1]);
  return per_k;
}

}  // namespace

double true_distance(double radius_1, double radius_2, double soft_distance) {
  const double touching = std::isinf(radius_2) ? radius_1 : radius_1 + radius_2;
  return std::max(touching, soft_distance);
}

double wall_lens_radius(double radius, double distance, double solid_fraction) {
  return rim(radius, cell_radius(radius, solid_fraction), distance);
}

double gap_fade(double gap, double begin, double end) {
  const double u = std::clamp((end - gap) / (end - begin), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

double gap_conductance(const GapPair& pair, const GapMedium& medium) {
  const Lens lens = lens_of(pair, medium.jump);
  if (pair.contact_radius >= lens.r_sf) return 0.0;
  const double k_f = medium.conductivity_gas;
  return k_f / flux_through(lens, pair.contact_radius, relative(pair, medium, k_f)).resistance;
}

double spot_conductance(const GapPair& pair, const GapMedium& medium) {
  if (pair.contact_radius <= 0.0) return 0.0;
  return 1.0 / spot_resistance(lens_of(pair, medium.jump), pair.contact_radius,
                               relative(pair, medium, 1.0));
}

PairConductance pair_conductance(const GapPair& pair, const GapMedium& medium) {
  const Lens lens = lens_of(pair, medium.jump);
  if (pair.contact_radius >= lens.r_sf) return {spot_conductance(pair, medium), 0.0};
  const double k_f = medium.conductivity_gas;
  const auto per_k = relative(pair, medium, k_f);
  const auto [gas, mutual] = flux_through(lens, pair.contact_radius, per_k);
  if (pair.contact_radius <= 0.0) return {0.0, k_f / gas};
  const double spot = spot_resistance(lens, pair.contact_radius, per_k);
  if (mutual >= gas) return {0.0, k_f / gas};
  if (mutual >= spot) return {k_f / spot, 0.0};
  const double scale = k_f / (gas * spot - mutual * mutual);
  return {scale * (gas - mutual), scale * (spot - mutual)};
}

}  // namespace pmr::physics
