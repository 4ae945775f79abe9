#include "statistics/design.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/GeometricProfile.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/RandomGeneratorState.hxx>
#include <openturns/SimulatedAnnealingLHS.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/SpaceFillingPhiP.hxx>
#include <openturns/Uniform.hxx>

#include "pmr/base/errors.hpp"

namespace pmr::statistics {
namespace {

// OpenTURNS draws from one generator of the process: seeded here, put back at the end.
class Seeded {
 public:
  explicit Seeded(std::uint64_t seed) : before_(OT::RandomGenerator::GetState()) {
    OT::RandomGenerator::SetSeed(seed);
  }
  ~Seeded() { OT::RandomGenerator::SetState(before_); }
  Seeded(const Seeded&) = delete;
  Seeded& operator=(const Seeded&) = delete;

 private:
  OT::RandomGeneratorState before_;
};

OT::Sample latin_hypercube(std::size_t dimension, std::size_t count, std::uint64_t seed) {
  const Seeded seeded(seed);
  const OT::ComposedDistribution cube(
      OT::ComposedDistribution::DistributionCollection(dimension, OT::Uniform(0.0, 1.0)));
  OT::LHSExperiment plain(cube, count);
  plain.setAlwaysShuffle(true);
  // One point or one variable has no pairs to change: the annealing would search for ever.
  if (count < 2 || dimension < 2) return plain.generate();
  OT::SimulatedAnnealingLHS annealed(plain, OT::SpaceFillingPhiP(), OT::GeometricProfile());
  return annealed.generate();
}

void check(const Span& span) {
  ensure(std::isfinite(span.low) && std::isfinite(span.high) && span.low < span.high,
         "a span goes from a low to a higher value");
  ensure(!span.is_logarithmic || span.low > 0.0, "a logarithmic span is above zero");
}

}  // namespace

double value_at(const Span& span, double fraction) {
  if (span.is_logarithmic) return span.low * std::pow(span.high / span.low, fraction);
  return span.low + fraction * (span.high - span.low);
}

double fraction_at(const Span& span, double value) {
  if (span.is_logarithmic) return std::log(value / span.low) / std::log(span.high / span.low);
  return (value - span.low) / (span.high - span.low);
}

Points sample(Sequence sequence, std::span<const Span> spans, std::size_t count,
              std::uint64_t seed) {
  for (const Span& span : spans) check(span);
  Points points(count, std::vector<double>(spans.size()));
  if (count == 0 || spans.empty()) return points;
  const OT::Sample unit = sequence == Sequence::sobol
                              ? OT::SobolSequence(spans.size()).generate(count)
                              : latin_hypercube(spans.size(), count, seed);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < spans.size(); ++k) points[i][k] = value_at(spans[k], unit(i, k));
  return points;
}

std::vector<double> normal_values(std::span<const double> fractions, std::span<const double> mean,
                                  const std::vector<std::vector<double>>& covariance) {
  constexpr double least = 1e-9;  // [1] of the probability: no point is infinitely far
  const auto n = static_cast<Eigen::Index>(mean.size());
  Eigen::MatrixXd matrix(n, n);
  Eigen::VectorXd standard(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    standard[i] = OT::DistFunc::qNormal(std::clamp(fractions[k], least, 1.0 - least));
    for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = covariance[k][static_cast<std::size_t>(j)];
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  ensure(factor.info() == Eigen::Success, "a covariance is positive");
  const Eigen::VectorXd shift = factor.matrixL() * standard;
  std::vector<double> values(mean.begin(), mean.end());
  for (Eigen::Index i = 0; i < n; ++i) values[static_cast<std::size_t>(i)] += shift[i];
  return values;
}

}  // namespace pmr::statistics
