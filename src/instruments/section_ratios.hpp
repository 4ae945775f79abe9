// Figures of a bed that was taken apart, from the mass ratios of its sections alone: so they hold
// for a simulated bed, for a measured one, and for what a run's summary tells of it.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "instruments/decomposition.hpp"

namespace pmr::instruments {

// w [1] by layer from the top and sector from the ramp; not finite where it cannot be told.
using SectionRatios = std::vector<std::vector<double>>;

SectionRatios section_ratios(const BedSections& sections);

// Mean w over the sectors that have one [1], as the study averages; NaN without any.
double sector_mean(const std::vector<double>& ratios);

// |w - w'| / ((w + w') / 2) [1] of sections opposite about the ramp's plane; sections on the plane
// have no partner, pairs without two finite ratios are left out.
struct Asymmetry {
  std::vector<double> layers;  // [1] mean over the pairs of each layer; NaN without pairs
  double mean;                 // [1] over all pairs; NaN without
  double largest;              // [1] likewise
};
Asymmetry left_right_asymmetry(const SectionRatios& ratios);

// What counting alone makes of that difference in a bed mixed at random: 2 / sqrt(pi)
// sqrt(1 / beads + 1 / granules) [1], the mean difference of two normal variables with the
// relative variance of a ratio of Poisson counts; for more than about ten of each per section.
double counting_asymmetry(double beads_per_section, double granules_per_section);

// |1 - w / w_reference| [1], the study's measure.
struct Deviation {
  std::vector<double> layers;    // [1] of each layer's sector mean
  double mean;                   // [1] over the layers
  std::vector<double> sections;  // [1] mean over the sections of each layer; empty without data
};
Deviation deviation(const SectionRatios& ratios, const MixtureReference& reference);

// The sector with the largest w of a layer; none where no ratio is finite.
std::optional<std::size_t> peak_sector(const std::vector<double>& ratios);

}  // namespace pmr::instruments
