// The gas and the sums that the books hold the network to, in a solution of (I - gamma J) x = b.
#pragma once
#include <Eigen/LU>
#include <memory>
#include <span>
#include <vector>

#include "coupling/linearisation.hpp"

namespace pmr::coupling {

// Mends approximate solutions: the rows of the gas are solved for the gas, given the particles;
// then x moves by a little warmth and a little oxygen of all particles, the gas following, so that
// the sums of energy and bound oxygen hold exactly. What is left of the residual never shows in the
// books, however few Krylov iterations it took.
class SumKeeper {
 public:
  SumKeeper(std::shared_ptr<const Linearisation> J, double gamma);  // [s]

  double gamma() const { return gamma_; }  // [s]
  void mend(std::span<const double> b, std::span<double> x) const;

 private:
  using Sums = Eigen::Vector2d;  // of energy [J] and of oxygen in the solids [mol]

  Sums residual(const Changes& change) const;  // sums over (I - gamma J) v
  Changes solve_gas(std::span<const double> b, std::span<double> x) const;

  std::shared_ptr<const Linearisation> J_;
  double gamma_;                                   // [s]
  Eigen::PartialPivLU<Eigen::MatrixXd> gas_rows_;  // I - gamma J of the gas by the gas
  std::vector<double> warmth_, bound_;             // the two moves, as unknowns
  Eigen::Matrix2d inverse_;                        // of the sums' answers to them
};

}  // namespace pmr::coupling
