#include "statistics/band.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pmr/base/constants.hpp"

namespace pmr::statistics {

double quantile(std::span<const double> sorted, double probability) {
  if (sorted.empty()) return nan;
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  if (sorted[below] == sorted[above]) return sorted[below];  // infinities too
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Band band(std::span<const double> sample) {
  std::vector<double> sorted;
  for (const double x : sample)
    if (!std::isnan(x)) sorted.push_back(x);
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  double sum = 0.0, squares = 0.0;
  for (const double x : sorted) sum += x;
  const double mean = sum / n;  // 0/0 is NaN
  for (const double x : sorted) squares += (x - mean) * (x - mean);
  return {sorted.size(),
          quantile(sorted, 0.05),
          quantile(sorted, 0.5),
          quantile(sorted, 0.95),
          mean,
          n > 1.0 ? std::sqrt(squares / (n - 1.0)) : nan};
}

}  // namespace pmr::statistics
