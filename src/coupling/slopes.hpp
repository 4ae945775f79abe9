// Slopes of the network's terms at one evaluated state: heat between nodes, reaction, gas.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "coupling/system.hpp"
#include "pmr/base/vec3.hpp"

namespace pmr::coupling {

// Sums over the rows of links and of exchange factors, which stand for an interval.
struct RowSums {
  explicit RowSums(const System& system);

  std::vector<double> conduction, exchange;          // [W/K], [m2] by node
  std::vector<double> conduction_out, exchange_out;  // [W/K], [m2] likewise, to reservoirs alone
};

// Heat that a node gives to all others, and to reservoirs, by its own temperature.
struct HeatSlopes {
  HeatSlopes(const RowSums& sums, const Evaluation& at);

  double loss(std::size_t node) const {  // [W/K]
    return sums->conduction[node] + sums->exchange[node] * emission[node];
  }
  double loss_to_reservoirs(std::size_t node) const {  // [W/K]
    return sums->conduction_out[node] + sums->exchange_out[node] * emission[node];
  }

  const RowSums* sums;
  std::vector<double> emission;  // [W/m2/K] 4 sigma T^3 by node
};

// Slopes of one reactant's release n [mol/s].
struct ReactionSlopes {
  // By enthalpy H and by delta at constant H: n by them, and what the oxygen's own warming adds to
  // n h_O2, n c_O2 dT/dH.
  struct ByUnknowns {
    double by_H, by_delta;  // [mol/s/J], [mol/s]
    double warming;         // [1/s]
  };
  ByUnknowns by_unknowns(double capacity) const {  // [J/K] of the reactant
    const double by_H = by_T / capacity;
    return {by_H, by_delta - by_H * delta_slope, release * oxygen_capacity / capacity};
  }

  double release, by_T, by_delta, by_pressure;  // n, dn/dT, dn/d(delta), dn/dp
  double oxygen_heat, oxygen_capacity;          // h_O2 [J/mol], c_O2 [J/mol/K]
  double delta_slope;                           // dH/d(delta) at constant T [J]
  double formula_units;                         // [mol]
  std::uint32_t id;
  std::size_t zone;  // of gas around it
};
std::vector<ReactionSlopes> reaction_slopes(const System& system, std::span<const double> y,
                                            const Evaluation& at);

// The gas by itself: flow through pores, pump, leak, vent.
struct GasSlopes {
  GasSlopes(const System& system, double t, std::span<const double> y);

  Eigen::MatrixXd rates;          // by its unknowns, central differences of gas_rates()
  std::vector<Vec3> temperature;  // by zone: dT/d(n_O2, n_N2, U)
  std::vector<Vec3> pressure;     // by zone: dpO2/d(n_O2, n_N2, U)
};

// The gas' unknowns among all.
Eigen::VectorXd gas_part(const System& system, std::span<const double> v);

}  // namespace pmr::coupling
