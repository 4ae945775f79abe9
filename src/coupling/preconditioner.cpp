#include "coupling/preconditioner.hpp"

#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// d(n_O2, n_N2, U rates of its gas)/d(H, delta) of a reactant.
Eigen::Matrix<double, 3, 2> gas_slopes(const Linearisation& J, const ReactionSlopes& r) {
  const auto by = r.by_unknowns(J.capacity[r.id]);
  Eigen::Matrix<double, 3, 2> slopes;
  slopes << by.by_H, by.by_delta,  //
      0.0, 0.0,                    //
      by.by_H * r.oxygen_heat + by.warming,
      by.by_delta * r.oxygen_heat - by.warming * r.delta_slope;
  return slopes;
}

}  // namespace

Preconditioner::Preconditioner(const Linearisation& J, double gamma) : gamma_(gamma) {
  factor_particles(J);
  factor_walls(J);
  if (J.system->zones() > 0) factor_gas(J);
}

void Preconditioner::factor_particles(const Linearisation& J) {
  particle_pivot_.resize(J.capacity.size());
  parallel_for(particle_pivot_.size(), [&](std::size_t id) {
    particle_pivot_[id] = 1.0 + gamma_ * J.heat.loss(id) / J.capacity[id];
  });
  blocks_.resize(J.reactions.size());
  parallel_for(blocks_.size(), [&](std::size_t k) {
    const ReactionSlopes& r = J.reactions[k];
    const double capacity = J.capacity[r.id];
    const auto [by_H, by_delta, warming] = r.by_unknowns(capacity);
    const double loss = J.heat.loss(r.id) / capacity;  // [1/s]
    // Rows: H' and delta' by (H, delta).
    const double hh = 1.0 + gamma_ * (loss + by_H * r.oxygen_heat + warming);
    const double hd = gamma_ * (by_delta * r.oxygen_heat - (loss + warming) * r.delta_slope);
    const double dh = -gamma_ * 2.0 / r.formula_units * by_H;
    const double dd = 1.0 - gamma_ * 2.0 / r.formula_units * by_delta;
    const double det = hh * dd - hd * dh;
    blocks_[k] = {dd / det, -hd / det, -dh / det, hh / det};
  });
}

void Preconditioner::factor_walls(const Linearisation& J) {
  const System& system = *J.system;
  wall_lower_.assign(system.nodes->cells, 0.0);
  wall_pivot_.assign(system.nodes->cells, 1.0);
  wall_upper_.assign(system.nodes->cells, 0.0);
  for (const WallProfile& wall : system.profiles) {
    double inner = J.heat.loss(wall.node);  // [W/K]
    for (std::size_t j = 0; j < wall.conductance.size(); ++j) {
      const std::size_t cell = wall.first_cell + j;
      const double outer = wall.area * wall.conductance[j];
      wall_pivot_[cell] = 1.0 + gamma_ * (inner + outer) / wall.capacity[j];
      if (j + 1 < wall.conductance.size())
        wall_upper_[cell] = -gamma_ * outer / wall.capacity[j + 1];
      if (j > 0) {
        wall_lower_[cell] = -gamma_ * inner / wall.capacity[j - 1] / wall_pivot_[cell - 1];
        wall_pivot_[cell] -= wall_lower_[cell] * wall_upper_[cell - 1];
      }
      inner = outer;
    }
  }
}

void Preconditioner::factor_gas(const Linearisation& J) {
  const std::size_t zones = J.system->zones();
  Eigen::MatrixXd schur = Eigen::MatrixXd::Identity(J.gas.rates.rows(), J.gas.rates.cols()) -
                          gamma_ * gas_by_gas(J, 0.0);
  // What the granules reply to a pressure.
  const auto answer =
      parallel_bins(J.reactions.size(), 3 * zones, [&](std::size_t k, std::vector<double>& sums) {
        const ReactionSlopes& r = J.reactions[k];
        const Eigen::Vector2d push(gamma_ * r.by_pressure * r.oxygen_heat,
                                   -gamma_ * 2.0 / r.formula_units * r.by_pressure);
        const Block& b = blocks_[k];
        const Eigen::Vector2d reply(b.a * push[0] + b.b * push[1], b.c * push[0] + b.d * push[1]);
        const Vec3 given = gas_slopes(J, r) * reply;
        for (std::size_t row = 0; row < 3; ++row)
          sums[3 * r.zone + row] += given[static_cast<Eigen::Index>(row)];
      });
  for (std::size_t zone = 0; zone < zones; ++zone) {
    const auto first = static_cast<Eigen::Index>(3 * zone);
    schur.block<3, 3>(first, first) +=
        gamma_ * Vec3(answer[3 * zone], answer[3 * zone + 1], answer[3 * zone + 2]) *
        J.gas.pressure[zone].transpose();
  }
  gas_.compute(schur);
}

Eigen::VectorXd Preconditioner::solve_gas(const Linearisation& J, std::span<const double> r,
                                          std::span<double> z) const {
  const System& system = *J.system;
  const std::size_t delta = system.delta_begin(), gas = system.gas_begin();
  Eigen::VectorXd dgas = gas_part(system, r);
  const auto given = parallel_bins(
      J.reactions.size(), 3 * system.zones(), [&](std::size_t k, std::vector<double>& sums) {
        const ReactionSlopes& grain = J.reactions[k];
        const Block& b = blocks_[k];
        const double h = r[grain.id], d = r[delta + k];
        z[grain.id] = b.a * h + b.b * d;
        z[delta + k] = b.c * h + b.d * d;
        const Vec3 part = gas_slopes(J, grain) * Eigen::Vector2d(z[grain.id], z[delta + k]);
        for (std::size_t row = 0; row < 3; ++row)
          sums[3 * grain.zone + row] += part[static_cast<Eigen::Index>(row)];
      });
  for (std::size_t k = 0; k < given.size(); ++k)
    dgas[static_cast<Eigen::Index>(k)] += gamma_ * given[k];
  const auto warming = layer_means(system.pores, [&](std::size_t node) {
    const std::uint32_t k = system.reactant_of[node];
    const double bound = k == System::no_reactant ? 0.0 : J.reactions[k].delta_slope * z[delta + k];
    return (z[node] - bound) / J.capacity[node];
  });
  for (std::size_t k = 0; k < warming.size(); ++k)
    dgas[static_cast<Eigen::Index>(3 * k + 2)] += gamma_ * system.pores.layers[k].film * warming[k];
  dgas = gas_.solve(dgas);
  for (std::size_t k = 0; k < given.size(); ++k) z[gas + k] = dgas[static_cast<Eigen::Index>(k)];
  return dgas;
}

void Preconditioner::solve_walls(const System& system, std::span<const double> r,
                                 std::span<double> z) const {
  for (const WallProfile& wall : system.profiles) {
    const std::size_t cells = wall.conductance.size(), first = wall.first_cell;
    const auto right = r.subspan(system.cell_begin() + first, cells);
    const auto left = z.subspan(system.cell_begin() + first, cells);
    for (std::size_t j = 0; j < cells; ++j)
      left[j] = right[j] - (j > 0 ? wall_lower_[first + j] * left[j - 1] : 0.0);
    for (std::size_t j = cells; j-- > 0;)
      left[j] = (left[j] - (j + 1 < cells ? wall_upper_[first + j] * left[j + 1] : 0.0)) /
                wall_pivot_[first + j];
  }
}

void Preconditioner::solve(const Linearisation& J, std::span<const double> r,
                           std::span<double> z) const {
  const std::size_t delta = J.system->delta_begin();
  parallel_for(particle_pivot_.size(),
               [&](std::size_t id) { z[id] = r[id] / particle_pivot_[id]; });
  std::vector<double> pressure;
  if (J.system->zones() > 0) pressure = pressure_changes(J.gas, solve_gas(J, r, z));
  parallel_for(J.reactions.size(), [&](std::size_t k) {
    const ReactionSlopes& grain = J.reactions[k];
    const Block& b = blocks_[k];
    const double push =  // [mol/s] released by the change of pressure
        grain.zone == System::open_air ? 0.0 : grain.by_pressure * pressure[grain.zone];
    const double h = r[grain.id] - gamma_ * push * grain.oxygen_heat;
    const double d = r[delta + k] + gamma_ * 2.0 / grain.formula_units * push;
    z[grain.id] = b.a * h + b.b * d;
    z[delta + k] = b.c * h + b.d * d;
  });
  solve_walls(*J.system, r, z);
}

}  // namespace pmr::coupling
