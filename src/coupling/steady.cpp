#include "coupling/steady.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>

#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::coupling {
namespace {

constexpr int most_rounds = 60;             // [1] some 5 do for differences of 10 K
constexpr double good_enough = 1e-9;        // [1] of the spread of what is held
constexpr double linear_tolerance = 1e-12;  // [1] residual of each linear system

using Matrix = Eigen::SparseMatrix<double>;

// Unknowns are the free nodes, counted through.
struct Unknowns {
  std::vector<Eigen::Index> of_node;  // -1: held
  Eigen::Index count = 0;

  explicit Unknowns(const std::vector<char>& is_held) : of_node(is_held.size(), -1) {
    for (std::size_t node = 0; node < is_held.size(); ++node)
      if (is_held[node] == 0) of_node[node] = count++;
  }
};

// Row sums of what flows away, and what the held nodes send.
class Assembly {
 public:
  Assembly(const Unknowns& unknowns, const std::vector<double>& temperature)
      : unknowns_(unknowns),
        temperature_(temperature),
        diagonal_(Eigen::VectorXd::Zero(unknowns.count)),
        sent_(Eigen::VectorXd::Zero(unknowns.count)) {}

  void add(std::size_t a, std::size_t b, double w) {
    const Eigen::Index i = unknowns_.of_node[a], j = unknowns_.of_node[b];
    if (i >= 0) diagonal_[i] += w;
    if (j >= 0) diagonal_[j] += w;
    if (i >= 0 && j < 0) sent_[i] += w * temperature_[b];
    if (j >= 0 && i < 0) sent_[j] += w * temperature_[a];
    if (i < 0 || j < 0) return;
    entries_.emplace_back(i, j, -w);
    entries_.emplace_back(j, i, -w);
  }

  // Nodes without any link are tied to their own temperature.
  Matrix finish() {
    for (std::size_t node = 0; node < unknowns_.of_node.size(); ++node) {
      const Eigen::Index i = unknowns_.of_node[node];
      if (i < 0) continue;
      const bool is_alone = !(diagonal_[i] > 0.0);
      if (is_alone) sent_[i] = temperature_[node];
      entries_.emplace_back(i, i, is_alone ? 1.0 : diagonal_[i]);
    }
    Matrix matrix(unknowns_.count, unknowns_.count);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }
  const Eigen::VectorXd& sent() const { return sent_; }

 private:
  const Unknowns& unknowns_;
  const std::vector<double>& temperature_;
  Eigen::VectorXd diagonal_, sent_;
  std::vector<Eigen::Triplet<double>> entries_;
};

double spread_of_held(const std::vector<char>& is_held, const std::vector<double>& temperature) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t node = 0; node < is_held.size(); ++node)
    if (is_held[node] != 0) {
      low = std::min(low, temperature[node]);
      high = std::max(high, temperature[node]);
    }
  return high > low ? high - low : 1.0;
}

}  // namespace

std::vector<double> steady_temperatures(std::span<const HeatLink> links, const Csr* exchange,
                                        const std::vector<char>& is_held,
                                        std::vector<double> temperature) {
  const Unknowns unknowns(is_held);
  const double limit = good_enough * spread_of_held(is_held, temperature);
  for (int round = 0; round < most_rounds; ++round) {
    Assembly assembly(unknowns, temperature);
    for (const HeatLink& link : links) assembly.add(link.a, link.b, link.contact + link.gap);
    for (std::size_t a = 0; exchange != nullptr && a < exchange->rows(); ++a)
      for (std::uint64_t k = exchange->start[a]; k < exchange->start[a + 1]; ++k) {
        const std::size_t b = exchange->column[k];
        if (b < a) continue;
        const double Ta = temperature[a], Tb = temperature[b];
        assembly.add(a, b, exchange->value[k] * stefan_boltzmann * (Ta * Ta + Tb * Tb) * (Ta + Tb));
      }
    const Matrix matrix = assembly.finish();
    Eigen::VectorXd guess(unknowns.count);
    for (std::size_t node = 0; node < is_held.size(); ++node)
      if (unknowns.of_node[node] >= 0) guess[unknowns.of_node[node]] = temperature[node];
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(linear_tolerance);
    const Eigen::VectorXd found = solver.compute(matrix).solveWithGuess(assembly.sent(), guess);
    if (solver.info() != Eigen::Success) break;
    for (std::size_t node = 0; node < is_held.size(); ++node)
      if (unknowns.of_node[node] >= 0) temperature[node] = found[unknowns.of_node[node]];
    if (unknowns.count == 0 || (found - guess).cwiseAbs().maxCoeff() < limit) return temperature;
  }
  throw NumericsError("the heat network at rest was not found by conjugate gradients");
}

}  // namespace pmr::coupling
