// How a sample is spread.
#pragma once
#include <cstddef>
#include <span>

namespace pmr::statistics {

// Quantiles, mean and standard deviation (n - 1) in the unit of the sample; `count` [1] numbers
// entered. NaN where nothing can be said: all of an empty sample, the deviation of one number.
struct Band {
  std::size_t count;
  double p5, p50, p95;
  double mean, deviation;
};

// Band of a sample; NaN are left out.
Band band(std::span<const double> sample);

// Quantile at `probability` [1] of sorted numbers, linear between order statistics with
// (n - 1) p before it (type 7 of Hyndman & Fan, Am. Stat. 50 (1996) 361); NaN of none.
double quantile(std::span<const double> sorted, double probability);

}  // namespace pmr::statistics
