// The gas and the sums that the books hold the network to, in a solution of (I - gamma J) x = b.
#include "coupling/linearisation.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

Linearisation::Sums Linearisation::sums(std::span<const double> v) const {
  const std::size_t delta = system_.delta_begin(), gas = system_.gas_begin();
  double energy = parallel_sum(capacity_.size(), [&](std::size_t id) { return v[id]; });
  for (std::size_t cell = system_.cell_begin(); cell < gas; ++cell) energy += v[cell];
  for (std::size_t body = 0; body < system_.bodies(); ++body) energy += v[gas + 3 * body + 2];
  const double taken_out = parallel_sum(
      reactions_.size(), [&](std::size_t k) { return 0.5 * reactions_[k].iron * v[delta + k]; });
  return {energy, -taken_out};
}

// Heat between bodies cancels; what is left crosses the border: to reservoirs, to the outside of
// walls, by pump, leak and vent, to the open air.
Linearisation::Sums Linearisation::sums_of_product(std::span<const double> v,
                                                   const std::vector<double>& change) const {
  double energy = -parallel_sum(change.size(), [&](std::size_t i) {
    const double out = conduction_out_[i] + exchange_out_[i] * emission_slope_[i];  // [W/K]
    return system_.stores[i] != 0 ? out * change[i] : 0.0;
  });
  for (const WallProfile& wall : system_.profiles) {
    const std::size_t last = wall.first_cell + wall.conductance.size() - 1;
    energy -=
        wall.area * wall.conductance.back() * v[system_.cell_begin() + last] / cell_capacity_[last];
  }
  const Eigen::VectorXd gas = gas_part(v);
  const std::vector<double> pressure = pressure_changes(gas);
  // [W] into open air, [mol/s] in all
  const auto released =
      parallel_bins(reactions_.size(), 2, [&](std::size_t k, std::vector<double>& out) {
        const Reaction& r = reactions_[k];
        const Given given = given_change(r, k, v, change, pressure);
        if (r.body == System::no_body) out[0] += given.energy;
        out[1] += given.oxygen;
      });
  const Eigen::VectorXd by_itself = gas_jacobian_ * gas;
  for (Eigen::Index first = 0; first < by_itself.size(); first += 3) energy += by_itself[first + 2];
  return {energy - released[0], -released[1]};
}

Eigen::VectorXd Linearisation::gas_product(std::span<const double> v,
                                           const std::vector<double>& change) const {
  const Eigen::VectorXd gas = gas_part(v);
  const std::vector<double> pressure = pressure_changes(gas), film = film_changes(gas, change);
  const auto given =
      given_by_bed(v, change, pressure, [](const Reaction&, std::size_t, const Given&) {});
  const std::size_t node = system_.nodes->gas();  // takes no part in radiation
  const double to_chamber =
      sum_row(system_.conductance, node, [&](std::uint32_t j, double w) { return w * change[j]; }) -
      conduction_sum_[node] * change[node];
  return gas_rows(gas, given, film, to_chamber);
}

// The gas' rows of J by the gas' unknowns, the particles as they are.
Eigen::MatrixXd Linearisation::gas_by_gas() const {
  Eigen::MatrixXd rows = gas_jacobian_;
  const auto given = parallel_bins(reactions_.size(), 2 * system_.bodies(),
                                   [&](std::size_t k, std::vector<double>& sums) {
                                     const Reaction& r = reactions_[k];
                                     sums[2 * r.body] += r.by_pressure;
                                     sums[2 * r.body + 1] += r.by_pressure * r.oxygen_heat;
                                   });
  for (std::size_t body = 0; body < system_.bodies(); ++body) {
    const auto first = static_cast<Eigen::Index>(3 * body);
    rows.block<1, 3>(first, first) += given[2 * body] * pressure_row_[body].transpose();
    rows.block<1, 3>(first + 2, first) += given[2 * body + 1] * pressure_row_[body].transpose() -
                                          heat_loss(body) * temperature_row_[body].transpose();
  }
  return rows;
}

double Linearisation::heat_loss(std::size_t body) const {
  return body < system_.pores.layers.size() ? system_.pores.layers[body].film
                                            : conduction_sum_[system_.nodes->gas()];
}

// How the sums answer to 1 K more of all particles and to 1 more of all deltas (as warm as before),
// the gas following.
void Linearisation::prepare_sums(double gamma) {
  sums_gamma_ = gamma;
  warmth_.assign(system_.size(), 0.0);
  bound_.assign(system_.size(), 0.0);
  parallel_for(capacity_.size(), [&](std::size_t id) {
    if (system_.stores[id] != 0) warmth_[id] = capacity_[id];
  });
  parallel_for(reactions_.size(), [&](std::size_t k) {
    bound_[reactions_[k].id] = reactions_[k].delta_slope;
    bound_[system_.delta_begin() + k] = 1.0;
  });
  if (system_.bodies() > 0) {
    const auto size = static_cast<Eigen::Index>(3 * system_.bodies());
    gas_rows_.compute(Eigen::MatrixXd::Identity(size, size) - gamma * gas_by_gas());
  }
  Eigen::Matrix2d response = Eigen::Matrix2d::Identity();
  const auto answer = [&](std::vector<double>& move) {
    std::vector<double> change;
    temperature_changes(move, change);
    solve_gas(gamma, std::vector<double>(move.size(), 0.0), move, change);
    return Sums(sums(move) - gamma * sums_of_product(move, change));
  };
  response.col(0) = answer(warmth_);
  if (!reactions_.empty()) response.col(1) = answer(bound_);
  sums_inverse_ = response.inverse();
}

// Solves the gas' rows of (I - gamma J) x = b for the gas; `change` follows x.
void Linearisation::solve_gas(double gamma, std::span<const double> b, std::span<double> x,
                              std::vector<double>& change) const {
  if (system_.bodies() == 0) return;
  const Eigen::VectorXd missing = gas_part(b) - (gas_part(x) - gamma * gas_product(x, change));
  const Eigen::VectorXd more = gas_rows_.solve(missing);
  for (Eigen::Index k = 0; k < more.size(); ++k)
    x[system_.gas_begin() + static_cast<std::size_t>(k)] += more[k];
  if (system_.closed) change[system_.nodes->gas()] += temperature_row_.back().dot(more.tail<3>());
}

void Linearisation::keep_sums(double gamma, std::span<const double> b, std::span<double> x) {
  if (gamma != sums_gamma_) prepare_sums(gamma);
  std::vector<double> change;
  temperature_changes(x, change);
  solve_gas(gamma, b, x, change);
  const Sums missing = sums(b) - (sums(x) - gamma * sums_of_product(x, change));
  const Sums part = sums_inverse_ * missing;
  parallel_for(x.size(),
               [&](std::size_t i) { x[i] += part[0] * warmth_[i] + part[1] * bound_[i]; });
}

}  // namespace pmr::coupling
