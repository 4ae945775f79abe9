#include "instruments/mixing.hpp"

#include <limits>

namespace pmr::instruments {
namespace {

std::vector<Portion> filled_sections(const BedSections& sections) {
  std::vector<Portion> filled;
  for (const Layer& layer : sections.layers)
    for (const Portion& section : layer.sectors)
      if (section.mass() > 0.0) filled.push_back(section);
  return filled;
}

}  // namespace

double lacey_index(const BedSections& sections) {
  const std::vector<Portion> cells = filled_sections(sections);
  Portion all;
  for (const Portion& cell : cells) {
    all.bead_mass += cell.bead_mass;
    all.granule_mass += cell.granule_mass;
    all.beads += cell.beads;
    all.granules += cell.granules;
  }
  if (cells.size() < 2 || all.beads == 0 || all.granules == 0)
    return std::numeric_limits<double>::quiet_NaN();
  const double p = all.bead_mass / all.mass();
  double variance = 0.0;
  for (const Portion& cell : cells) {
    const double excess = cell.bead_mass / cell.mass() - p;
    variance += cell.mass() / all.mass() * excess * excess;
  }
  const double bead = all.bead_mass / static_cast<double>(all.beads);           // [kg]
  const double granule = all.granule_mass / static_cast<double>(all.granules);  // [kg]
  const double section = all.mass() / static_cast<double>(cells.size());        // [kg]
  const double n = section / (p * granule + (1.0 - p) * bead);
  const double apart = p * (1.0 - p);
  return (apart - variance) / (apart - apart / n);
}

}  // namespace pmr::instruments
