#include "coupling/sum_keeper.hpp"

#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// [J] of all that stores energy.
double energy_of(const Linearisation& J, std::span<const double> v) {
  const System& system = *J.system;
  const std::size_t gas = system.gas_begin();
  double energy = parallel_sum(J.capacity.size(), [&](std::size_t id) { return v[id]; });
  for (std::size_t cell = system.cell_begin(); cell < gas; ++cell) energy += v[cell];
  for (std::size_t zone = 0; zone < system.zones(); ++zone) energy += v[gas + 3 * zone + 2];
  return energy;
}

// The same over J v [W]. Heat between stores cancels; what is left crosses the border: to
// reservoirs, to the outside of walls, by pump, leak and vent, to the open air.
double energy_of_product(const Linearisation& J, const Changes& change) {
  const System& system = *J.system;
  double energy = -parallel_sum(change.temperature.size(), [&](std::size_t i) {
    return system.stores[i] != 0 ? J.heat.loss_to_reservoirs(i) * change.temperature[i] : 0.0;
  });
  for (const WallProfile& wall : system.profiles) {
    const std::size_t last = wall.conductance.size() - 1;
    energy -= wall.area * wall.conductance[last] *
              change.v[system.cell_begin() + wall.first_cell + last] / wall.capacity[last];
  }
  energy -= parallel_sum(J.reactions.size(), [&](std::size_t k) {
    return J.reactions[k].zone == System::open_air ? given_change(J, k, change).energy : 0.0;
  });
  const Eigen::VectorXd by_itself = J.gas.rates * change.gas;
  for (Eigen::Index first = 0; first < by_itself.size(); first += 3) energy += by_itself[first + 2];
  return energy;
}

// 1 K more of all particles.
std::vector<double> warmth(const Linearisation& J) {
  std::vector<double> move(J.system->size(), 0.0);
  parallel_for(J.capacity.size(), [&](std::size_t id) {
    if (J.system->stores[id] != 0) move[id] = J.capacity[id];
  });
  return move;
}

}  // namespace

SumKeeper::SumKeeper(std::shared_ptr<const Linearisation> J, double gamma)
    : J_(std::move(J)), gamma_(gamma), warmth_(warmth(*J_)) {
  if (J_->system->zones() > 0) {
    const auto size = static_cast<Eigen::Index>(3 * J_->system->zones());
    gas_rows_.compute(Eigen::MatrixXd::Identity(size, size) - gamma * gas_by_gas(*J_, gamma));
  }
  const std::vector<double> nothing(warmth_.size(), 0.0);
  answer_ = energy_residual(solve_oxygen_and_gas(nothing, warmth_));
}

double SumKeeper::energy_residual(const Changes& change) const {
  return energy_of(*J_, change.v) - gamma_ * energy_of_product(*J_, change);
}

// Changes delta k by `more`, the particle as warm as before.
void SumKeeper::add_to_delta(std::size_t k, double more, std::span<double> x) const {
  x[J_->system->delta_begin() + k] += more;
  x[J_->reactions[k].id] += J_->reactions[k].delta_slope * more;
}

// Solves the rows of (I - gamma J) x = b of all deltas and of the gas for these, the temperatures
// of x as they are.
Changes SumKeeper::solve_oxygen_and_gas(std::span<const double> b, std::span<double> x) const {
  const System& system = *J_->system;
  Changes change(*J_, x);
  parallel_for(J_->reactions.size(), [&](std::size_t k) {
    const DeltaRow row(J_->reactions[k], gamma_);
    const std::size_t at = system.delta_begin() + k;
    const double missing = b[at] - x[at] + row.step * given_change(*J_, k, change).oxygen;
    add_to_delta(k, missing / row.pivot, x);
  });
  if (system.zones() == 0) return change;
  const Eigen::VectorXd missing =
      gas_part(system, b) - (change.gas - gamma_ * gas_product(*J_, change));
  const Eigen::VectorXd more = gas_rows_.solve(missing);
  for (Eigen::Index k = 0; k < more.size(); ++k)
    x[system.gas_begin() + static_cast<std::size_t>(k)] += more[k];
  change.follow_gas(*J_, more);
  const std::vector<double> pressure = pressure_changes(J_->gas, more);
  parallel_for(J_->reactions.size(), [&](std::size_t k) {
    const ReactionSlopes& r = J_->reactions[k];
    const DeltaRow row(r, gamma_);
    add_to_delta(k, row.step * r.by_pressure / row.pivot * pressure[r.zone], x);
  });
  return change;
}

void SumKeeper::mend(std::span<const double> b, std::span<double> x) const {
  const double missing = energy_of(*J_, b) - energy_residual(solve_oxygen_and_gas(b, x));
  const double part = answer_ != 0.0 ? missing / answer_ : 0.0;  // 0: no particle is left
  parallel_for(x.size(), [&](std::size_t i) { x[i] += part * warmth_[i]; });
}

}  // namespace pmr::coupling
