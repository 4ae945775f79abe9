// Sizes of the particles of a species: distributions by MASS, as sieves and lasers measure them.
#pragma once
#include <cstdint>
#include <variant>
#include <vector>

namespace pmr::physics {

// All of one size.
struct Mono {
  double diameter;  // [m]
};
// Classes of one diameter each.
struct SizeClasses {
  std::vector<double> diameter;       // [m]
  std::vector<double> mass_fraction;  // [1] positive, sum 1
};
// Gauss: Q3(d) = Phi((d - mean) / deviation).
struct NormalSizes {
  double mean, deviation;  // [m] of the mass distribution
};
// Q3(d) = Phi(ln(d / median) / log_deviation); its Sauter diameter is median
// exp(-log_deviation^2/2) (Hatch & Choate, J. Franklin Inst. 207 (1929) 369).
struct LogNormalSizes {
  double median;         // [m] d50 of mass
  double log_deviation;  // [1] standard deviation of ln d
};
// Rosin, Rammler & Sperling (1933), a Weibull distribution: Q3(d) = 1 - exp(-(d / scale)^exponent).
struct RosinRammlerSizes {
  double scale;     // [m] d63.2
  double exponent;  // [1] uniformity
};
// Measured: Q3 linear in d between the points, as a sieve leaves it open.
struct SizeCurve {
  std::vector<double> diameter;  // [m] ascending
  std::vector<double> passing;   // [1] Q3, from 0 to 1, not descending
};
using SizeLaw =
    std::variant<Mono, SizeClasses, NormalSizes, LogNormalSizes, RosinRammlerSizes, SizeCurve>;

// A law, cut off at both ends; what is left counts as the whole.
struct SizeDistribution {
  SizeLaw law;
  double smallest, largest;  // [m]
};

// Diameter [m] below which the part q [1] of the mass lies, within the bounds.
double diameter_at(const SizeDistribution& sizes, double q);

// Bounds that leave out a thousandth of the mass at either end [m]; those of the data where there
// are classes or a curve.
SizeDistribution cut_at_tails(const SizeLaw& law);

// Diameters [m] that come as close to a mass [kg] as one particle allows: particle k is drawn from
// the stream (seed, species), so more mass keeps the first ones. Numbers follow mass over d^3.
struct SizeSample {
  std::uint64_t seed;
  std::uint64_t species;
  double density;  // [kg/m3]
};
std::vector<double> sizes_of_mass(const SizeDistribution& sizes, const SizeSample& sample,
                                  double mass);
std::vector<double> sizes_of_count(const SizeDistribution& sizes, const SizeSample& sample,
                                   std::size_t count);

// Sum of d^3 over sum of d^2 [m].
double sauter_diameter(const std::vector<double>& diameters);

}  // namespace pmr::physics
