#include "coupling/linearisation.hpp"

#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

std::vector<double> capacities(const System& system, std::span<const double> y,
                               const Evaluation& at) {
  std::vector<double> capacity(system.nodes->solids(), 1.0);
  parallel_for(capacity.size(), [&](std::size_t id) {
    if (system.stores[id] != 0)
      capacity[id] =
          chemistry::heat_capacity(system.solid[id], at.temperature[id], delta_of(system, y, id));
  });
  return capacity;
}

std::vector<double> temperature_changes(const Linearisation& J, std::span<const double> v) {
  const System& system = *J.system;
  std::vector<double> change(system.nodes->count(), 0.0);
  parallel_for(J.capacity.size(), [&](std::size_t id) {
    if (system.stores[id] == 0) return;
    double energy = v[id];
    const std::uint32_t k = system.reactant_of[id];
    if (k != System::no_reactant)
      energy -= J.reactions[k].delta_slope * v[system.delta_begin() + k];
    change[id] = energy / J.capacity[id];
  });
  for (const WallProfile& wall : system.profiles)
    change[wall.node] = v[system.cell_begin() + wall.first_cell] / wall.capacity[0];
  if (system.closed) {
    const double* const chamber = v.data() + system.chamber_begin();
    change[system.nodes->gas()] =
        J.gas.temperature.back().dot(Vec3(chamber[0], chamber[1], chamber[2]));
  }
  return change;
}

// [W] that a node receives by links, by changes of temperature [K] of all.
double link_change(const Linearisation& J, std::size_t i, const std::vector<double>& change) {
  return sum_row(J.system->conductance, i,
                 [&](std::uint32_t j, double w) { return w * change[j]; }) -
         J.heat.sums->conduction[i] * change[i];
}

// [W] that a node receives by radiation, by changes of emission [W/m2] of all.
double exchange_change(const Linearisation& J, std::size_t i,
                       const std::vector<double>& emission_change) {
  return sum_row(J.system->exchange, i,
                 [&](std::uint32_t j, double G) { return G * emission_change[j]; }) -
         J.heat.sums->exchange[i] * emission_change[i];
}

// [W] that each node receives by links and radiation.
std::vector<double> heat_changes(const Linearisation& J, const std::vector<double>& change) {
  std::vector<double> heat(change.size()), emission_change(change.size());
  parallel_for(heat.size(),
               [&](std::size_t i) { emission_change[i] = J.heat.emission[i] * change[i]; });
  const std::size_t radiating = J.system->exchange.rows();
  parallel_for(heat.size(), [&](std::size_t i) {
    heat[i] = link_change(J, i, change);
    if (i < radiating) heat[i] += exchange_change(J, i, emission_change);
  });
  return heat;
}

// [W] from the gas of each layer of pores to its particles.
std::vector<double> film_changes(const Linearisation& J, const Changes& change) {
  const PoreSpace& pores = J.system->pores;
  auto heat = layer_means(pores, [&](std::size_t node) { return change.temperature[node]; });
  for (std::size_t k = 0; k < heat.size(); ++k) {
    const double dT =
        J.gas.temperature[k].dot(change.gas.segment<3>(static_cast<Eigen::Index>(3 * k)));
    heat[k] = pores.layers[k].film * (dT - heat[k]);
  }
  return heat;
}

// What the bed gives to each gas zone, three figures each; write(reaction, k, given) is told of
// every reactant.
template <class Write>
std::vector<double> given_by_bed(const Linearisation& J, const Changes& change,
                                 const Write& write) {
  return parallel_bins(J.reactions.size(), 3 * J.system->zones(),
                       [&](std::size_t k, std::vector<double>& sums) {
                         const ReactionSlopes& r = J.reactions[k];
                         const Given given = given_change(J, k, change);
                         write(r, k, given);
                         if (r.zone == System::open_air) return;
                         sums[3 * r.zone] += given.oxygen;
                         sums[3 * r.zone + 2] += given.energy;
                       });
}

void wall_product(const System& system, const std::vector<double>& heat, std::span<const double> v,
                  std::span<double> jv) {
  for (const WallProfile& wall : system.profiles) {
    const std::size_t cells = wall.conductance.size();
    const std::size_t first = system.cell_begin() + wall.first_cell;
    double inflow = heat[wall.node];
    for (std::size_t j = 0; j < cells; ++j) {
      const double here = v[first + j] / wall.capacity[j];
      const double next = j + 1 < cells ? v[first + j + 1] / wall.capacity[j + 1] : 0.0;
      const double outflow = wall.area * wall.conductance[j] * (here - next);
      jv[first + j] = inflow - outflow;
      inflow = outflow;
    }
  }
}

// The gas' rows of J v, from their parts; `to_chamber` [W] comes by the chamber's films.
Eigen::VectorXd gas_rows(const Linearisation& J, const Eigen::VectorXd& gas,
                         const std::vector<double>& given, const std::vector<double>& film,
                         double to_chamber) {
  Eigen::VectorXd rows = J.gas.rates * gas;
  for (std::size_t k = 0; k < given.size(); ++k) rows[static_cast<Eigen::Index>(k)] += given[k];
  for (std::size_t k = 0; k < film.size(); ++k)
    rows[static_cast<Eigen::Index>(3 * k + 2)] -= film[k];
  if (J.system->closed) rows[rows.size() - 1] += to_chamber;
  return rows;
}

double film_loss(const Linearisation& J, std::size_t zone) {  // [W/K] of a gas zone to solids
  return zone < J.system->pores.layers.size() ? J.system->pores.layers[zone].film
                                              : J.heat.sums->conduction[J.system->nodes->gas()];
}

}  // namespace

Linearisation::Linearisation(const System& of, const RowSums& sums, double t,
                             std::span<const double> y, const Evaluation& at)
    : system(&of),
      heat(sums, at),
      capacity(capacities(of, y, at)),
      reactions(reaction_slopes(of, y, at)),
      gas(of, t, y) {}

Changes::Changes(const Linearisation& J, std::span<const double> change)
    : v(change),
      temperature(temperature_changes(J, v)),
      gas(gas_part(*J.system, v)),
      pressure(pressure_changes(J.gas, gas)) {}

void Changes::follow_gas(const Linearisation& J, const Eigen::VectorXd& more) {
  gas = gas_part(*J.system, v);
  pressure = pressure_changes(J.gas, gas);
  if (J.system->closed)
    temperature[J.system->nodes->gas()] += J.gas.temperature.back().dot(more.tail<3>());
}

std::vector<double> pressure_changes(const GasSlopes& slopes, const Eigen::VectorXd& gas) {
  std::vector<double> change(slopes.pressure.size());
  for (std::size_t zone = 0; zone < change.size(); ++zone)
    change[zone] = slopes.pressure[zone].dot(gas.segment<3>(static_cast<Eigen::Index>(3 * zone)));
  return change;
}

Given given_change(const Linearisation& J, std::size_t k, const Changes& change) {
  const ReactionSlopes& r = J.reactions[k];
  const double dT = change.temperature[r.id];
  const double release =
      r.by_T * dT + r.by_delta * change.v[J.system->delta_begin() + k] +
      (r.zone == System::open_air ? 0.0 : r.by_pressure * change.pressure[r.zone]);
  return {release, release * r.oxygen_heat + r.release * r.oxygen_capacity * dT};
}

void product(const Linearisation& J, std::span<const double> v, std::span<double> jv) {
  const System& system = *J.system;
  const PoreSpace& pores = system.pores;
  const Changes change(J, v);
  const std::vector<double> heat = heat_changes(J, change.temperature);
  const std::vector<double> film = film_changes(J, change);
  parallel_for(J.capacity.size(), [&](std::size_t id) {
    jv[id] = system.stores[id] != 0 ? heat[id] : 0.0;
    if (id < pores.share.size()) jv[id] += pores.share[id] * film[pores.layer_of[id]];
  });
  const auto given =
      given_by_bed(J, change, [&](const ReactionSlopes& r, std::size_t k, const Given& one) {
        jv[r.id] -= one.energy;
        jv[system.delta_begin() + k] = 2.0 * one.oxygen / r.formula_units;
      });
  wall_product(system, heat, v, jv);
  const Eigen::VectorXd rows = gas_rows(J, change.gas, given, film, heat[system.nodes->gas()]);
  for (std::size_t k = 0; k < given.size(); ++k)
    jv[system.gas_begin() + k] = rows[static_cast<Eigen::Index>(k)];
}

Eigen::VectorXd gas_product(const Linearisation& J, const Changes& change) {
  const auto given =
      given_by_bed(J, change, [](const ReactionSlopes&, std::size_t, const Given&) {});
  // The gas takes no part in radiation.
  return gas_rows(J, change.gas, given, film_changes(J, change),
                  link_change(J, J.system->nodes->gas(), change.temperature));
}

Eigen::MatrixXd gas_by_gas(const Linearisation& J, double gamma) {
  const std::size_t zones = J.system->zones();
  Eigen::MatrixXd rows = J.gas.rates;
  const auto given =
      parallel_bins(J.reactions.size(), 2 * zones, [&](std::size_t k, std::vector<double>& sums) {
        const ReactionSlopes& r = J.reactions[k];
        const double by_pressure = r.by_pressure / DeltaRow(r, gamma).pivot;
        sums[2 * r.zone] += by_pressure;
        sums[2 * r.zone + 1] += by_pressure * r.oxygen_heat;
      });
  for (std::size_t zone = 0; zone < zones; ++zone) {
    const auto first = static_cast<Eigen::Index>(3 * zone);
    rows.block<1, 3>(first, first) += given[2 * zone] * J.gas.pressure[zone].transpose();
    rows.block<1, 3>(first + 2, first) += given[2 * zone + 1] * J.gas.pressure[zone].transpose() -
                                          film_loss(J, zone) * J.gas.temperature[zone].transpose();
  }
  return rows;
}

}  // namespace pmr::coupling
