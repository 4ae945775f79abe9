// Sampled sizes against the laws they are drawn from.
#include "physics/size_distribution.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::physics;

namespace {

constexpr double density = 3460.0;  // [kg/m3]
constexpr double count = 100000;
const SizeSample sample{7, 1, density};

double mass_in(const std::vector<double>& diameters) {
  double sum = 0.0;
  for (const double d : diameters) sum += density * pi / 6.0 * d * d * d;
  return sum;
}

// Part of the mass below d, and its standard error: each particle is a draw with weight m_i.
struct Passing {
  double part, error;
};
Passing passing(const std::vector<double>& diameters, double d) {
  double below = 0.0, whole = 0.0, squares = 0.0;
  for (const double x : diameters) {
    below += x < d ? x * x * x : 0.0;
    whole += x * x * x;
  }
  const double part = below / whole;
  for (const double x : diameters) {
    const double residue = x * x * x * ((x < d ? 1.0 : 0.0) - part);
    squares += residue * residue;
  }
  return {part, std::sqrt(squares) / whole};
}

void check_passing(const std::vector<double>& diameters, double d, double expected) {
  const Passing found = passing(diameters, d);
  INFO("d = " << d << ": " << found.part << " +- " << found.error << ", law " << expected);
  CHECK(std::abs(found.part - expected) < 4.0 * found.error);
  CHECK(found.error < 0.01);
}

}  // namespace

TEST_CASE("Sizes of a log-normal distribution have its mass fractions and its Sauter diameter") {
  // Wide bounds, so that the closed form of Hatch & Choate (1929) holds:
  // d32 = median exp(-s^2/2); 5 deviations leave out 6e-7 of the mass.
  const double median = 1.5e-3, s = 0.25;
  const SizeDistribution sizes{LogNormalSizes{median, s}, median * std::exp(-5 * s),
                               median * std::exp(5 * s)};
  const auto d = sizes_of_count(sizes, sample, count);
  CHECK(sauter_diameter(d) == Approx(median * std::exp(-0.5 * s * s)).epsilon(0.004));
  for (const double z : {-1.5, -0.5, 0.0, 1.0, 2.0})
    check_passing(d, median * std::exp(z * s), 0.5 * std::erfc(-z / std::sqrt(2.0)));
  // Mean of the number distribution of a mass distribution: median exp(-5 s^2/2) (ibid.).
  double mean = 0.0;
  for (const double x : d) mean += x / count;
  CHECK(mean == Approx(median * std::exp(-2.5 * s * s)).epsilon(4 * s / std::sqrt(count)));
}

TEST_CASE("Sizes of a normal distribution have its mass fractions between its bounds") {
  const double mean = 2e-3, deviation = 0.2e-3;
  const SizeDistribution sizes{NormalSizes{mean, deviation}, mean - 2 * deviation,
                               mean + deviation};
  const auto d = sizes_of_count(sizes, sample, count);
  const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  for (const double z : {-1.0, 0.0, 0.5})
    check_passing(d, mean + z * deviation, (phi(z) - phi(-2)) / (phi(1) - phi(-2)));
  CHECK(*std::min_element(d.begin(), d.end()) >= sizes.smallest);
  CHECK(*std::max_element(d.begin(), d.end()) <= sizes.largest);
}

TEST_CASE("Sizes of a Rosin-Rammler distribution have its mass fractions") {
  const double scale = 1.2e-3, n = 3.0;
  const SizeDistribution sizes = cut_at_tails(RosinRammlerSizes{scale, n});
  const auto d = sizes_of_count(sizes, sample, count);
  for (const double x : {0.6e-3, 1e-3, 1.2e-3, 1.6e-3})
    check_passing(d, x, (1 - std::exp(-std::pow(x / scale, n)) - 0.001) / 0.998);
}

TEST_CASE("Classes are met in mass, not in number") {
  const SizeDistribution sizes = cut_at_tails(SizeClasses{{1e-3, 2e-3, 3e-3}, {0.2, 0.5, 0.3}});
  const auto d = sizes_of_count(sizes, sample, count);
  check_passing(d, 1.5e-3, 0.2);
  check_passing(d, 2.5e-3, 0.7);
  // Numbers go with mass fraction over d^3: 0.2 : 0.5/8 : 0.3/27.
  const auto small = std::count(d.begin(), d.end(), 1e-3);
  const double share = 0.2 / (0.2 + 0.5 / 8 + 0.3 / 27);
  CHECK(std::abs(static_cast<double>(small) / count - share) <
        4 * std::sqrt(share * (1 - share) / count));
}

TEST_CASE("A measured curve is linear in mass between its points") {
  const SizeDistribution sizes = cut_at_tails(SizeCurve{{0.5e-3, 1e-3, 2e-3}, {0.0, 0.25, 1.0}});
  const auto d = sizes_of_count(sizes, sample, count);
  check_passing(d, 0.75e-3, 0.125);
  check_passing(d, 1e-3, 0.25);
  check_passing(d, 1.5e-3, 0.625);
}

TEST_CASE("A mass is met to half a particle, and more mass keeps the first sizes") {
  const SizeDistribution sizes = cut_at_tails(LogNormalSizes{1.5e-3, 0.3});
  const double largest = density * pi / 6.0 * std::pow(sizes.largest, 3);
  std::vector<double> before;
  for (const double mass : {1e-4, 3e-3, 0.05}) {
    const auto d = sizes_of_mass(sizes, sample, mass);
    CHECK(std::abs(mass_in(d) - mass) <= 0.5 * largest);
    CHECK(std::equal(before.begin(), before.end(), d.begin()));
    before = d;
  }
  const auto other = sizes_of_mass(sizes, {8, 1, density}, 0.05);
  CHECK(other[0] != before[0]);
  CHECK(sizes_of_mass(cut_at_tails(Mono{1.47e-3}), sample, 1.0).size() == 173769);
}
