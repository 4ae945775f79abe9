#include "report/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/text.hpp"

namespace pmr::report {
namespace {

using Polynomial = std::array<Rgb, 7>;

// Viridis and inferno are the maps of van der Walt and Smith (matplotlib 1.5, 2015); the
// sixth-order fits are M. Zucker's (2019, public domain), within 1 % of the tables.
constexpr Polynomial viridis_fit{{{0.2777273272, 0.0054073445, 0.3340998053},
                                  {0.1050930431, 1.4046135299, 1.3845901626},
                                  {-0.3308618287, 0.2148475595, 0.0950951630},
                                  {-4.6342304990, -5.7991009734, -19.3324409563},
                                  {6.2282699363, 14.1799333668, 56.6905526007},
                                  {4.7763849977, -13.7451453777, -65.3530326334},
                                  {-5.4354558559, 4.6458526122, 26.3124352496}}};
constexpr Polynomial inferno_fit{{{0.0002189404, 0.0016510046, -0.0194808984},
                                  {0.1065134195, 0.5639564368, 3.9327123889},
                                  {11.6024930825, -3.9728539657, -15.9423941063},
                                  {-41.7039961314, 17.4363988821, 44.3541451987},
                                  {77.1629356994, -33.4023589421, -81.8073092574},
                                  {-71.3194282450, 32.6260642640, 73.2095198580},
                                  {25.1311262248, -12.2426689524, -23.0703250029}}};

Rgb evaluate(const Polynomial& fit, double t) {
  Rgb colour{0.0, 0.0, 0.0};
  for (std::size_t k = fit.size(); k-- > 0;)
    for (std::size_t c = 0; c < 3; ++c) colour[c] = colour[c] * t + fit[k][c];
  for (double& c : colour) c = std::clamp(c, 0.0, 1.0);
  return colour;
}

// Straight lines between five colours whose lightness falls evenly from the middle to both ends.
Rgb diverge(double t) {
  static constexpr std::array<Rgb, 5> knots{{{0.00, 0.27, 0.53},
                                             {0.36, 0.62, 0.82},
                                             {0.95, 0.95, 0.94},
                                             {0.95, 0.66, 0.30},
                                             {0.66, 0.29, 0.00}}};
  const double at = t * 4.0;
  const auto k = std::min<std::size_t>(3, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c) colour[c] = (1.0 - f) * knots[k][c] + f * knots[k + 1][c];
  return colour;
}

}  // namespace

Rgb colour_at(ColourMap map, double fraction) {
  const double t = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.5;
  if (map == ColourMap::diverging) return diverge(t);
  // Inferno begins at black, which takes no shading, and ends near white, which the paper swallows.
  return evaluate(map == ColourMap::viridis ? viridis_fit : inferno_fit,
                  map == ColourMap::viridis ? t : 0.14 + 0.80 * t);
}

Rgb species_colour(std::size_t species) {
  // Okabe and Ito (2008): orange, blue, green, purple, vermilion, sky blue.
  static constexpr std::array<Rgb, 6> colours{{{0.902, 0.624, 0.000},
                                               {0.000, 0.447, 0.698},
                                               {0.000, 0.620, 0.451},
                                               {0.800, 0.475, 0.655},
                                               {0.835, 0.369, 0.000},
                                               {0.337, 0.706, 0.914}}};
  return colours[species % colours.size()];
}

std::string hex(const Rgb& colour) {
  std::array<char, 8> text{};
  const auto byte = [&](std::size_t c) {
    return static_cast<unsigned>(std::lround(255 * colour[c]));
  };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(0) & 255u, byte(1) & 255u,
                byte(2) & 255u);
  return text.data();
}

std::string gradient_stops(ColourMap map, std::size_t stops) {
  std::string svg;
  for (std::size_t k = 0; k < stops; ++k) {
    const double f = static_cast<double>(k) / static_cast<double>(stops - 1);
    svg += element(
        "stop", "",
        "offset=\"" + significant(f, 4) + "\" stop-color=\"" + hex(colour_at(map, f)) + "\"");
  }
  return svg;
}

Limits round_limits(double low, double high) {
  const double span = std::max(high - low, 1e-6 * std::max({std::abs(low), std::abs(high), 1e-3}));
  const double power = std::pow(10.0, std::floor(std::log10(span)));
  const double digit = span / power;
  const double step = power * (digit < 2.0 ? 0.1 : digit < 5.0 ? 0.2 : 0.5);
  return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

}  // namespace pmr::report
