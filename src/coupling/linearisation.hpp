// The Jacobian of the network as a product and as a preconditioner.
//
// J v is exact but for the block of the gas by itself, which is a central difference of
// gas_rates(). The preconditioner P ~ I - gamma J keeps, per particle, the 2 x 2 block of
// (enthalpy, delta) with the diagonal of the heat network, per wall its tridiagonal column, and
// couples the gas to every particle by a Schur complement of three rows a body of gas: the pressure
// answers all granules at once. Of the films between pores and particles it keeps what the gas
// feels.
#pragma once
#include <Eigen/LU>
#include <span>
#include <vector>

#include "coupling/system.hpp"
#include "pmr/base/vec3.hpp"

namespace pmr::coupling {

class Linearisation {
 public:
  explicit Linearisation(const System& system);

  void fix(double t, std::span<const double> y, const Evaluation& at);  // J at (t, y)
  void product(std::span<const double> v, std::span<double> jv) const;
  void prepare(double gamma);  // [s] factorises P at the fixed point
  void precondition(std::span<const double> r, std::span<double> z) const;
  // Mends x, an approximate solution of (I - gamma J) x = b: the rows of the gas are solved for the
  // gas, given the particles; then x moves by a little warmth and a little oxygen of all particles,
  // the gas following, so that the sums of energy and bound oxygen hold exactly. What is left of
  // the residual never shows in the books, however few Krylov iterations it took.
  void keep_sums(double gamma, std::span<const double> b, std::span<double> x);

 private:
  // Slopes of one reactant's release n [mol/s], of temperature and enthalpy.
  struct Reaction {
    double release, by_T, by_delta, by_pressure;  // n, dn/dT, dn/d(delta), dn/dp
    double oxygen_heat, oxygen_capacity;          // h_O2 [J/mol], c_O2 [J/mol/K]
    double delta_slope;                           // dH/d(delta) at constant T [J]
    double iron;                                  // [mol]
    std::uint32_t id;
    std::size_t body;  // of gas around it
  };
  struct Block {
    double a, b, c, d;  // rows of the inverse of the 2 x 2 block
  };
  using Mat32 = Eigen::Matrix<double, 3, 2>;
  using Sums = Eigen::Vector2d;  // of energy [J] and of oxygen in the solids [mol]
  struct Given {
    double oxygen, energy;  // [mol/s], [W] change of what a reactant gives to its gas
  };

  Sums sums(std::span<const double> v) const;
  // Of J v, v with its changes of temperature [K]: flows over the border only.
  Sums sums_of_product(std::span<const double> v, const std::vector<double>& change) const;

  Given given_change(const Reaction& r, std::size_t k, std::span<const double> v,
                     const std::vector<double>& change, const std::vector<double>& pressure) const;
  Eigen::MatrixXd gas_by_gas() const;
  double heat_loss(std::size_t body) const;  // [W/K] of a body of gas to what is solid
  // What the bed gives to each body of gas, three figures each; write(reaction, k, given) is told
  // of every reactant.
  template <class Write>
  std::vector<double> given_by_bed(std::span<const double> v, const std::vector<double>& change,
                                   const std::vector<double>& pressure, const Write& write) const {
    return parallel_bins(reactions_.size(), 3 * system_.bodies(),
                         [&](std::size_t k, std::vector<double>& sums) {
                           const Reaction& r = reactions_[k];
                           const Given given = given_change(r, k, v, change, pressure);
                           write(r, k, given);
                           if (r.body == System::no_body) return;
                           sums[3 * r.body] += given.oxygen;
                           sums[3 * r.body + 2] += given.energy;
                         });
  }
  // The gas' rows of J v, from their parts; `to_chamber` [W] comes by the chamber's films.
  Eigen::VectorXd gas_rows(const Eigen::VectorXd& gas, const std::vector<double>& given,
                           const std::vector<double>& film, double to_chamber) const;
  Eigen::VectorXd gas_product(std::span<const double> v, const std::vector<double>& change) const;
  void solve_gas(double gamma, std::span<const double> b, std::span<double> x,
                 std::vector<double>& change) const;
  void prepare_sums(double gamma);
  void fix_gas(double t, std::span<const double> y);
  // Change of pO2 [Pa] in each body of gas with its three unknowns.
  std::vector<double> pressure_changes(const Eigen::VectorXd& gas) const;
  // [W] from the gas of each layer of pores by changes of the gas and of temperatures [K].
  std::vector<double> film_changes(const Eigen::VectorXd& gas,
                                   const std::vector<double>& change) const;
  Eigen::VectorXd gas_part(std::span<const double> v) const;
  void temperature_changes(std::span<const double> v, std::vector<double>& change) const;
  // [W] that a node receives by changes of temperature [K] and of emission [W/m2] of all.
  double heat_change(std::size_t node, const std::vector<double>& change,
                     const std::vector<double>& emission_change) const;
  void wall_product(const std::vector<double>& heat, std::span<const double> v,
                    std::span<double> jv) const;
  Mat32 gas_slopes(const Reaction& r) const;  // d(n_O2, n_N2, U rates)/d(H, delta)
  void factor_particles(double gamma);
  void factor_walls(double gamma);
  void factor_gas(double gamma);

  Eigen::Matrix2d sums_inverse_ = Eigen::Matrix2d::Identity();  // of the sums' answers to two moves
  std::vector<double> warmth_, bound_;                          // those moves, as unknowns
  double sums_gamma_ = 0.0;  // [s] that sums_inverse_ stands for; 0: none
  double gamma_ = 0.0;       // [s]
  const System& system_;
  std::vector<double> conduction_sum_, exchange_sum_;  // [W/K], [m2] row sums by node
  std::vector<double> conduction_out_, exchange_out_;  // [W/K], [m2] likewise, to reservoirs alone
  std::vector<double> emission_slope_;                 // [W/m2/K] 4 sigma T^3 by node
  std::vector<double> capacity_;                       // [J/K] by particle id
  std::vector<double> cell_capacity_;                  // [J/K] by wall cell
  std::vector<Reaction> reactions_;
  std::vector<Vec3> temperature_row_;   // by body: dT/d(n_O2, n_N2, U)
  std::vector<Vec3> pressure_row_;      // by body: dpO2/d(n_O2, n_N2, U)
  std::vector<double> particle_pivot_;  // [1] of particles that do not react, by id
  std::vector<Block> blocks_;           // by reactant
  std::vector<double> wall_lower_, wall_pivot_, wall_upper_;  // LU of the columns, by cell
  Eigen::MatrixXd gas_jacobian_;                              // of the gas alone, by its unknowns
  Eigen::PartialPivLU<Eigen::MatrixXd> gas_solver_;           // of the Schur complement
  Eigen::PartialPivLU<Eigen::MatrixXd> gas_rows_;             // I - gamma J of the gas by the gas
};

}  // namespace pmr::coupling
