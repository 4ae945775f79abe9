#include "verify/random_packing.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <span>

#include "case/case.hpp"
#include "coupling/nodes.hpp"
#include "coupling/retrace.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/random.hpp"

namespace pmr::verify {
namespace {

constexpr double allowed_overlap = 1e-5;  // [1] of the diameter
constexpr int most_sweeps = 20'000;
constexpr double margin = 5.0;  // [1] diameters of images around the cube; rays fly half of one

Vec3 nearest_image(Vec3 way, double side) {
  for (int k = 0; k < 3; ++k) way[k] -= side * std::round(way[k] / side);
  return way;
}

// The spheres of a periodic cube by cells that are no smaller than a diameter.
class Cells {
 public:
  Cells(const std::vector<Vec3>& place, double side, double diameter)
      : across_(static_cast<int>(side / (1.01 * diameter))),
        width_(side / across_),
        members_(static_cast<std::size_t>(across_) * across_ * across_) {
    for (std::size_t i = 0; i < place.size(); ++i)
      members_[at(cell(place[i], 0), cell(place[i], 1), cell(place[i], 2))].push_back(i);
  }
  // visit(j) for every sphere of the 27 cells around `x`.
  template <class Visit>
  void around(const Vec3& x, const Visit& visit) const {
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b)
        for (int c = -1; c <= 1; ++c)
          for (const std::size_t j : members_[at(cell(x, 0) + a, cell(x, 1) + b, cell(x, 2) + c)])
            visit(j);
  }

 private:
  int cell(const Vec3& x, int k) const { return static_cast<int>(x[k] / width_); }
  std::size_t at(int a, int b, int c) const {
    const auto wrap = [this](int k) { return static_cast<std::size_t>((k + across_) % across_); };
    return (wrap(a) * static_cast<std::size_t>(across_) + wrap(b)) *
               static_cast<std::size_t>(across_) +
           wrap(c);
  }
  int across_;
  double width_;  // [m]
  std::vector<std::vector<std::size_t>> members_;
};

// Pushes every sphere out of its neighbours once; the deepest overlap there was [m].
double push_apart(RandomPacking& packing) {
  const Cells cells(packing.place, packing.side, packing.diameter);
  const double wanted = packing.diameter * (1.0 + 5.0 * allowed_overlap);
  std::vector<Vec3> push(packing.place.size(), Vec3::Zero());
  double deepest = 0.0;
  for (std::size_t i = 0; i < push.size(); ++i)
    cells.around(packing.place[i], [&](std::size_t j) {
      if (i == j) return;
      const Vec3 way = nearest_image(packing.place[i] - packing.place[j], packing.side);
      const double distance = way.norm();
      if (distance >= wanted) return;
      deepest = std::max(deepest, packing.diameter - distance);
      push[i] += 0.5 * (wanted - distance) / distance * way;
    });
  for (std::size_t i = 0; i < push.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double x = packing.place[i][k] + push[i][k];
      packing.place[i][k] = std::min(x - packing.side * std::floor(x / packing.side),
                                     std::nextafter(packing.side, 0.0));
    }
  return deepest;
}

// The cube's spheres, then their images within the margin; each with the sphere it stands for.
struct Imaged {
  std::vector<Vec3> place;      // [m]
  std::vector<std::size_t> of;  // index in the cube
};

Imaged with_images(const RandomPacking& packing) {
  Imaged all;
  const double reach = margin * packing.diameter;
  const auto add = [&](const Vec3& shift) {
    for (std::size_t i = 0; i < packing.place.size(); ++i) {
      const Vec3 x = packing.place[i] + packing.side * shift;
      if ((x.array() < -reach).any() || (x.array() > packing.side + reach).any()) continue;
      all.place.push_back(x);
      all.of.push_back(i);
    }
  };
  add(Vec3::Zero());
  for (int a = -1; a <= 1; ++a)
    for (int b = -1; b <= 1; ++b)
      for (int c = -1; c <= 1; ++c)
        if (a != 0 || b != 0 || c != 0) add(Vec3(a, b, c));
  return all;
}

// Spheres of 1000 K that stand free, as the tracer wants them.
constexpr const char* free_spheres = R"(
title = "Spheres without walls"
gravity = "none"
domain = {low = "-1 -1 -1 m", high = "1 1 1 m"}
[species.ball]
material = "Al2O3"
diameter = "1 mm"
count = 1
temperature = "1000 K"
region = {base = "0 0 0 mm", radius = "2 mm", height = "5 mm"}
[fill]
duration = "1 s"
rest_speed = "2 mm/s"
rest_hold = "20 ms"
[models.radiation]
surroundings = "1000 K"
)";

Exchange trace(const Imaged& all, double diameter, double emissivity, double rays) {
  Case c = casefile::load_case_text(free_spheres, "spheres without walls", ".", {});
  for (Material& material : c.materials.list) material.emissivity = {{{0.0}, {emissivity}}};
  State state;
  resize(state.particles, all.place.size());
  state.particles.position = all.place;
  for (std::size_t i = 0; i < all.place.size(); ++i) {
    state.particles.id[i] = static_cast<ParticleId>(i);
    state.particles.radius[i] = 0.5 * diameter;
    state.particles.temperature[i] = 1e3;
  }
  return coupling::retrace(c, coupling::number_nodes(c, all.place.size()), state, rays);
}

}  // namespace

RandomPacking random_packing(std::size_t count, double diameter, double solid_fraction,
                             std::uint64_t seed) {
  const double volume = static_cast<double>(count) * pi * std::pow(diameter, 3) / 6.0;
  RandomPacking packing{std::cbrt(volume / solid_fraction), diameter, std::vector<Vec3>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, Purpose::test, i);
    for (int k = 0; k < 3; ++k) packing.place[i][k] = packing.side * random.uniform();
  }
  for (int sweep = 0; sweep < most_sweeps; ++sweep)
    if (push_apart(packing) < allowed_overlap * diameter) return packing;
  throw NumericsError("random packing: overlaps are left at this solid fraction");
}

// Per mean gradient along one axis the network carries sum G/2 (dx^2 - dx dT), where T(x) = x + t
// and the deviations t are what conjugate gradients find.
double exchange_factor(const RandomPacking& packing, double emissivity, double rays) {
  const Imaged all = with_images(packing);
  const Exchange exchange = trace(all, packing.diameter, emissivity, rays);
  const auto count = static_cast<int>(packing.place.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d drive = Eigen::MatrixX3d::Zero(count, 3);  // [m3] sum_j G dx
  double affine = 0.0;                                        // [m4]
  for (int i = 0; i < count; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const auto columns = exchange.factor.columns(row);
    const auto values = exchange.factor.values(row);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] >= all.place.size()) continue;  // the surroundings, which no ray may reach
      const Vec3 way = all.place[columns[k]] - all.place[row];
      const int j = static_cast<int>(all.of[columns[k]]);
      const double half = 0.5 * values[k];  // of either direction: images are traced on their own
      entries.insert(entries.end(), {{i, i, half}, {j, j, half}, {i, j, -half}, {j, i, -half}});
      drive.row(i) += half * way;
      drive.row(j) -= half * way;
      affine += values[k] * way.squaredNorm();
    }
  }
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-8);
  solver.compute(laplacian);
  const double relaxed = drive.cwiseProduct(solver.solve(drive)).sum();
  const double volume = std::pow(packing.side, 3);
  return 0.5 * (affine - relaxed) / 3.0 / (volume * packing.diameter);
}

}  // namespace pmr::verify
