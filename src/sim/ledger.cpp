#include "sim/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupling/thermal_state.hpp"

namespace pmr::sim {
namespace {

// Part of what was turned over and of the share that counts of what is stored.
double relative(double residual, double turned_over, double share) {
  const double whole = turned_over + std::abs(share);
  if (residual == 0.0) return 0.0;
  return whole > 0.0 ? std::abs(residual) / whole : std::numeric_limits<double>::infinity();
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// How many particles hold oxygen [1], one at least. What each leaves is taken to be of either
// sign (assumed), so that their sum grows with the root of their number alone.
double grains(const State& state) {
  const auto holds_oxygen = [](double formula_units) { return formula_units > 0.0; };
  const auto count = [&](const Particles& p) {
    return std::count_if(p.formula_units.begin(), p.formula_units.end(), holds_oxygen);
  };
  const auto all = count(state.particles) + count(state.waiting);
  return std::max(1.0, static_cast<double>(all));
}

}  // namespace

Balance close_books(const Case& c, const State& state) {
  const Fluxes& f = state.fluxes;
  Balance b{};
  b.energy_residual = coupling::stored_energy(state) - state.opening.energy + f.to_outside +
                      f.to_surroundings + f.gas_energy_out - f.gas_energy_in + f.lost_energy;
  b.energy_relative = relative(b.energy_residual, f.heat_exchanged + f.gas_turnover,
                               kept_heat / energy_limit * state.opening.heat_content);

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
  const double bound = kept_oxygen / oxygen_limit / std::sqrt(grains(state)) * state.opening.oxygen;
  const double shut_in = kept_gas / oxygen_limit * (f.oxygen_closed_in + f.nitrogen_closed_in);
  b.oxygen_relative = std::max(
      {relative(solids, f.grain_turnover, bound),
       relative(gas, f.oxygen_turnover + f.oxygen_closed_in, shut_in),
       relative(b.nitrogen_residual, f.nitrogen_turnover + f.nitrogen_closed_in, shut_in)});

  b.inserted = state.opening.particles;
  b.alive = state.particles.size();
  b.lost = state.lost.size();
  b.waiting = state.waiting.size();
  b.caught = state.caught.size();
  return b;
}

std::vector<SpeciesBalance> species_books(const Case& c, const State& state) {
  const Breakdown& by = state.breakdown;
  const Groups groups{c.species.size()};
  const coupling::Holdings there = coupling::holdings(c, state.particles),
                           waiting = coupling::holdings(c, state.waiting);
  std::vector<SpeciesBalance> books;
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    double given = 0.0;  // [J] to all others
    for (std::size_t other = 0; other < groups.count(); ++other) {
      if (other == s) continue;
      const std::size_t pair = groups.pair(std::min(s, other), std::max(s, other));
      const double q = by.contact[pair] + by.gap[pair] + by.radiation[pair];
      given += s < other ? q : -q;
    }
    books.push_back({there.energy[s] + waiting.energy[s] - state.opening.species_energy[s] + given +
                         by.carried[s] + by.lost_energy[s],
                     there.oxygen[s] + waiting.oxygen[s] - state.opening.species_oxygen[s] +
                         by.released[s] + by.lost_oxygen[s]});
  }
  return books;
}

void book_losses(const Case& c, const coupling::Holdings& before, State& state) {
  const coupling::Holdings after = coupling::holdings(c, state.particles);
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    const double energy = before.energy[s] - after.energy[s];
    const double oxygen = before.oxygen[s] - after.oxygen[s];
    state.breakdown.lost_energy[s] += energy;
    state.breakdown.lost_oxygen[s] += oxygen;
    state.fluxes.lost_energy += energy;
    state.fluxes.lost_oxygen += oxygen;
  }
}

}  // namespace pmr::sim
