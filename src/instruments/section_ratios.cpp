#include "instruments/section_ratios.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::instruments {
namespace {

double mean_of_finite(const std::vector<double>& values) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const double value : values)
    if (std::isfinite(value)) {
      sum += value;
      ++count;
    }
  return count == 0 ? nan : sum / static_cast<double>(count);
}

// Of the sectors 1 and n - 1, 2 and n - 2 ... [1]
std::vector<double> pair_differences(const std::vector<double>& ratios) {
  std::vector<double> differences;
  const std::size_t n = ratios.size();
  for (std::size_t k = 1; 2 * k < n; ++k) {
    const double w = ratios[k], mirrored = ratios[n - k];
    if (!std::isfinite(w) || !std::isfinite(mirrored)) continue;
    differences.push_back(w == mirrored ? 0.0 : std::abs(w - mirrored) / (0.5 * (w + mirrored)));
  }
  return differences;
}

}  // namespace

SectionRatios section_ratios(const BedSections& sections) {
  SectionRatios ratios;
  for (const Layer& layer : sections.layers) {
    std::vector<double> row;
    for (const Portion& section : layer.sectors) row.push_back(section.mass_ratio());
    ratios.push_back(std::move(row));
  }
  return ratios;
}

double sector_mean(const std::vector<double>& ratios) { return mean_of_finite(ratios); }

Asymmetry left_right_asymmetry(const SectionRatios& ratios) {
  Asymmetry result{{}, nan, nan};
  std::vector<double> all;
  for (const auto& layer : ratios) {
    const std::vector<double> differences = pair_differences(layer);
    result.layers.push_back(mean_of_finite(differences));
    all.insert(all.end(), differences.begin(), differences.end());
  }
  if (all.empty()) return result;
  result.mean = mean_of_finite(all);
  result.largest = *std::max_element(all.begin(), all.end());
  return result;
}

double counting_asymmetry(double beads_per_section, double granules_per_section) {
  return 2.0 / std::sqrt(pi) * std::sqrt(1.0 / beads_per_section + 1.0 / granules_per_section);
}

Deviation deviation(const SectionRatios& ratios, const MixtureReference& reference) {
  ensure(reference.layers.size() == ratios.size(), "the reference has a mass ratio for each layer");
  Deviation result{{}, nan, {}};
  for (std::size_t k = 0; k < ratios.size(); ++k)
    result.layers.push_back(std::abs(1.0 - sector_mean(ratios[k]) / reference.layers[k]));
  result.mean = mean_of_finite(result.layers);
  for (std::size_t k = 0; k < reference.sections.size(); ++k) {
    ensure(reference.sections[k].size() == ratios[k].size(), "the reference has the same sectors");
    std::vector<double> row;
    for (std::size_t s = 0; s < ratios[k].size(); ++s)
      row.push_back(std::abs(1.0 - ratios[k][s] / reference.sections[k][s]));
    result.sections.push_back(mean_of_finite(row));
  }
  return result;
}

std::optional<std::size_t> peak_sector(const std::vector<double>& ratios) {
  std::optional<std::size_t> peak;
  for (std::size_t s = 0; s < ratios.size(); ++s)
    if (std::isfinite(ratios[s]) && (!peak || ratios[s] > ratios[*peak])) peak = s;
  return peak;
}

}  // namespace pmr::instruments
