#include "coupling/flux_rates.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "chemistry/gas.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// Puts heat where the books want it.
struct Sorter {
  explicit Sorter(const System& s)
      : system(s), rates{{}, empty_breakdown(s.groups)}, received(s.groups.species, 0.0) {}

  // Heat `q` [W] from node a to node b by one path.
  void add(std::size_t a, std::size_t b, double q, std::vector<double>& path) {
    const std::size_t from = system.group[a], to = system.group[b];
    if (from < to) path[system.groups.pair(from, to)] += q;
    if (from > to) path[system.groups.pair(to, from)] -= q;
    if (system.stores[a] != 0 && system.stores[b] == 0) leave(to, q);
    if (system.stores[b] != 0 && system.stores[a] == 0) leave(from, -q);
  }
  // Heat `q` [W] from a species to another.
  void add_between(std::size_t from, std::size_t to, double q, std::vector<double>& path) const {
    path[system.groups.pair(std::min(from, to), std::max(from, to))] += from < to ? q : -q;
  }

  const System& system;
  FluxRates rates;
  std::vector<double> received;  // [W] by species, from one row

 private:
  void leave(std::size_t reservoir, double q) {
    (reservoir == system.groups.walls() ? rates.sums.to_outside : rates.sums.to_surroundings) += q;
  }
};

void add_to(FluxRates& sum, FluxRates part) {
  std::vector<double*> places;
  const auto place = [&](const char*, const char*, double& flux) { places.push_back(&flux); };
  const auto place_all = [&](const char*, const char*, std::vector<double>& values) {
    for (double& flux : values) places.push_back(&flux);
  };
  for_each_flux(sum.sums, place);
  for_each_part(sum.by, place_all);
  std::size_t k = 0;
  for_each_flux(part.sums,
                [&](const char*, const char*, const double& flux) { *places[k++] += flux; });
  for_each_part(part.by, [&](const char*, const char*, const std::vector<double>& values) {
    for (const double flux : values) *places[k++] += flux;
  });
}

// Adds what visit(item, sorter) sorts over all items, block by block in order: the same bits on
// any number of threads.
template <class Visit>
void sort_all(const System& system, std::size_t items, FluxRates& sum, const Visit& visit) {
  std::vector<FluxRates> part((items + block_size - 1) / block_size);
  parallel_blocks(items, [&](std::size_t first, std::size_t last) {
    Sorter sorter(system);
    for (std::size_t k = first; k < last; ++k) visit(k, sorter);
    part[first / block_size] = std::move(sorter.rates);
  });
  for (FluxRates& p : part) add_to(sum, std::move(p));
}

void sort_link(const System& system, const Evaluation& at, std::size_t k, Sorter& sorter) {
  const HeatLink& link = system.links[k];
  const double fall = at.temperature[link.a] - at.temperature[link.b];
  sorter.add(link.a, link.b, link.contact * fall, sorter.rates.by.contact);
  sorter.add(link.a, link.b, link.gap * fall, sorter.rates.by.gap);
}

// Each pair of factors once: with a wall or the surroundings at the particle, or above the
// diagonal; with a particle of another species at that of the rarer species.
void sort_radiation(const System& system, const Evaluation& at, std::size_t a, Sorter& sorter) {
  const RoundedRows& g = system.exchange;
  const std::size_t solids = system.nodes->solids();
  const std::vector<double>& E = at.emission;
  const auto columns = g.columns(a);
  const auto factors = g.values(a);
  std::size_t end = columns.size();
  for (; end > 0 && columns[end - 1] >= solids; --end)
    if (const std::size_t b = columns[end - 1]; b >= a)
      sorter.add(a, b, factors[end - 1] * (E[a] - E[b]), sorter.rates.by.radiation);
  if (a >= solids) return;
  const std::size_t own = system.group[a];
  if (system.rarity[own] + 1 == system.groups.species) return;
  std::fill(sorter.received.begin(), sorter.received.end(), 0.0);
  for (std::size_t k = 0; k < end; ++k)
    sorter.received[system.group[columns[k]]] += factors[k] * (E[columns[k]] - E[a]);
  for (std::size_t other = 0; other < system.groups.species; ++other)
    if (system.rarity[other] > system.rarity[own])
      sorter.add_between(other, own, sorter.received[other], sorter.rates.by.radiation);
}

// Heat that the gas of the pores gives to the solids in it, as their films share it out.
void sort_film(const System& system, const Evaluation& at, std::size_t node, Sorter& sorter) {
  const double q = system.pores.share[node] * at.film_heat[system.pores.layer_of[node]];
  const Groups& groups = system.groups;
  sorter.rates.by.gap[groups.pair(system.group[node], groups.gas())] -= q;
}

void add_walls(const System& system, const Evaluation& at, Fluxes& rates) {
  for (const WallProfile& wall : system.profiles) {
    const std::size_t last = wall.conductance.size() - 1;
    rates.to_outside += wall.area * wall.conductance[last] *
                        (at.wall_temperature[wall.first_cell + last] -
                         system.nodes->columns[wall.surface].outside_temperature);
  }
}

void sort_reaction(const System& system, const Evaluation& at, std::size_t k, FluxRates& rates) {
  const Reactant& grain = system.reactants[k];
  const double release = at.release[k], T = at.temperature[grain.id];
  const double enthalpy = release * chemistry::oxygen_heat(T).enthalpy;
  const double bond = 2.0 * release * at.bond[k];
  const std::size_t species = system.group[grain.id];
  rates.sums.oxygen_released += release;
  rates.sums.grain_turnover += std::abs(release);
  rates.sums.gas_turnover += std::abs(release) * chemistry::enthalpy_from_zero(T);
  rates.sums.reaction += bond;
  rates.by.released[species] += release;
  rates.by.carried[species] += enthalpy;
  rates.by.reaction[species] += bond;
  if (system.zone_of(grain.id) != System::open_air) {
    rates.sums.oxygen_turnover += std::abs(release);
    return;
  }
  rates.sums.oxygen_to_air += release;
  rates.sums.gas_energy_out += enthalpy;
}

void add_gas(const GasRates& gas, Fluxes& rates) {
  rates.oxygen_pumped += gas.oxygen_pumped;
  rates.nitrogen_pumped += gas.nitrogen_pumped;
  rates.oxygen_leaked += gas.oxygen_leaked;
  rates.nitrogen_leaked += gas.nitrogen_leaked;
  rates.oxygen_to_air += gas.oxygen_to_air;
  rates.nitrogen_to_air += gas.nitrogen_to_air;
  rates.gas_energy_out += gas.energy_out;
  rates.gas_energy_in += gas.energy_in;
  rates.pump_work += gas.pump_power;
  const double oxygen =
      std::abs(gas.oxygen_pumped) + std::abs(gas.oxygen_leaked) + std::abs(gas.oxygen_to_air);
  const double nitrogen =
      std::abs(gas.nitrogen_pumped) + std::abs(gas.nitrogen_leaked) + std::abs(gas.nitrogen_to_air);
  rates.oxygen_turnover += oxygen;
  rates.nitrogen_turnover += nitrogen;
  rates.gas_turnover += (oxygen + nitrogen) * chemistry::enthalpy_from_zero(gas.temperature);
}

// Sum of |heat received| by whatever stores heat [W]: what two of them exchange counts at both.
double heat_exchanged(const System& system, const Evaluation& at) {
  const Nodes& nodes = *system.nodes;
  double sum = parallel_sum(nodes.particles, [&](std::size_t id) {
    double heat = 0.0;
    for (std::size_t node = id; node < nodes.solids(); node += nodes.particles)
      heat += at.heat[node];
    return std::abs(heat);
  });
  for (const WallProfile& wall : system.profiles) sum += std::abs(at.heat[wall.node]);
  for (const double film : at.film_heat) sum += std::abs(film);
  return system.closed ? sum + std::abs(at.heat[nodes.gas()]) : sum;
}

}  // namespace

FluxRates flux_rates(const System& system, const Evaluation& at) {
  FluxRates rates{{}, empty_breakdown(system.groups)};
  sort_all(system, system.links.size(), rates,
           [&](std::size_t k, Sorter& sorter) { sort_link(system, at, k, sorter); });
  sort_all(system, system.exchange.rows(), rates,
           [&](std::size_t a, Sorter& sorter) { sort_radiation(system, at, a, sorter); });
  sort_all(system, system.pores.share.size(), rates,
           [&](std::size_t node, Sorter& sorter) { sort_film(system, at, node, sorter); });
  add_walls(system, at, rates.sums);
  sort_all(system, system.reactants.size(), rates,
           [&](std::size_t k, Sorter& sorter) { sort_reaction(system, at, k, sorter.rates); });
  if (system.zones() > 0) add_gas(at.gas, rates.sums);
  rates.sums.heat_exchanged = heat_exchanged(system, at);
  return rates;
}

}  // namespace pmr::coupling
