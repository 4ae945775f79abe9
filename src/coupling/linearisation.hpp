// The Jacobian J of the network at one evaluated state. Each value is made from those before it,
// so that nothing can be asked of what is not there yet:
//
//   System                  -> RowSums                      once an interval
//   RowSums, Evaluation     -> Linearisation                J, its products
//   Linearisation, gamma    -> Preconditioner, SumKeeper    P ~ I - gamma J; what the books hold
//
// J is exact but for the block of the gas by itself, which is a central difference of gas_rates().
#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/slopes.hpp"
#include "coupling/system.hpp"

namespace pmr::coupling {

// `sums` and the system must outlive it.
struct Linearisation {
  Linearisation(const System& system, const RowSums& sums, double t, std::span<const double> y,
                const Evaluation& at);

  const System* system;
  HeatSlopes heat;
  std::vector<double> capacity;  // [J/K] by solid node; 1 where nothing is
  std::vector<ReactionSlopes> reactions;
  GasSlopes gas;
};

// What a change v of the unknowns means.
struct Changes {
  Changes(const Linearisation& J, std::span<const double> v);
  // The gas of v has changed by `more`.
  void follow_gas(const Linearisation& J, const Eigen::VectorXd& more);

  std::span<const double> v;
  std::vector<double> temperature;  // [K] by node; of the gas only the chamber's
  Eigen::VectorXd gas;              // its unknowns
  std::vector<double> pressure;     // [Pa] of oxygen by gas zone
};

// jv = J v
void product(const Linearisation& J, std::span<const double> v, std::span<double> jv);
// The gas' rows of J v alone.
Eigen::VectorXd gas_product(const Linearisation& J, const Changes& change);
// The gas' rows of J by the gas' unknowns, the particles as warm as they are, their deltas
// following by their own rows of I - gamma J; gamma 0: as they are.
Eigen::MatrixXd gas_by_gas(const Linearisation& J, double gamma);

// Change of what reactant k gives to its gas.
struct Given {
  double oxygen, energy;  // [mol/s], [W]
};
Given given_change(const Linearisation& J, std::size_t k, const Changes& change);

// What reactant k's own row of I - gamma J makes of its delta, as warm as it is.
struct DeltaRow {
  DeltaRow(const ReactionSlopes& r, double gamma)  // [s]
      : step(2.0 * gamma / r.formula_units), pivot(1.0 - step * r.by_delta) {}
  double step;   // [s/mol] of delta by release
  double pivot;  // [1]
};

// Change of pO2 [Pa] in each gas zone with its three unknowns.
std::vector<double> pressure_changes(const GasSlopes& slopes, const Eigen::VectorXd& gas);

}  // namespace pmr::coupling
