// Where to run: points spread evenly over a box of variables.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace pmr::statistics {

// The range of one variable, low < high, in the variable's own unit; a logarithmic one (low > 0) is
// divided evenly by its logarithm.
struct Span {
  double low;
  double high;
  bool is_logarithmic = false;
};

// Value at a fraction of the span, 0 at low and 1 at high.
double value_at(const Span& span, double fraction);

// Fraction [1] of the span at a value; beyond 0 and 1 outside, NaN at no logarithm.
double fraction_at(const Span& span, double value);

enum class Sequence { latin_hypercube, sobol };

using Points = std::vector<std::vector<double>>;  // [point][variable]

// `count` points in the box of the spans, the same on every call.
// latin_hypercube: one point at random in each of `count` strata of each variable; strata paired by
//   simulated annealing for a large least distance (phi_p criterion, p = 50: Morris & Mitchell,
//   J. Stat. Plan. Inference 43 (1995) 381). Another count or seed is another design.
// sobol: first points of Sobol's low-discrepancy sequence, from the centre of the box on; the seed
//   is ignored, and more points keep the earlier ones.
Points sample(Sequence sequence, std::span<const Span> spans, std::size_t count,
              std::uint64_t seed);

// Normal variables that depend on each other, at a point of the unit cube: mean + L q(u), with q
// the quantiles of the standard normal distribution and L L' the covariance (Cholesky's factor).
std::vector<double> normal_values(std::span<const double> fractions, std::span<const double> mean,
                                  const std::vector<std::vector<double>>& covariance);

}  // namespace pmr::statistics
