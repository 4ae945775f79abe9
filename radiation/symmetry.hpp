// From counts of rays to a symmetric matrix with the right row sums.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pmr/base/csr.hpp"

namespace pmr::radiation {

struct Count {
  std::uint32_t node;  // that absorbed
  std::uint32_t rays;  // [1]
};
using CountRow = std::vector<Count>;  // ascending nodes

// Counts rays by the node that absorbed them.
class Tally {
 public:
  explicit Tally(std::size_t rays);  // [1] at most this many will be added
  void add(std::uint32_t node);
  CountRow row() const;

 private:
  std::vector<Count> slot_;  // by hash of the node; rays 0: empty
};

// Adds one row to another.
void add_counts(CountRow& sum, CountRow&& row);

struct Counted {
  std::vector<CountRow> rows;       // [nodes] n_ij: rays of i absorbed by j; last: surroundings
  std::vector<std::uint64_t> rays;  // [nodes] emitted by i; 0: does not emit
  std::vector<double> thinning;     // [nodes] times the power that a ray of the others carries
  std::vector<double> emission;     // [nodes] eps_i A_i [m2]
};

struct Symmetric {
  Csr factor;                   // [m2] G_ij = G_ji, no diagonal
  std::vector<double> self;     // [m2] G_ii
  double row_sum_error = 0.0;   // [1] largest |t_i/(eps_i A_i) - 1|
  double relative_error = 0.0;  // [1] mean over rows of 1/sqrt(n) of the largest factor's n
};

// The mean of the two estimates of each factor, each weighed with the inverse of its variance: as
// 1/c, c the power that a ray carries. Surroundings and reservoirs do not emit: their columns are
// one-sided. Also the mean over rows of the Poisson error of the factor with most rays,
// surroundings left out.
Symmetric merge(const Counted& counted);

// The same with its row sums put right.
Symmetric symmetrise(const Counted& counted);

// Multiplies each factor with s_i s_j so that rows, diagonal `self` included, sum up to eps_i A_i
// [m2]; s = 1 where that is 0. The largest error of a row sum that is left [1].
double balance(const std::vector<double>& emission, Csr& factor, std::vector<double>& self);

}  // namespace pmr::radiation
