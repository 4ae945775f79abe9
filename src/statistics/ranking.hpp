// Which uncertain input a response follows most.
#pragma once
#include <span>
#include <vector>

#include "statistics/design.hpp"

namespace pmr::statistics {

// Standardised rank regression coefficient [1] of one input and its 90 % interval.
struct Rank {
  double coefficient;
  double low, high;
};

// Ranks of all inputs. `r2` is the share of the ranks' variance that the regression explains [1]:
// a ranking with less than about 0.7 misses what is not monotone or not additive.
struct Ranking {
  std::vector<Rank> inputs;
  double r2;
  std::size_t left_out;  // runs whose response or input was no finite number
};

// Linear regression of the response's ranks on the inputs' ranks, both standardised, equal values
// at their mean rank (Iman & Conover, Technometrics 21 (1979) 499); intervals between the 5 % and
// 95 % quantiles of 400 bootstrap samples, the same on every call. An input that does not vary has
// 0. All NaN when fewer than d + 2 runs are left or the response does not vary.
Ranking rank(const Points& inputs, std::span<const double> responses);

}  // namespace pmr::statistics
