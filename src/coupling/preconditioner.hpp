// P ~ I - gamma J, factorised.
#pragma once
#include <Eigen/LU>
#include <span>
#include <vector>

#include "coupling/linearisation.hpp"

namespace pmr::coupling {

// Keeps, per particle, the 2 x 2 block of (enthalpy, delta) with the diagonal of the heat network,
// per wall its tridiagonal column, and couples the gas to every particle by a Schur complement of
// three rows a gas zone: the pressure answers all granules at once. Of the films between pores
// and particles it keeps what the gas feels (theory 9.6).
class Preconditioner {
 public:
  Preconditioner(const Linearisation& J, double gamma);  // [s]

  // z = P^-1 r. Factors serve for some steps: J is that of the step at hand, by which gas and
  // granules feel each other.
  void solve(const Linearisation& J, std::span<const double> r, std::span<double> z) const;

 private:
  struct Block {
    double a, b, c, d;  // rows of the inverse of the 2 x 2 block
  };
  void factor_particles(const Linearisation& J);
  void factor_walls(const Linearisation& J);
  void factor_gas(const Linearisation& J);
  // Particles that react and gas, by elimination of the particles; the gas' part of z is returned.
  Eigen::VectorXd solve_gas(const Linearisation& J, std::span<const double> r,
                            std::span<double> z) const;
  void solve_walls(const System& system, std::span<const double> r, std::span<double> z) const;

  double gamma_;                                              // [s]
  std::vector<double> particle_pivot_;                        // [1] by solid node
  std::vector<Block> blocks_;                                 // by reactant
  std::vector<double> wall_lower_, wall_pivot_, wall_upper_;  // LU of the columns, by cell
  Eigen::PartialPivLU<Eigen::MatrixXd> gas_;                  // of the Schur complement
};

}  // namespace pmr::coupling
