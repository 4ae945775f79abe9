// Piecewise linear function of one variable, constant beyond its ends.
#pragma once
#include <algorithm>
#include <vector>

namespace pmr {

struct Table {
  std::vector<double> x;  // ascending
  std::vector<double> y;  // same length, at least 1

  double operator()(double at) const {
    if (at <= x.front()) return y.front();
    if (at >= x.back()) return y.back();
    const auto upper = std::upper_bound(x.begin(), x.end(), at);
    const auto k = static_cast<std::size_t>(upper - x.begin());
    const double fraction = (at - x[k - 1]) / (x[k] - x[k - 1]);
    return y[k - 1] + fraction * (y[k] - y[k - 1]);
  }
};

inline Table constant(double value) { return {{0.0}, {value}}; }

}  // namespace pmr
