// What a run's summary tells of its bed taken apart, and how it stands to the reference.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "instruments/section_ratios.hpp"
#include "report/run_data.hpp"

namespace pmr::report {

struct LayerFigures {
  double mass = 0.0, thickness = 0.0;  // [kg], [m]
  double whole = 0.0;                  // [1] w of the layer as a whole
  double mean = 0.0;                   // [1] mean of w over its sections, as the study averages
};

struct MixtureData {
  std::vector<LayerFigures> layers;  // from the top; empty where no bed was taken apart
  std::optional<LayerFigures> residuum;
  instruments::SectionRatios sections;
  instruments::Asymmetry asymmetry;
  double beads_per_section = 0.0, granules_per_section = 0.0;  // [1]; NaN where not known
  std::optional<MixtureReference> reference;
  std::optional<instruments::Deviation> deviation;  // from the reference
};
MixtureData mixture_of(const RunData& run);

std::vector<double> layer_means(const MixtureData& mixture);  // [1] mean w per layer

// Depths under the bed's top [mm] of the cuts, from 0 on: one more than there are layers.
std::vector<double> cut_depths(const MixtureData& mixture);

double azimuth_of(std::size_t sector, std::size_t sectors);  // [deg] of its centre from the ramp

// Time from the first valve's release to the last's [s]; NaN without two valves.
double release_delay(const RunData& run);

}  // namespace pmr::report
