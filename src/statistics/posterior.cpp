#include "statistics/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pmr/base/errors.hpp"

namespace pmr::statistics {
namespace {

constexpr double dip = 2.0;             // [1] of the logarithm, between two peaks
constexpr double least_mass = 1e-3;     // [1] of a mode
constexpr double narrow = 6.0;          // [1] cells in a deviation
constexpr double window = 6.0;          // [1] deviations to each side of a mode's mean
constexpr std::size_t most_looks = 12;  // at a mode on ever finer grids

// Points from the densest on.
std::vector<std::size_t> by_density(const std::vector<double>& log_density) {
  std::vector<std::size_t> order(log_density.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return log_density[a] > log_density[b]; });
  return order;
}

// Peaks grown downwards together: each point belongs to the peak of its densest neighbour, and two
// peaks that meet less than `dip` below the lower become one (Edelsbrunner, Letscher & Zomorodian,
// Discrete Comput. Geom. 28 (2002) 511). The peak of each point.
std::vector<std::size_t> peaks_of(const Grid& grid, const std::vector<double>& log_density) {
  const std::size_t none = grid.size();
  std::vector<std::size_t> peak(grid.size(), none), parent(grid.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t p) {
    while (parent[p] != p) p = parent[p];
    return p;
  };
  for (const std::size_t i : by_density(log_density)) {
    std::vector<std::size_t> met;
    for (const std::size_t n : grid.neighbours(i))
      if (peak[n] != none) met.push_back(root(peak[n]));
    if (met.empty()) {
      peak[i] = i;
      continue;
    }
    const auto denser = [&](std::size_t a, std::size_t b) {
      return log_density[a] != log_density[b] ? log_density[a] > log_density[b] : a < b;
    };
    std::sort(met.begin(), met.end(), denser);
    peak[i] = met.front();
    for (const std::size_t other : met)
      if (log_density[other] - log_density[i] < dip) parent[other] = met.front();
  }
  for (std::size_t& p : peak) p = root(p);
  return peak;
}

// Mean and covariance of the points of one peak.
Mode moments(const Grid& grid, const Posterior& posterior, const std::vector<std::size_t>& peak,
             std::size_t of) {
  const std::size_t d = grid.dimension();
  Mode mode{grid.point(of), std::vector<double>(d, 0.0),
            std::vector<std::vector<double>>(d, std::vector<double>(d, 0.0)), 0.0};
  const auto each = [&](const auto& add) {
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (peak[i] == of && posterior.weight[i] > 0.0) add(posterior.weight[i], grid.point(i));
  };
  each([&](double w, const std::vector<double>& x) {
    mode.mass += w;
    for (std::size_t k = 0; k < d; ++k) mode.mean[k] += w * x[k];
  });
  for (double& m : mode.mean) m /= mode.mass;
  each([&](double w, const std::vector<double>& x) {
    for (std::size_t k = 0; k < d; ++k)
      for (std::size_t l = 0; l < d; ++l)
        mode.covariance[k][l] += w / mode.mass * (x[k] - mode.mean[k]) * (x[l] - mode.mean[l]);
  });
  return mode;
}

Posterior posterior_of(const Problem& problem, const Grid& grid) {
  std::vector<Field> fields;
  for (const Response& response : problem.responses) fields.push_back(field_of(grid, response));
  return normalised(grid, log_density(grid, fields, problem.measured, problem.priors));
}

bool is_narrow(const Mode& mode, const Grid& grid) {
  for (std::size_t k = 0; k < grid.dimension(); ++k) {
    const double low = fraction_at(grid.spans()[k], mode.mean[k]);
    const double high = fraction_at(grid.spans()[k], mode.mean[k] + mode.deviation(k));
    if ((high - low) * static_cast<double>(grid.steps() - 1) < narrow) return true;
  }
  return false;
}

// The box about a mode that was seen on a grid, within the whole one.
std::vector<Span> box_about(const Mode& mode, const Grid& grid, const std::vector<Span>& whole) {
  std::vector<Span> box = whole;
  for (std::size_t k = 0; k < box.size(); ++k) {
    const Span seen = grid.spans()[k];
    const double width = fraction_at(whole[k], seen.high) - fraction_at(whole[k], seen.low);
    const double at = fraction_at(whole[k], mode.best[k]);
    const double mean = fraction_at(whole[k], mode.mean[k]);
    const double deviation = fraction_at(whole[k], mode.mean[k] + mode.deviation(k)) - mean;
    const double reach = window * deviation + std::abs(mean - at) +
                         3.0 * width / static_cast<double>(grid.steps() - 1);
    box[k].low = value_at(whole[k], std::max(0.0, at - reach));
    box[k].high = value_at(whole[k], std::min(1.0, at + reach));
  }
  return box;
}

double log_volume(const std::vector<Span>& part, const std::vector<Span>& whole) {
  double volume = 0.0;
  for (std::size_t k = 0; k < part.size(); ++k)
    volume += std::log(fraction_at(whole[k], part[k].high) - fraction_at(whole[k], part[k].low));
  return volume;
}

// A mode whose mass is still a logarithm, in that of an even density of 1 over the box.
struct Weighed {
  Mode mode;
  double log_mass;
};

// The mode, if it is narrow on this grid, on one of its own.
Weighed resolved(Mode mode, const Problem& problem, Grid grid, double log_mass) {
  const std::vector<Span> whole = grid.spans();
  Weighed weighed{std::move(mode), 0.0};
  weighed.log_mass = log_mass + std::log(weighed.mode.mass);
  for (std::size_t look = 0; look < most_looks && is_narrow(weighed.mode, grid); ++look) {
    grid = Grid(box_about(weighed.mode, grid, whole), grid.steps());
    const Posterior posterior = posterior_of(problem, grid);
    const auto peak = peaks_of(grid, posterior.log_density);
    weighed.mode = moments(grid, posterior, peak, by_density(posterior.log_density).front());
    weighed.log_mass =
        posterior.log_mass + log_volume(grid.spans(), whole) + std::log(weighed.mode.mass);
  }
  return weighed;
}

}  // namespace

double Mode::deviation(std::size_t variable) const {
  return std::sqrt(covariance[variable][variable]);
}

std::vector<double> log_density(const Grid& grid, std::span<const Field> fields,
                                std::span<const Measured> measured, const Priors& priors) {
  ensure(fields.size() == measured.size(), "each measured level has a response");
  ensure(priors.size() == grid.dimension(), "each variable has a prior");
  std::vector<double> result(grid.size(), 0.0);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    for (std::size_t r = 0; r < fields.size(); ++r) {
      const double s2 = measured[r].deviation * measured[r].deviation +
                        fields[r].deviation[i] * fields[r].deviation[i];
      const double miss = fields[r].mean[i] - measured[r].level;
      result[i] -= 0.5 * (miss * miss / s2 + std::log(s2));
    }
    const std::vector<double> point = grid.point(i);
    for (std::size_t k = 0; k < point.size(); ++k) {
      if (!priors[k]) continue;
      const double miss = (point[k] - priors[k]->mean) / priors[k]->deviation;
      result[i] -= 0.5 * miss * miss;
    }
  }
  return result;
}

Posterior normalised(const Grid& grid, std::vector<double> log_density) {
  Posterior posterior{std::move(log_density), std::vector<double>(grid.size()), 0.0};
  const double highest =
      *std::max_element(posterior.log_density.begin(), posterior.log_density.end());
  double sum = 0.0, cells = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    posterior.weight[i] = grid.measure(i) * std::exp(posterior.log_density[i] - highest);
    sum += posterior.weight[i];
    cells += grid.measure(i);
  }
  for (double& w : posterior.weight) w /= sum;
  posterior.log_mass = highest + std::log(sum / cells);
  return posterior;
}

double Posterior::mass_on_edge(const Grid& grid) const {
  double mass = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (grid.is_on_edge(i)) mass += weight[i];
  return mass;
}

double Posterior::region_level(double part) const {
  double mass = 0.0;
  for (const std::size_t i : by_density(log_density)) {
    mass += weight[i];
    if (mass >= part) return log_density[i];
  }
  return *std::min_element(log_density.begin(), log_density.end());
}

std::vector<Mode> find_modes(const Problem& problem, const std::vector<Span>& box,
                             std::size_t steps) {
  const Grid grid(box, steps);
  const Posterior posterior = posterior_of(problem, grid);
  const auto peak = peaks_of(grid, posterior.log_density);
  std::vector<double> mass(grid.size(), 0.0);
  for (std::size_t i = 0; i < grid.size(); ++i) mass[peak[i]] += posterior.weight[i];
  std::vector<Weighed> all;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (mass[i] >= least_mass)
      all.push_back(resolved(moments(grid, posterior, peak, i), problem, grid, posterior.log_mass));
  double heaviest = all.front().log_mass, sum = 0.0;
  for (const Weighed& w : all) heaviest = std::max(heaviest, w.log_mass);
  for (const Weighed& w : all) sum += std::exp(w.log_mass - heaviest);
  std::vector<Mode> modes;
  for (Weighed& w : all) {
    modes.push_back(std::move(w.mode));
    modes.back().mass = std::exp(w.log_mass - heaviest) / sum;
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.mass > b.mass; });
  return modes;
}

std::size_t most_telling(const Posterior& posterior, std::span<const Field> fields,
                         std::span<const Measured> measured) {
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < posterior.weight.size(); ++i) {
    double share = 0.0;
    for (std::size_t r = 0; r < fields.size(); ++r) {
      const double part = fields[r].deviation[i] / measured[r].deviation;
      share += part * part;
    }
    if (posterior.weight[i] * share <= most) continue;
    most = posterior.weight[i] * share;
    best = i;
  }
  return best;
}

}  // namespace pmr::statistics
