// What measured levels say of the variables that a simulation was run over: a density on a grid,
// its regions, its modes, and where to run next.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "statistics/grid.hpp"

namespace pmr::statistics {

// A measured level, and how far the simulation's mean may lie from it besides the surrogate's own
// deviation: errors of measurement and model [unit of the response].
struct Measured {
  double level;
  double deviation;
};

// Of a variable, before anything was measured: evenly over its span (by the logarithm of one that
// is logarithmic), or normal with mean and deviation in the variable's unit, cut at the box.
struct Normal {
  double mean;
  double deviation;
};
using Priors = std::vector<std::optional<Normal>>;  // one to a variable; none: even

// All that the density follows from: a response to each measured level.
struct Problem {
  std::vector<Response> responses;
  std::vector<Measured> measured;
  Priors priors;
};

// ln L = -1/2 sum ((mean - level)^2 / s^2 + ln s^2), s^2 = deviation^2 + that of the response, plus
// the priors' logarithm, at each point of the grid; a constant is left out.
std::vector<double> log_density(const Grid& grid, std::span<const Field> fields,
                                std::span<const Measured> measured, const Priors& priors);

struct Posterior {
  std::vector<double> log_density;  // at each point of the grid
  std::vector<double> weight;       // share of the mass that each point stands for, sum 1 [1]
  double log_mass;                  // logarithm of the density's mean over the box

  double mass_on_edge(const Grid& grid) const;  // [1] of the points on the box's faces
  // The least logarithm of the density in the smallest region that holds this part of the mass.
  double region_level(double part) const;
};
Posterior normalised(const Grid& grid, std::vector<double> log_density);

// A region of high density that is set off from others.
struct Mode {
  std::vector<double> best, mean;               // the densest point, the mean [variables' units]
  std::vector<std::vector<double>> covariance;  // [units squared]
  double mass;                                  // of the posterior [1]

  double deviation(std::size_t variable) const;
};

// Modes by mass, heaviest first; those of less than a thousandth are left out. Two peaks are one
// mode unless the density between them falls below exp(-2) of the lower one. A mode that is narrow
// on the grid of `steps` is looked at again on one of its own.
std::vector<Mode> find_modes(const Problem& problem, const std::vector<Span>& box,
                             std::size_t steps);

// The point of the grid where a run would tell most: the largest density times
// sum (deviation of the response)^2 / s^2 with s the measured deviation.
std::size_t most_telling(const Posterior& posterior, std::span<const Field> fields,
                         std::span<const Measured> measured);

}  // namespace pmr::statistics
