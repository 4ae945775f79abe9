// Where responses meet their measured levels: lines of one level, crossings of all, and the point
// that comes closest where they do not cross.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "statistics/posterior.hpp"

namespace pmr::statistics {

// From and to, each a point of two variables in their units.
struct Segment {
  std::array<double, 2> from, to;
};

// The line along which a function on a grid of two variables has a level, cell by cell (marching
// squares: Lorensen & Cline, SIGGRAPH 21 (1987) 163, in the plane); in a saddle's cell the corners
// above the level are kept apart unless the mean of the four is above it.
std::vector<Segment> level_line(const Grid& grid, const std::vector<double>& values, double level);

// Points of the grid's box where the means of all responses, as many as variables, are at their
// levels: Newton's method from each cell in which every mean is on both sides of its level; in the
// order of the grid, each once.
Points crossings(const Problem& problem, const Grid& grid);

// The point of the box with the least sum ((mean - level) / s)^2, s the measured deviation, by a
// compass search from the best point of the grid (Kolda, Lewis & Torczon, SIAM Rev. 45 (2003) 385).
std::vector<double> closest(const Problem& problem, const Grid& grid);

}  // namespace pmr::statistics
