// The sums that the books hold the network to, in a solution of (I - gamma J) x = b.
#include "coupling/linearisation.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {

Linearisation::Sums Linearisation::sums(std::span<const double> v) const {
  const std::size_t delta = system_.delta_begin(), gas = system_.gas_begin();
  double energy = parallel_sum(capacity_.size(), [&](std::size_t id) { return v[id]; });
  for (std::size_t cell = system_.cell_begin(); cell < gas; ++cell) energy += v[cell];
  const double taken_out = parallel_sum(
      reactions_.size(), [&](std::size_t k) { return 0.5 * reactions_[k].iron * v[delta + k]; });
  return system_.closed ? Sums(energy + v[gas + 2], -taken_out, v[gas])
                        : Sums(energy, -taken_out, 0.0);
}

// Heat between bodies cancels; what is left crosses the border: to reservoirs, to the outside of
// walls, by pump and leak, to the open air.
Linearisation::Sums Linearisation::sums_of_product(std::span<const double> v) const {
  std::vector<double> change;
  temperature_changes(v, change);
  double energy = -parallel_sum(change.size(), [&](std::size_t i) {
    const double out = conduction_out_[i] + exchange_out_[i] * emission_slope_[i];  // [W/K]
    return system_.stores[i] != 0 ? out * change[i] : 0.0;
  });
  for (const WallProfile& wall : system_.profiles) {
    const std::size_t last = wall.first_cell + wall.conductance.size() - 1;
    energy -=
        wall.area * wall.conductance.back() * v[system_.cell_begin() + last] / cell_capacity_[last];
  }
  const std::size_t gas = system_.gas_begin();
  const Vec3 dgas = system_.closed ? Vec3(v[gas], v[gas + 1], v[gas + 2]) : Vec3(Vec3::Zero());
  const double pressure = pressure_row_.dot(dgas);
  const auto released = parallel_sum(
      reactions_.size(), Eigen::Vector2d(0.0, 0.0), [&](std::size_t k) {  // [W], [mol/s]
        const Reaction& r = reactions_[k];
        const double dT = change[r.id];
        const double release =
            r.by_T * dT + r.by_delta * v[system_.delta_begin() + k] + r.by_pressure * pressure;
        return Eigen::Vector2d(release * r.oxygen_heat + r.release * r.oxygen_capacity * dT,
                               release);
      });
  if (!system_.closed) return {energy - released[0], -released[1], 0.0};
  const Vec3 border = gas_jacobian_ * dgas;
  return {energy + border[2], -released[1], released[1] + border[0]};
}

// How the sums answer to 1 K more of all particles, 1 more of all deltas (as warm as before) and 1
// mol more of free oxygen.
void Linearisation::prepare_sums(double gamma) {
  sums_gamma_ = gamma;
  warmth_.assign(system_.size(), 0.0);
  bound_.assign(system_.size(), 0.0);
  free_.assign(system_.size(), 0.0);
  parallel_for(capacity_.size(), [&](std::size_t id) {
    if (system_.stores[id] != 0) warmth_[id] = capacity_[id];
  });
  parallel_for(reactions_.size(), [&](std::size_t k) {
    bound_[reactions_[k].id] = reactions_[k].delta_slope;
    bound_[system_.delta_begin() + k] = 1.0;
  });
  if (system_.closed) free_[system_.gas_begin()] = 1.0;
  Mat3 response = Mat3::Identity();
  response.col(0) = sums(warmth_) - gamma * sums_of_product(warmth_);
  if (!reactions_.empty()) response.col(1) = sums(bound_) - gamma * sums_of_product(bound_);
  if (system_.closed) response.col(2) = sums(free_) - gamma * sums_of_product(free_);
  sums_inverse_ = response.inverse();
}

void Linearisation::keep_sums(double gamma, std::span<const double> b, std::span<double> x) {
  if (gamma != sums_gamma_) prepare_sums(gamma);
  const Sums missing = sums(b) - (sums(x) - gamma * sums_of_product(x));
  const Sums part = sums_inverse_ * missing;
  parallel_for(x.size(), [&](std::size_t i) {
    x[i] += part[0] * warmth_[i] + part[1] * bound_[i] + part[2] * free_[i];
  });
}

}  // namespace pmr::coupling
