// Piecewise linear function of one variable, constant beyond its ends.
#pragma once
#include <algorithm>
#include <utility>
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

// A table with its exact integral from its first x on.
struct IntegratedTable {
  Table table;
  std::vector<double> sums;  // to each x

  explicit IntegratedTable(Table rows) : table(std::move(rows)), sums(table.x.size(), 0.0) {
    for (std::size_t k = 1; k < sums.size(); ++k)
      sums[k] = sums[k - 1] + 0.5 * (table.y[k - 1] + table.y[k]) * (table.x[k] - table.x[k - 1]);
  }
  double integral(double to) const {
    const auto upper = std::upper_bound(table.x.begin(), table.x.end(), to);
    if (upper == table.x.begin()) return table.y.front() * (to - table.x.front());
    const auto k = static_cast<std::size_t>(upper - table.x.begin()) - 1;
    return sums[k] + 0.5 * (table.y[k] + table(to)) * (to - table.x[k]);
  }
};

}  // namespace pmr
