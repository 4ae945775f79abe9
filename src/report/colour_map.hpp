// Colour maps: perceptually even ones for values, a diverging one for differences and ratios, and
// species colours that colour-blind readers can tell apart.
#pragma once
#include <array>
#include <cstddef>
#include <string>

namespace pmr::report {

using Rgb = std::array<double, 3>;  // sRGB, 0 to 1

enum class ColourMap {
  viridis,    // delta
  inferno,    // temperature
  diverging,  // blue (0) over grey (0.5) to orange (1)
};

Rgb colour_at(ColourMap map, double fraction);  // fraction is held to [0, 1]
Rgb species_colour(std::size_t species);
std::string hex(const Rgb& colour);  // "#0072b2"

// Colours of a bar from 0 to 1, for gradients and for the page's scripts.
std::string gradient_stops(ColourMap map, std::size_t stops);  // SVG <stop> elements

// Where a value lies between the ends of its scale.
struct Limits {
  double low, high;
  double fraction(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};
// The smallest limits on round numbers that hold [low, high].
Limits round_limits(double low, double high);

}  // namespace pmr::report
