// P ~ I - gamma J, factorised and solved block by block (see linearisation.hpp).
#include "coupling/linearisation.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

void Linearisation::prepare(double gamma) {
  gamma_ = gamma;
  factor_particles(gamma);
  factor_walls(gamma);
  if (system_.bodies() > 0) factor_gas(gamma);
}

void Linearisation::factor_particles(double gamma) {
  particle_pivot_.resize(capacity_.size());
  parallel_for(capacity_.size(), [&](std::size_t id) {
    const double loss = conduction_sum_[id] + exchange_sum_[id] * emission_slope_[id];
    particle_pivot_[id] = 1.0 + gamma * loss / capacity_[id];
  });
  blocks_.resize(reactions_.size());
  parallel_for(reactions_.size(), [&](std::size_t k) {
    const Reaction& r = reactions_[k];
    const double capacity = capacity_[r.id];
    const double release_H = r.by_T / capacity;
    const double release_delta = r.by_delta - release_H * r.delta_slope;
    const double warming = r.release * r.oxygen_capacity / capacity;
    const double loss =
        (conduction_sum_[r.id] + exchange_sum_[r.id] * emission_slope_[r.id]) / capacity;  // [1/s]
    // Rows: H' and delta' by (H, delta).
    const double hh = 1.0 + gamma * (loss + release_H * r.oxygen_heat + warming);
    const double hd = gamma * (release_delta * r.oxygen_heat - (loss + warming) * r.delta_slope);
    const double dh = -gamma * 2.0 / r.iron * release_H;
    const double dd = 1.0 - gamma * 2.0 / r.iron * release_delta;
    const double det = hh * dd - hd * dh;
    blocks_[k] = {dd / det, -hd / det, -dh / det, hh / det};
  });
}

void Linearisation::factor_walls(double gamma) {
  wall_lower_.assign(cell_capacity_.size(), 0.0);
  wall_pivot_.assign(cell_capacity_.size(), 1.0);
  wall_upper_.assign(cell_capacity_.size(), 0.0);
  for (const WallProfile& wall : system_.profiles) {
    double inner = conduction_sum_[wall.node] +
                   exchange_sum_[wall.node] * emission_slope_[wall.node];  // [W/K]
    for (std::size_t j = 0; j < wall.conductance.size(); ++j) {
      const std::size_t cell = wall.first_cell + j;
      const double outer = wall.area * wall.conductance[j];
      wall_pivot_[cell] = 1.0 + gamma * (inner + outer) / cell_capacity_[cell];
      if (j + 1 < wall.conductance.size())
        wall_upper_[cell] = -gamma * outer / cell_capacity_[cell + 1];
      if (j > 0) {
        wall_lower_[cell] = -gamma * inner / cell_capacity_[cell - 1] / wall_pivot_[cell - 1];
        wall_pivot_[cell] -= wall_lower_[cell] * wall_upper_[cell - 1];
      }
      inner = outer;
    }
  }
}

void Linearisation::factor_gas(double gamma) {
  const std::size_t bodies = system_.bodies();
  Eigen::MatrixXd schur =
      Eigen::MatrixXd::Identity(gas_jacobian_.rows(), gas_jacobian_.cols()) - gamma * gas_by_gas();
  // What the granules reply to a pressure.
  const auto answer =
      parallel_bins(reactions_.size(), 3 * bodies, [&](std::size_t k, std::vector<double>& sums) {
        const Reaction& r = reactions_[k];
        const Eigen::Vector2d push(gamma * r.by_pressure * r.oxygen_heat,
                                   -gamma * 2.0 / r.iron * r.by_pressure);
        const Block& b = blocks_[k];
        const Eigen::Vector2d reply(b.a * push[0] + b.b * push[1], b.c * push[0] + b.d * push[1]);
        const Vec3 given = gas_slopes(r) * reply;
        for (std::size_t row = 0; row < 3; ++row)
          sums[3 * r.body + row] += given[static_cast<Eigen::Index>(row)];
      });
  for (std::size_t body = 0; body < bodies; ++body) {
    const auto first = static_cast<Eigen::Index>(3 * body);
    schur.block<3, 3>(first, first) +=
        gamma * Vec3(answer[3 * body], answer[3 * body + 1], answer[3 * body + 2]) *
        pressure_row_[body].transpose();
  }
  gas_solver_.compute(schur);
}

void Linearisation::precondition(std::span<const double> r, std::span<double> z) const {
  const std::size_t delta = system_.delta_begin(), gas = system_.gas_begin();
  parallel_for(capacity_.size(), [&](std::size_t id) { z[id] = r[id] / particle_pivot_[id]; });
  std::vector<double> pressure;
  if (system_.bodies() > 0) {
    Eigen::VectorXd dgas = gas_part(r);
    const auto given = parallel_bins(
        reactions_.size(), 3 * system_.bodies(), [&](std::size_t k, std::vector<double>& sums) {
          const Reaction& grain = reactions_[k];
          const Block& b = blocks_[k];
          const double h = r[grain.id], d = r[delta + k];
          z[grain.id] = b.a * h + b.b * d;
          z[delta + k] = b.c * h + b.d * d;
          const Vec3 part = gas_slopes(grain) * Eigen::Vector2d(z[grain.id], z[delta + k]);
          for (std::size_t row = 0; row < 3; ++row)
            sums[3 * grain.body + row] += part[static_cast<Eigen::Index>(row)];
        });
    for (std::size_t k = 0; k < given.size(); ++k)
      dgas[static_cast<Eigen::Index>(k)] += gamma_ * given[k];
    const auto warming = layer_means(system_.pores, [&](std::size_t node) {
      const std::uint32_t k = system_.reactant_of[node];
      const double bound =
          k == System::no_reactant ? 0.0 : reactions_[k].delta_slope * z[delta + k];
      return (z[node] - bound) / capacity_[node];
    });
    for (std::size_t k = 0; k < warming.size(); ++k)
      dgas[static_cast<Eigen::Index>(3 * k + 2)] +=
          gamma_ * system_.pores.layers[k].film * warming[k];
    dgas = gas_solver_.solve(dgas);
    pressure = pressure_changes(dgas);
    for (std::size_t k = 0; k < given.size(); ++k) z[gas + k] = dgas[static_cast<Eigen::Index>(k)];
  }
  parallel_for(reactions_.size(), [&](std::size_t k) {
    const Reaction& grain = reactions_[k];
    const Block& b = blocks_[k];
    const double push =  // [mol/s] released by the change of pressure
        grain.body == System::no_body ? 0.0 : grain.by_pressure * pressure[grain.body];
    const double h = r[grain.id] - gamma_ * push * grain.oxygen_heat;
    const double d = r[delta + k] + gamma_ * 2.0 / grain.iron * push;
    z[grain.id] = b.a * h + b.b * d;
    z[delta + k] = b.c * h + b.d * d;
  });
  for (const WallProfile& wall : system_.profiles) {
    const std::size_t cells = wall.conductance.size(), first = wall.first_cell;
    const auto right = r.subspan(system_.cell_begin() + first, cells);
    const auto left = z.subspan(system_.cell_begin() + first, cells);
    for (std::size_t j = 0; j < cells; ++j)
      left[j] = right[j] - (j > 0 ? wall_lower_[first + j] * left[j - 1] : 0.0);
    for (std::size_t j = cells; j-- > 0;)
      left[j] = (left[j] - (j + 1 < cells ? wall_upper_[first + j] * left[j + 1] : 0.0)) /
                wall_pivot_[first + j];
  }
}

}  // namespace pmr::coupling
