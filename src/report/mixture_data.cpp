#include "report/mixture_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmr::report {
namespace {

LayerFigures layer_of(const Value& layer) {
  return {layer.number("mass"), layer.number("thickness"), layer.number("mass_ratio"),
          layer.number("sector_mean_ratio")};
}

instruments::SectionRatios sections_of(const RunData& run) {
  instruments::SectionRatios rows;
  for (const Value& row : run.summary.items("homogeneity/sections")) {
    const auto* cells = std::get_if<Value::Array>(&row.data);
    if (cells == nullptr) continue;
    std::vector<double> ratios;
    for (const Value& cell : *cells) ratios.push_back(cell.as_number());
    rows.push_back(std::move(ratios));
  }
  return rows;
}

// A reference for another tool than this run's cannot be compared.
bool is_comparable(const MixtureReference& reference, const instruments::SectionRatios& ratios) {
  if (reference.layers.size() != ratios.size()) return false;
  for (std::size_t k = 0; k < reference.sections.size(); ++k)
    if (reference.sections[k].size() != ratios[k].size()) return false;
  return true;
}

}  // namespace

MixtureData mixture_of(const RunData& run) {
  MixtureData mixture;
  for (const Value& layer : run.summary.items("homogeneity/layers"))
    mixture.layers.push_back(layer_of(layer));
  if (const Value* residuum = run.summary.find("homogeneity/residuum"))
    mixture.residuum = layer_of(*residuum);
  mixture.sections = sections_of(run);
  mixture.asymmetry = instruments::left_right_asymmetry(mixture.sections);
  mixture.beads_per_section = run.summary.number("homogeneity/beads_per_section");
  mixture.granules_per_section = run.summary.number("homogeneity/granules_per_section");
  for (std::size_t k = 0; k < std::min(mixture.layers.size(), mixture.sections.size()); ++k)
    mixture.layers[k].mean = instruments::sector_mean(mixture.sections[k]);
  if (!run.setup || !run.setup->decomposition || !run.setup->decomposition->reference)
    return mixture;
  if (!is_comparable(*run.setup->decomposition->reference, mixture.sections)) return mixture;
  mixture.reference = run.setup->decomposition->reference;
  mixture.deviation = instruments::deviation(mixture.sections, *mixture.reference);
  return mixture;
}

std::vector<double> layer_means(const MixtureData& mixture) {
  std::vector<double> means;
  for (const LayerFigures& layer : mixture.layers) means.push_back(layer.mean);
  return means;
}

std::vector<double> cut_depths(const MixtureData& mixture) {
  std::vector<double> depths{0.0};
  for (const LayerFigures& layer : mixture.layers)
    depths.push_back(depths.back() + 1e3 * layer.thickness);
  return depths;
}

double azimuth_of(std::size_t sector, std::size_t sectors) {
  return 360.0 * static_cast<double>(sector) / static_cast<double>(sectors);
}

double release_delay(const RunData& run) {
  std::vector<double> releases;
  for (std::size_t b = 0; run.setup && b < run.setup->walls.bodies.size(); ++b)
    if (const auto* fall = std::get_if<Fall>(&run.setup->walls.bodies[b].motion))
      releases.push_back(fall->release);
  if (releases.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const auto [first, last] = std::minmax_element(releases.begin(), releases.end());
  return *last - *first;
}

}  // namespace pmr::report
