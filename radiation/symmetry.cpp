#include "radiation/symmetry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "pmr/base/parallel.hpp"

namespace pmr::radiation {
namespace {

constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();
constexpr int most_sweeps = 60;        // [1] about 30 do for a closed bed
constexpr double good_enough = 1e-10;  // [1] of row sums

// Who hit each node, ascending.
struct Received {
  std::vector<std::uint64_t> start;  // [nodes + 1]
  std::vector<Count> entry;
  std::span<const Count> of(std::size_t j) const {
    return {entry.data() + start[j], entry.data() + start[j + 1]};
  }
};

constexpr std::size_t parts = 16;  // of the rows, each counted and dealt out on its own

Received transpose(const std::vector<CountRow>& rows) {
  const std::size_t nodes = rows.size();
  const auto for_each_of_part = [&](std::size_t part, const auto& visit) {
    for (std::size_t i = part * nodes / parts; i < (part + 1) * nodes / parts; ++i)
      for (const Count& c : rows[i]) visit(static_cast<std::uint32_t>(i), c);
  };
  std::vector<std::vector<std::uint32_t>> place(parts, std::vector<std::uint32_t>(nodes, 0));
  const auto count = [&](std::size_t part) {
    for_each_of_part(part, [&](std::uint32_t, const Count& c) { ++place[part][c.node]; });
  };
  parallel_for(parts, count, 1);
  std::vector<std::uint32_t> length(nodes, 0);
  parallel_for(nodes, [&](std::size_t j) {  // counts become the parts' first places in a row
    for (std::size_t part = 0; part < parts; ++part)
      length[j] += std::exchange(place[part][j], length[j]);
  });
  Received received;
  received.start.assign(nodes + 1, 0);
  for (std::size_t j = 0; j < nodes; ++j) received.start[j + 1] = received.start[j] + length[j];
  received.entry.resize(received.start.back());
  const auto deal = [&](std::size_t part) {
    for_each_of_part(part, [&](std::uint32_t i, const Count& c) {
      received.entry[received.start[c.node] + place[part][c.node]++] = {i, c.rays};
    });
  };
  parallel_for(parts, deal, 1);
  return received;
}

// visit(j, sent, received) for each node that i has sent rays to or received rays from, ascending.
template <class Visit>
void for_each_partner(std::span<const Count> out, std::span<const Count> in, const Visit& visit) {
  std::size_t a = 0, b = 0;
  while (a < out.size() || b < in.size()) {
    const std::uint32_t j =
        std::min(a < out.size() ? out[a].node : no_node, b < in.size() ? in[b].node : no_node);
    const std::uint64_t sent = a < out.size() && out[a].node == j ? out[a++].rays : 0;
    const std::uint64_t received = b < in.size() && in[b].node == j ? in[b++].rays : 0;
    visit(j, sent, received);
  }
}

}  // namespace

Symmetric merge(const Counted& counted) {
  const Received received = transpose(counted.rows);
  const std::size_t nodes = counted.rows.size();
  std::vector<std::uint64_t> length(nodes, 0), most(nodes, 0);
  parallel_for(nodes, [&](std::size_t i) {
    for_each_partner(counted.rows[i], received.of(i),
                     [&](std::uint32_t j, std::uint64_t sent, std::uint64_t back) {
                       if (j == i) return;
                       ++length[i];
                       if (j + 1 != nodes) most[i] = std::max(most[i], sent + back);
                     });
  });
  Symmetric result;
  result.self.assign(nodes, 0.0);
  Csr& g = result.factor;
  g.start.reserve(nodes + 1);
  for (const std::uint64_t entries : length) g.start.push_back(g.start.back() + entries);
  g.column.resize(g.start.back());
  g.value.resize(g.start.back());
  const auto power = [&](std::size_t node, std::uint64_t rays) {  // [m2]
    return rays == 0 ? 0.0
                     : counted.emission[node] / static_cast<double>(counted.rays[node]) *
                           static_cast<double>(rays);
  };
  parallel_for(nodes, [&](std::size_t i) {
    std::uint64_t k = g.start[i];
    for_each_partner(counted.rows[i], received.of(i),
                     [&](std::uint32_t j, std::uint64_t sent, std::uint64_t back) {
                       const bool one_sided = counted.rays[i] == 0 || counted.rays[j] == 0;
                       const double ci = counted.thinning[i], cj = counted.thinning[j];
                       const double value =
                           one_sided ? power(i, sent) + power(j, back)
                                     : (cj * power(i, sent) + ci * power(j, back)) / (ci + cj);
                       if (j == i) {
                         result.self[i] = value;
                         return;
                       }
                       g.column[k] = j;
                       g.value[k++] = value;
                     });
  });
  double sum = 0.0, rows = 0.0;
  for (std::size_t i = 0; i + 1 < nodes; ++i)
    if (most[i] > 0) {
      sum += 1.0 / std::sqrt(static_cast<double>(most[i]));
      rows += 1.0;
    }
  result.relative_error = rows > 0.0 ? sum / rows : 0.0;
  return result;
}

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

double balance(const std::vector<double>& emission, Csr& g, std::vector<double>& self) {
  std::vector<double> scale(g.rows(), 1.0), ratio(g.rows(), 1.0);
  double worst = 0.0;
  for (int sweep = 0;; ++sweep) {
    parallel_for(g.rows(), [&](std::size_t i) {
      if (!(emission[i] > 0.0)) return;
      double sum = self[i] * scale[i];  // [m2]
      for (std::uint64_t k = g.start[i]; k < g.start[i + 1]; ++k)
        sum += g.value[k] * scale[g.column[k]];
      ratio[i] = sum * scale[i] / emission[i];
    });
    worst = parallel_max(g.rows(), 0.0, [&](std::size_t i) { return std::abs(ratio[i] - 1.0); });
    if (sweep == most_sweeps || worst <= good_enough) break;
    for (std::size_t i = 0; i < g.rows(); ++i) scale[i] /= std::sqrt(ratio[i]);
  }
  parallel_for(g.rows(), [&](std::size_t i) {
    self[i] *= scale[i] * scale[i];
    for (std::uint64_t k = g.start[i]; k < g.start[i + 1]; ++k)
      g.value[k] *= scale[i] * scale[g.column[k]];  // same bits for (j, i)
  });
  return worst;
}

Symmetric symmetrise(const Counted& counted) {
  Symmetric result = merge(counted);
  result.row_sum_error = balance(counted.emission, result.factor, result.self);
  return result;
}

}  // namespace pmr::radiation
