#include "coupling/flux_rates.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "chemistry/gas.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

enum class Kind { inert, redox, wall, surroundings, gas };

Kind kind_of(const System& system, std::size_t node) {
  const Nodes& nodes = *system.nodes;
  if (node < nodes.solids())
    return system.solid[node].material != nullptr && system.solid[node].material->redox
               ? Kind::redox
               : Kind::inert;
  if (node < nodes.surroundings()) return Kind::wall;
  return node == nodes.surroundings() ? Kind::surroundings : Kind::gas;
}

// Heat `q` [W] from node a to node b by one path, put where the books want it.
struct Sorter {
  const System& system;
  const std::vector<Kind>& kind;  // by node
  Fluxes rates{};

  void add(std::size_t a, std::size_t b, double q, double& path) {
    const Kind from = kind[a], to = kind[b];
    if (from == Kind::redox && to == Kind::inert) path -= q;
    if (from == Kind::inert && to == Kind::redox) path += q;
    const bool from_particle = from == Kind::inert || from == Kind::redox;
    if (from_particle && to == Kind::wall) rates.to_walls += q;
    if (system.stores[a] != 0 && system.stores[b] == 0) leave(to, q);
    if (system.stores[b] != 0 && system.stores[a] == 0) leave(from, -q);
  }

 private:
  void leave(Kind reservoir, double q) {
    (reservoir == Kind::wall ? rates.to_outside : rates.to_surroundings) += q;
  }
};

void add_to(Fluxes& sum, Fluxes part) {
  std::vector<double*> places;
  for_each_flux(sum, [&](const char*, const char*, double& flux) { places.push_back(&flux); });
  std::size_t k = 0;
  for_each_flux(part, [&](const char*, const char*, double& flux) { *places[k++] += flux; });
}

// Sums what visit(item, sorter) sorts over all items, block by block in order: the same bits on any
// number of threads.
template <class Visit>
Fluxes sort_all(const System& system, const std::vector<Kind>& kind, std::size_t items,
                const Visit& visit) {
  std::vector<Fluxes> part((items + block_size - 1) / block_size);
  parallel_blocks(items, [&](std::size_t first, std::size_t last) {
    Sorter sorter{system, kind};
    for (std::size_t k = first; k < last; ++k) visit(k, sorter);
    part[first / block_size] = sorter.rates;
  });
  Fluxes sum{};
  for (const Fluxes& p : part) add_to(sum, p);
  return sum;
}

void sort_link(const System& system, const Evaluation& at, std::size_t k, Sorter& sorter) {
  const HeatLink& link = system.links[k];
  const double fall = at.temperature[link.a] - at.temperature[link.b];
  sorter.add(link.a, link.b, link.contact * fall, sorter.rates.contact);
  sorter.add(link.a, link.b, link.gap * fall, sorter.rates.gap);
}

// Each pair of factors once: at its inert particle, if it is one with a reacting particle; at the
// particle, if it is one with a wall or the surroundings; else above the diagonal.
void sort_radiation(const System& system, const Evaluation& at, const std::vector<double>& is_redox,
                    std::size_t a, Sorter& sorter) {
  const RoundedRows& g = system.exchange;
  const std::size_t solids = system.nodes->solids();
  const std::vector<double>& E = at.emission;
  const auto columns = g.columns(a);
  const auto factors = g.values(a);
  for (std::size_t k = columns.size(); k-- > 0 && columns[k] >= std::max(a, solids);)
    sorter.add(a, columns[k], factors[k] * (E[a] - E[columns[k]]), sorter.rates.radiation);
  if (sorter.kind[a] == Kind::inert)
    sorter.rates.radiation +=
        sum_row(g, a, [&](std::uint32_t j, double G) { return G * is_redox[j] * (E[a] - E[j]); });
}

void add_walls(const System& system, const Evaluation& at, Fluxes& rates) {
  for (const WallProfile& wall : system.profiles) {
    const std::size_t last = wall.conductance.size() - 1;
    rates.to_outside += wall.area * wall.conductance[last] *
                        (at.wall_temperature[wall.first_cell + last] -
                         system.nodes->columns[wall.surface].outside_temperature);
  }
}

void sort_reaction(const System& system, const Evaluation& at, std::size_t k, Fluxes& rates) {
  const Reactant& grain = system.reactants[k];
  const double release = at.release[k];
  rates.oxygen_released += release;
  rates.reaction += 2.0 * release * at.bond[k];
  if (system.body_of(grain.id) != System::no_body) return;
  rates.oxygen_to_air += release;
  rates.gas_energy_out += release * chemistry::oxygen_heat(at.temperature[grain.id]).enthalpy;
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
}

}  // namespace

Fluxes flux_rates(const System& system, const Evaluation& at) {
  std::vector<Kind> kind(system.nodes->count());
  parallel_for(kind.size(), [&](std::size_t node) { kind[node] = kind_of(system, node); });
  Fluxes rates = sort_all(system, kind, system.links.size(),
                          [&](std::size_t k, Sorter& sorter) { sort_link(system, at, k, sorter); });
  if (!system.exchange.is_empty()) {
    std::vector<double> is_redox(kind.size());  // [1] as a factor
    parallel_for(kind.size(),
                 [&](std::size_t node) { is_redox[node] = kind[node] == Kind::redox ? 1.0 : 0.0; });
    add_to(rates,
           sort_all(system, kind, system.exchange.rows(), [&](std::size_t a, Sorter& sorter) {
             sort_radiation(system, at, is_redox, a, sorter);
           }));
  }
  add_walls(system, at, rates);
  add_to(rates, sort_all(system, kind, system.reactants.size(), [&](std::size_t k, Sorter& sorter) {
           sort_reaction(system, at, k, sorter.rates);
         }));
  if (system.bodies() > 0) add_gas(at.gas, rates);
  const Nodes& nodes = *system.nodes;
  rates.heat_exchanged = parallel_sum(nodes.particles, [&](std::size_t id) {
    double heat = 0.0;
    for (std::size_t node = id; node < nodes.solids(); node += nodes.particles)
      heat += at.heat[node];
    return std::abs(heat);
  });
  return rates;
}

}  // namespace pmr::coupling
