#include "coupling/sum_keeper.hpp"

#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

using Sums = Eigen::Vector2d;

Sums sums(const Linearisation& J, std::span<const double> v) {
  const System& system = *J.system;
  const std::size_t delta = system.delta_begin(), gas = system.gas_begin();
  double energy = parallel_sum(J.capacity.size(), [&](std::size_t id) { return v[id]; });
  for (std::size_t cell = system.cell_begin(); cell < gas; ++cell) energy += v[cell];
  for (std::size_t zone = 0; zone < system.zones(); ++zone) energy += v[gas + 3 * zone + 2];
  const double taken_out = parallel_sum(J.reactions.size(), [&](std::size_t k) {
    return 0.5 * J.reactions[k].formula_units * v[delta + k];
  });
  return {energy, -taken_out};
}

// The sums over J v. Heat between stores cancels; what is left crosses the border: to reservoirs,
// to the outside of walls, by pump, leak and vent, to the open air.
Sums sums_of_product(const Linearisation& J, const Changes& change) {
  const System& system = *J.system;
  double energy = -parallel_sum(change.temperature.size(), [&](std::size_t i) {
    return system.stores[i] != 0 ? J.heat.loss_to_reservoirs(i) * change.temperature[i] : 0.0;
  });
  for (const WallProfile& wall : system.profiles) {
    const std::size_t last = wall.conductance.size() - 1;
    energy -= wall.area * wall.conductance[last] *
              change.v[system.cell_begin() + wall.first_cell + last] / wall.capacity[last];
  }
  // [W] into open air, [mol/s] in all
  const auto released =
      parallel_bins(J.reactions.size(), 2, [&](std::size_t k, std::vector<double>& out) {
        const Given given = given_change(J, k, change);
        if (J.reactions[k].zone == System::open_air) out[0] += given.energy;
        out[1] += given.oxygen;
      });
  const Eigen::VectorXd by_itself = J.gas.rates * change.gas;
  for (Eigen::Index first = 0; first < by_itself.size(); first += 3) energy += by_itself[first + 2];
  return {energy - released[0], -released[1]};
}

// 1 K more of all particles.
std::vector<double> warmth(const Linearisation& J) {
  std::vector<double> move(J.system->size(), 0.0);
  parallel_for(J.capacity.size(), [&](std::size_t id) {
    if (J.system->stores[id] != 0) move[id] = J.capacity[id];
  });
  return move;
}

// 1 more of all deltas, as warm as before.
std::vector<double> bound_oxygen(const Linearisation& J) {
  std::vector<double> move(J.system->size(), 0.0);
  parallel_for(J.reactions.size(), [&](std::size_t k) {
    move[J.reactions[k].id] = J.reactions[k].delta_slope;
    move[J.system->delta_begin() + k] = 1.0;
  });
  return move;
}

}  // namespace

SumKeeper::SumKeeper(std::shared_ptr<const Linearisation> J, double gamma)
    : J_(std::move(J)), gamma_(gamma), warmth_(warmth(*J_)), bound_(bound_oxygen(*J_)) {
  if (J_->system->zones() > 0) {
    const auto size = static_cast<Eigen::Index>(3 * J_->system->zones());
    gas_rows_.compute(Eigen::MatrixXd::Identity(size, size) - gamma * gas_by_gas(*J_));
  }
  const std::vector<double> nothing(warmth_.size(), 0.0);
  Eigen::Matrix2d response = Eigen::Matrix2d::Identity();
  response.col(0) = residual(solve_gas(nothing, warmth_));
  if (!J_->reactions.empty()) response.col(1) = residual(solve_gas(nothing, bound_));
  inverse_ = response.inverse();
}

SumKeeper::Sums SumKeeper::residual(const Changes& change) const {
  return sums(*J_, change.v) - gamma_ * sums_of_product(*J_, change);
}

// Solves the gas' rows of (I - gamma J) x = b for the gas of x.
Changes SumKeeper::solve_gas(std::span<const double> b, std::span<double> x) const {
  const System& system = *J_->system;
  Changes change(*J_, x);
  if (system.zones() == 0) return change;
  const Eigen::VectorXd missing =
      gas_part(system, b) - (change.gas - gamma_ * gas_product(*J_, change));
  const Eigen::VectorXd more = gas_rows_.solve(missing);
  for (Eigen::Index k = 0; k < more.size(); ++k)
    x[system.gas_begin() + static_cast<std::size_t>(k)] += more[k];
  change.follow_gas(*J_, more);
  return change;
}

void SumKeeper::mend(std::span<const double> b, std::span<double> x) const {
  const Sums missing = sums(*J_, b) - residual(solve_gas(b, x));
  const Sums part = inverse_ * missing;
  parallel_for(x.size(),
               [&](std::size_t i) { x[i] += part[0] * warmth_[i] + part[1] * bound_[i]; });
}

}  // namespace pmr::coupling
