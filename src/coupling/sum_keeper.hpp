// What the books hold the network to, in a solution of (I - gamma J) x = b: each particle's oxygen,
// the gas, and the sum of all energy.
#pragma once
#include <Eigen/LU>
#include <memory>
#include <span>
#include <vector>

#include "coupling/linearisation.hpp"

namespace pmr::coupling {

// Mends approximate solutions: the rows of the deltas and of the gas are solved for these, given
// the temperatures; then all particles get a little warmer or colder, deltas and gas following, so
// that the sum of energy holds exactly. So each particle's oxygen is what its own rate makes of it,
// and what is left of the residual never shows in the books, however few Krylov iterations it took.
class SumKeeper {
 public:
  SumKeeper(std::shared_ptr<const Linearisation> J, double gamma);  // [s]

  double gamma() const { return gamma_; }  // [s]
  void mend(std::span<const double> b, std::span<double> x) const;

 private:
  double energy_residual(const Changes& change) const;  // [J] sum over (I - gamma J) v
  Changes solve_oxygen_and_gas(std::span<const double> b, std::span<double> x) const;
  void add_to_delta(std::size_t k, double more, std::span<double> x) const;

  std::shared_ptr<const Linearisation> J_;
  double gamma_;                                   // [s]
  Eigen::PartialPivLU<Eigen::MatrixXd> gas_rows_;  // of the gas by the gas, deltas following
  std::vector<double> warmth_;                     // 1 K more of all particles, as unknowns
  double answer_ = 1.0;                            // [J] of the sum of energy to it
};

}  // namespace pmr::coupling
