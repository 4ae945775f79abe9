#include "radiation/symmetry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "pmr/base/parallel.hpp"

namespace pmr::radiation {
namespace {

constexpr int most_sweeps = 60;        // [1] about 30 do for a closed bed
constexpr double good_enough = 1e-10;  // [1] of row sums

// rows[j] lists who hit j, ascending: a fixed order, whoever counted first.
std::vector<CountRow> transpose(const std::vector<CountRow>& rows) {
  std::vector<std::size_t> length(rows.size(), 0);
  for (const CountRow& row : rows)
    for (const Count& c : row) ++length[c.node];
  std::vector<CountRow> result(rows.size());
  for (std::size_t j = 0; j < rows.size(); ++j) result[j].reserve(length[j]);
  for (std::uint32_t i = 0; i < rows.size(); ++i)
    for (const Count& c : rows[i]) result[c.node].push_back({i, c.rays});
  return result;
}

struct Entry {
  std::uint32_t column;
  double value;        // [m2]
  std::uint64_t rays;  // [1] counted for it, both ways
};

// Merges the two estimates of row i. Surroundings and reservoirs do not emit: their columns are
// one-sided.
std::vector<Entry> merge(const Counted& counted, const CountRow& out, const CountRow& in,
                         std::uint32_t i) {
  const auto surroundings = static_cast<std::uint32_t>(counted.rows.size() - 1);
  const auto power = [&](std::uint32_t node) {  // [m2] per ray
    return counted.emission[node] / static_cast<double>(counted.rays[node]);
  };
  std::vector<Entry> row;
  row.reserve(out.size() + in.size());
  std::size_t a = 0, b = 0;
  while (a < out.size() || b < in.size()) {
    const std::uint32_t j = std::min(a < out.size() ? out[a].node : surroundings,
                                     b < in.size() ? in[b].node : surroundings);
    const std::uint64_t sent = a < out.size() && out[a].node == j ? out[a++].rays : 0;
    const std::uint64_t received = b < in.size() && in[b].node == j ? in[b++].rays : 0;
    const double there = sent > 0 ? power(i) * static_cast<double>(sent) : 0.0;
    const double back = received > 0 ? power(j) * static_cast<double>(received) : 0.0;
    const bool one_sided = counted.rays[i] == 0 || counted.rays[j] == 0;
    row.push_back({j, one_sided ? there + back : 0.5 * (there + back), sent + received});
  }
  return row;
}

using EntryRows = std::vector<std::vector<Entry>>;

// Diagonal included; empties the rows.
Csr compress(EntryRows& rows) {
  Csr csr;
  csr.start.reserve(rows.size() + 1);
  for (const auto& row : rows) csr.start.push_back(csr.start.back() + row.size());
  csr.column.resize(csr.start.back());
  csr.value.resize(csr.start.back());
  parallel_for(rows.size(), [&](std::size_t i) {
    std::uint64_t k = csr.start[i];
    for (const Entry& e : rows[i]) {
      csr.column[k] = e.column;
      csr.value[k++] = e.value;
    }
    rows[i] = {};
  });
  return csr;
}

// Factors s_i with s_i sum_j G_ij s_j = eps_i A_i; 1 for the surroundings.
std::vector<double> scales(const Csr& g, const std::vector<double>& emission, double& worst) {
  std::vector<double> scale(g.rows(), 1.0), ratio(g.rows(), 1.0);
  for (int sweep = 0;; ++sweep) {
    parallel_for(g.rows(), [&](std::size_t i) {
      if (!(emission[i] > 0.0)) return;
      double sum = 0.0;  // [m2]
      for (std::uint64_t k = g.start[i]; k < g.start[i + 1]; ++k)
        sum += g.value[k] * scale[g.column[k]];
      ratio[i] = sum * scale[i] / emission[i];
    });
    worst = parallel_max(g.rows(), 0.0, [&](std::size_t i) { return std::abs(ratio[i] - 1.0); });
    if (sweep == most_sweeps || worst <= good_enough) return scale;
    for (std::size_t i = 0; i < g.rows(); ++i) scale[i] /= std::sqrt(ratio[i]);
  }
}

// Mean over rows of the Poisson error of the factor with most rays, surroundings left out.
double error_of(const EntryRows& rows) {
  double sum = 0.0, counted = 0.0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    std::uint64_t most = 0;
    for (const Entry& e : rows[i])
      if (e.column != i && e.column + 1 != rows.size()) most = std::max(most, e.rays);
    if (most == 0) continue;
    sum += 1.0 / std::sqrt(static_cast<double>(most));
    counted += 1.0;
  }
  return counted > 0.0 ? sum / counted : 0.0;
}

// Scales in place and takes the diagonal out.
std::vector<double> finish(Csr& g, const std::vector<double>& scale) {
  std::vector<double> self(g.rows(), 0.0);
  std::uint64_t kept = 0, k = 0;
  for (std::size_t i = 0; i < g.rows(); ++i) {
    const std::uint64_t last = g.start[i + 1];
    for (; k < last; ++k) {
      const std::uint32_t j = g.column[k];
      const double value = g.value[k] * (scale[i] * scale[j]);  // same bits for (j, i)
      if (j == i) {
        self[i] = value;
        continue;
      }
      g.column[kept] = j;
      g.value[kept++] = value;
    }
    g.start[i + 1] = kept;
  }
  g.column.resize(kept);
  g.value.resize(kept);
  return self;
}

}  // namespace

Tally::Tally(std::size_t rays) : slot_(std::bit_ceil(2 * rays + 1)) {}

void Tally::add(std::uint32_t node) {
  const std::size_t last = slot_.size() - 1;
  std::size_t k = (node * std::size_t{0x9e3779b1}) & last;
  while (slot_[k].rays != 0 && slot_[k].node != node) k = (k + 1) & last;
  slot_[k].node = node;
  ++slot_[k].rays;
}

CountRow Tally::row() const {
  CountRow row;
  for (const Count& c : slot_)
    if (c.rays != 0) row.push_back(c);
  std::sort(row.begin(), row.end(), [](const Count& a, const Count& b) { return a.node < b.node; });
  row.shrink_to_fit();
  return row;
}

void add_counts(CountRow& sum, CountRow&& row) {
  if (sum.empty()) {
    sum = std::move(row);
    return;
  }
  CountRow merged;
  merged.reserve(sum.size() + row.size());
  std::size_t a = 0, b = 0;
  while (a < sum.size() || b < row.size()) {
    if (b == row.size() || (a < sum.size() && sum[a].node < row[b].node))
      merged.push_back(sum[a++]);
    else if (a == sum.size() || row[b].node < sum[a].node)
      merged.push_back(row[b++]);
    else {
      merged.push_back({row[b].node, sum[a].rays + row[b].rays});
      ++a;
      ++b;
    }
  }
  sum = std::move(merged);
}

Symmetric symmetrise(const Counted& counted) {
  EntryRows rows(counted.rows.size());
  {
    const std::vector<CountRow> received = transpose(counted.rows);
    parallel_for(rows.size(), [&](std::size_t i) {
      rows[i] = merge(counted, counted.rows[i], received[i], static_cast<std::uint32_t>(i));
    });
  }
  Symmetric result;
  result.relative_error = error_of(rows);
  result.factor = compress(rows);
  const auto scale = scales(result.factor, counted.emission, result.row_sum_error);
  result.self = finish(result.factor, scale);
  return result;
}

}  // namespace pmr::radiation
