#include "physics/size_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

namespace pmr::physics {
namespace {

constexpr std::size_t most_cells = 4096;  // of equal mass that a distribution is cut into
constexpr double tail = 3.0902323061678;  // [1] Phi(-tail) = 0.001

double volume(double d) { return pi / 6.0 * d * d * d; }
double normal_passing(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

// Q3(d) [1] of the whole law.
double passing(const NormalSizes& law, double d) {
  return normal_passing((d - law.mean) / law.deviation);
}
double passing(const LogNormalSizes& law, double d) {
  return normal_passing(std::log(d / law.median) / law.log_deviation);
}
double passing(const RosinRammlerSizes& law, double d) {
  return -std::expm1(-std::pow(d / law.scale, law.exponent));
}
double passing(const SizeCurve& law, double d) {
  const auto above = std::upper_bound(law.diameter.begin(), law.diameter.end(), d);
  if (above == law.diameter.begin()) return 0.0;
  if (above == law.diameter.end()) return 1.0;
  const auto k = static_cast<std::size_t>(above - law.diameter.begin());
  const double part = (d - law.diameter[k - 1]) / (law.diameter[k] - law.diameter[k - 1]);
  return law.passing[k - 1] + part * (law.passing[k] - law.passing[k - 1]);
}

double diameter_at(const Mono& law, const SizeDistribution&, double) { return law.diameter; }

double diameter_at(const SizeClasses& law, const SizeDistribution&, double q) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < law.diameter.size(); ++k)
    if (q < (sum += law.mass_fraction[k])) return law.diameter[k];
  return law.diameter.back();
}

// By bisection between the bounds, to the last bit.
template <class Law>
double diameter_at(const Law& law, const SizeDistribution& sizes, double q) {
  double low = sizes.smallest, high = sizes.largest;
  const double below = passing(law, low), above = passing(law, high);
  const double wanted = below + q * (above - below);
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    (passing(law, middle) < wanted ? low : high) = middle;
  return high;
}

// The distribution cut into cells of mass; a cell's share in the number of particles follows from
// its mass over the volume of its middle size.
class Sampler {
 public:
  explicit Sampler(const SizeDistribution& sizes) : sizes_(sizes) {
    edge_ = edges(sizes.law);
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < edge_.size(); ++k) {
      const double mass = edge_[k + 1] - edge_[k];
      sum += mass / volume(physics::diameter_at(sizes, 0.5 * (edge_[k] + edge_[k + 1])));
      number_.push_back(sum);
    }
  }

  double draw(const SizeSample& sample, std::uint64_t index) const {
    Random random(sample.seed, Purpose::sizes, sample.species, index);
    const double wanted = random.uniform() * number_.back();
    const auto cell = static_cast<std::size_t>(
        std::upper_bound(number_.begin(), number_.end() - 1, wanted) - number_.begin());
    const double q = edge_[cell] + random.uniform() * (edge_[cell + 1] - edge_[cell]);
    return physics::diameter_at(sizes_, q);
  }

 private:
  static std::vector<double> edges(const SizeLaw& law) {
    if (std::holds_alternative<Mono>(law)) return {0.0, 1.0};
    std::vector<double> edge{0.0};
    if (const auto* classes = std::get_if<SizeClasses>(&law)) {
      for (const double fraction : classes->mass_fraction) edge.push_back(edge.back() + fraction);
      return edge;
    }
    for (std::size_t k = 1; k <= most_cells; ++k)
      edge.push_back(static_cast<double>(k) / static_cast<double>(most_cells));
    return edge;
  }

  const SizeDistribution& sizes_;
  std::vector<double> edge_;    // [1] of mass
  std::vector<double> number_;  // [1/m3] up to the upper edge of each cell
};

}  // namespace

double diameter_at(const SizeDistribution& sizes, double q) {
  return std::visit([&](const auto& law) { return diameter_at(law, sizes, q); }, sizes.law);
}

SizeDistribution cut_at_tails(const SizeLaw& law) {
  SizeDistribution sizes{law, 0.0, 0.0};
  if (const auto* mono = std::get_if<Mono>(&law)) {
    sizes.smallest = sizes.largest = mono->diameter;
  } else if (const auto* classes = std::get_if<SizeClasses>(&law)) {
    const auto& d = classes->diameter;
    sizes.smallest = *std::min_element(d.begin(), d.end());
    sizes.largest = *std::max_element(d.begin(), d.end());
  } else if (const auto* normal = std::get_if<NormalSizes>(&law)) {
    sizes.smallest = normal->mean - tail * normal->deviation;
    sizes.largest = normal->mean + tail * normal->deviation;
  } else if (const auto* log_normal = std::get_if<LogNormalSizes>(&law)) {
    sizes.smallest = log_normal->median * std::exp(-tail * log_normal->log_deviation);
    sizes.largest = log_normal->median * std::exp(tail * log_normal->log_deviation);
  } else if (const auto* rosin = std::get_if<RosinRammlerSizes>(&law)) {
    sizes.smallest = rosin->scale * std::pow(-std::log1p(-0.001), 1.0 / rosin->exponent);
    sizes.largest = rosin->scale * std::pow(-std::log(0.001), 1.0 / rosin->exponent);
  } else {
    const auto& curve = std::get<SizeCurve>(law);
    sizes.smallest = curve.diameter.front();
    sizes.largest = curve.diameter.back();
  }
  return sizes;
}

std::vector<double> sizes_of_mass(const SizeDistribution& sizes, const SizeSample& sample,
                                  double mass) {
  const Sampler sampler(sizes);
  std::vector<double> diameters;
  for (double left = mass; left > 0.0;) {
    const double d = sampler.draw(sample, diameters.size());
    const double each = sample.density * volume(d);
    if (each > 2.0 * left && !diameters.empty()) break;  // without it is closer
    diameters.push_back(d);
    left -= each;
  }
  return diameters;
}

std::vector<double> sizes_of_count(const SizeDistribution& sizes, const SizeSample& sample,
                                   std::size_t count) {
  const Sampler sampler(sizes);
  std::vector<double> diameters;
  for (std::size_t k = 0; k < count; ++k) diameters.push_back(sampler.draw(sample, k));
  return diameters;
}

double sauter_diameter(const std::vector<double>& diameters) {
  double squares = 0.0, cubes = 0.0;
  for (const double d : diameters) {
    squares += d * d;
    cubes += d * d * d;
  }
  return cubes / squares;
}

}  // namespace pmr::physics
