#include "sim/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/thermal_state.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::sim {
namespace {

// Part of a whole; a residual with nothing to compare it to counts as it is.
double relative(double residual, double whole) {
  return whole > 0.0 ? std::abs(residual) / whole : std::abs(residual);
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

Balance close_books(const Case& c, const State& state) {
  const Fluxes& f = state.fluxes;
  Balance b{};
  b.energy_residual = coupling::stored_energy(state) - state.opening.energy + f.to_outside +
                      f.to_surroundings + f.gas_energy_out - f.gas_energy_in + f.lost_energy;
  b.energy_relative = relative(b.energy_residual, f.heat_exchanged);

  const double solids = coupling::bound_oxygen(c, state.particles) +
                        coupling::bound_oxygen(c, state.waiting) - state.opening.oxygen +
                        f.oxygen_released + f.lost_oxygen;
  const double gas = state.gas.oxygen + sum_of(state.gas.pore_oxygen) -
                     (f.oxygen_released - f.oxygen_to_air + f.oxygen_closed_in + f.oxygen_leaked -
                      f.oxygen_pumped);
  b.nitrogen_residual =
      state.gas.nitrogen + sum_of(state.gas.pore_nitrogen) -
      (f.nitrogen_closed_in + f.nitrogen_leaked - f.nitrogen_pumped - f.nitrogen_to_air);
  b.oxygen_residual = std::abs(solids) > std::abs(gas) ? solids : gas;
  b.oxygen_relative = relative(std::max(std::abs(b.oxygen_residual), std::abs(b.nitrogen_residual)),
                               std::max(std::abs(f.oxygen_released), f.oxygen_closed_in));

  b.inserted = state.opening.particles;
  b.alive = state.particles.size();
  b.lost = state.lost.size();
  b.waiting = state.waiting.size();
  return b;
}

Holdings holdings(const Case& c, const Particles& particles) {
  return {parallel_sum(particles.size(), [&](std::size_t i) { return particles.enthalpy[i]; }),
          coupling::bound_oxygen(c, particles)};
}

void book_losses(const Case& c, const Holdings& before, State& state) {
  const Holdings after = holdings(c, state.particles);
  state.fluxes.lost_energy += before.energy - after.energy;
  state.fluxes.lost_oxygen += before.oxygen - after.oxygen;
}

}  // namespace pmr::sim
