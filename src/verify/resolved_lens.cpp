#include "verify/resolved_lens.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pmr/base/constants.hpp"

namespace pmr::verify {
namespace {

using Edges = Eigen::ArrayXd;  // [m] of the rings, rising from 0 on the axis

constexpr int lens_rings = 90, spot_rings = 8;

// From r to r + width, finest at r: its first ring is about `first` [m] / rings wide.
Edges graded(double r, double width, double first, int rings) {
  const Edges u = Edges::LinSpaced(rings + 1, 0.0, 1.0);
  return r + first * ((u * std::log1p(width / first)).exp() - 1.0);
}

Edges edges_of(double rim, double spot, double scale) {
  if (spot <= 0.0) return graded(0.0, rim, 0.2 * scale, lens_rings);
  Edges edges(lens_rings + 1);
  const Edges u = Edges::LinSpaced(spot_rings + 1, 0.0, 0.5 * pi);
  edges.head(spot_rings + 1) = spot * u.sin();  // finest at its edge, where the flux is singular
  edges.tail(lens_rings - spot_rings + 1) =
      graded(spot, rim - spot, 0.03 * spot, lens_rings - spot_rings);
  return edges;
}

// Temperature of each ring over the heat of each, times k [1/m], of a sphere of radius R: with
// I_n = int P_n dmu over a ring, sum over odd n of (2 n + 1)/n I_n I_n'/(2 pi R dmu dmu').
Eigen::MatrixXd influence(const Edges& edges, double R, int polynomials) {
  const Eigen::Index n = edges.size();
  const Eigen::ArrayXd mu = (1.0 - (edges / R).square()).sqrt();
  const Eigen::ArrayXd width = mu.head(n - 1) - mu.tail(n - 1);
  Eigen::MatrixXd parts(n - 1, polynomials / 2);
  Eigen::ArrayXd before = Eigen::ArrayXd::Ones(n), value = mu;
  for (int k = 1; k < polynomials; ++k) {
    const Eigen::ArrayXd next = ((2 * k + 1) * mu * value - k * before) / (k + 1);
    if (k % 2 == 1) {
      const Eigen::ArrayXd integral = (next - before) / (2 * k + 1);
      parts.col(k / 2) =
          std::sqrt((2.0 * k + 1.0) / k) * (integral.head(n - 1) - integral.tail(n - 1)) / width;
    }
    before = std::exchange(value, next);
  }
  return parts * parts.transpose() / (2.0 * pi * R);
}

}  // namespace

double resolved_conductance(const physics::GapPair& pair, const physics::GapMedium& medium) {
  double R1 = pair.radius_1, R2 = pair.radius_2;
  double k1 = medium.conductivity_1, k2 = medium.conductivity_2;
  if (R2 < R1) {
    std::swap(R1, R2);
    std::swap(k1, k2);
  }
  const bool is_wall = std::isinf(R2);
  const double d = pair.distance, spot = pair.contact_radius;
  const double D1 = is_wall ? d : (R1 * R1 - R2 * R2 + d * d) / (2.0 * d);
  const double cell = 0.560 * R1 / std::cbrt(pair.solid_fraction);
  const double rim = R1 * cell / std::hypot(cell, D1);
  const double nearest = d - R1 - (is_wall ? 0.0 : R2) + medium.jump;
  const double scale = std::max(
      {std::sqrt(2.0 * nearest * R1), R1 * medium.conductivity_gas / std::min(k1, k2), 1e-3 * R1});
  const Edges edges = edges_of(rim, spot, scale);
  const double finest = spot > 0.0 ? 0.3 * spot : scale;
  const int polynomials = 2 * static_cast<int>(std::clamp(30.0 * R1 / finest, 1e3, 2e4));
  const Eigen::Index n = edges.size() - 1;
  const Eigen::ArrayXd inner = edges.head(n).square(), outer = edges.tail(n).square();
  const Eigen::ArrayXd r2 = 0.5 * (inner + outer);
  Eigen::ArrayXd gap = d + medium.jump - (R1 * R1 - r2).sqrt();
  if (!is_wall) gap -= (R2 * R2 - r2).sqrt();
  if (spot > 0.0) gap.head(spot_rings) = 0.0;
  Eigen::MatrixXd system = influence(edges, R1, polynomials) / k1;
  if (!is_wall) system += influence(edges, R2, polynomials) / k2;
  system.diagonal().array() += gap / (medium.conductivity_gas * pi * (outer - inner));
  return system.partialPivLu().solve(Eigen::VectorXd::Ones(n)).sum();
}

}  // namespace pmr::verify
