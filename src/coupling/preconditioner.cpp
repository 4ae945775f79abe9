// P ~ I - gamma J, factorised and solved block by block (see linearisation.hpp).
#include "coupling/linearisation.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

void Linearisation::prepare(double gamma) {
  gamma_ = gamma;
  factor_particles(gamma);
  factor_walls(gamma);
  if (system_.closed) factor_gas(gamma);
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
  // The gas by itself, its own heat loss included.
  Mat3 schur = Mat3::Identity() - gamma * gas_jacobian_;
  schur.row(2) += gamma * conduction_sum_[system_.nodes->gas()] * temperature_row_.transpose();
  // What the bed gives off per pressure, its own reply included.
  const Vec3 answer = parallel_sum(reactions_.size(), Vec3(Vec3::Zero()), [&](std::size_t k) {
    const Reaction& r = reactions_[k];
    const Eigen::Vector2d push(gamma * r.by_pressure * r.oxygen_heat,
                               -gamma * 2.0 / r.iron * r.by_pressure);
    const Block& b = blocks_[k];
    const Eigen::Vector2d reply(b.a * push[0] + b.b * push[1], b.c * push[0] + b.d * push[1]);
    return Vec3(Vec3(-r.by_pressure, 0.0, -r.by_pressure * r.oxygen_heat) + gas_slopes(r) * reply);
  });
  schur += gamma * answer * pressure_row_.transpose();
  gas_inverse_ = schur.inverse();
}

void Linearisation::precondition(std::span<const double> r, std::span<double> z) const {
  const std::size_t delta = system_.delta_begin(), gas = system_.gas_begin();
  parallel_for(capacity_.size(), [&](std::size_t id) { z[id] = r[id] / particle_pivot_[id]; });
  Vec3 dgas = Vec3::Zero();
  double pressure = 0.0;
  if (system_.closed) {
    dgas = Vec3(r[gas], r[gas + 1], r[gas + 2]);
    dgas += gamma_ * parallel_sum(reactions_.size(), Vec3(Vec3::Zero()), [&](std::size_t k) {
              const Block& b = blocks_[k];
              const double h = r[reactions_[k].id], d = r[delta + k];
              return Vec3(gas_slopes(reactions_[k]) *
                          Eigen::Vector2d(b.a * h + b.b * d, b.c * h + b.d * d));
            });
    dgas = gas_inverse_ * dgas;
    pressure = pressure_row_.dot(dgas);
    for (std::size_t k = 0; k < 3; ++k) z[gas + k] = dgas[static_cast<Eigen::Index>(k)];
  }
  parallel_for(reactions_.size(), [&](std::size_t k) {
    const Reaction& grain = reactions_[k];
    const Block& b = blocks_[k];
    const double h = r[grain.id] - gamma_ * grain.by_pressure * grain.oxygen_heat * pressure;
    const double d = r[delta + k] + gamma_ * 2.0 / grain.iron * grain.by_pressure * pressure;
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
