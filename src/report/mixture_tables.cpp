#include "report/mixture_tables.hpp"

#include <algorithm>
#include <cmath>

#include "report/text.hpp"

namespace pmr::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string ratio(double value) { return with_unit(Quantity::ratio, value); }
std::string share(double value) { return with_unit(Quantity::share, value); }
std::string strong(const std::string& html) { return element("strong", html); }

double at(const std::vector<double>& values, std::size_t k) {
  return k < values.size() ? values[k] : std::nan("");
}

// "225°", of the largest w of a layer.
std::string peak(const MixtureData& mixture, std::size_t layer) {
  if (layer >= mixture.sections.size()) return "–";
  const auto sector = instruments::peak_sector(mixture.sections[layer]);
  if (!sector) return "–";
  return fixed(azimuth_of(*sector, mixture.sections[layer].size()), 0) + "°";
}

double mean_ratio(const Bed& bed, std::size_t layer) {
  return layer < bed.mixture.layers.size() ? bed.mixture.layers[layer].mean : std::nan("");
}

const MixtureReference* reference_of(const std::vector<Bed>& beds) {
  for (const Bed& bed : beds)
    if (bed.mixture.reference) return &*bed.mixture.reference;
  return nullptr;
}

std::size_t most_layers(const std::vector<Bed>& beds) {
  std::size_t layers = 0;
  for (const Bed& bed : beds) layers = std::max(layers, bed.mixture.layers.size());
  return layers;
}

void add_residuum(const LayerFigures& residuum, std::size_t columns, Rows& rows) {
  std::vector<std::string> row{"residuum", with_unit(Quantity::mass, residuum.mass),
                               with_unit(Quantity::length, residuum.thickness),
                               ratio(residuum.whole)};
  row.resize(columns);
  rows.push_back(std::move(row));
}

double whole_ratio(const Bed& bed, std::size_t layer) {
  return layer < bed.mixture.layers.size() ? bed.mixture.layers[layer].whole : std::nan("");
}

// Values of the beds beside each other, then differences from the first.
using RatioOf = double (*)(const Bed&, std::size_t layer);
std::string compared_ratios(const std::vector<Bed>& beds, const char* title, RatioOf ratio_of) {
  std::vector<std::string> head{title};
  for (const Bed& bed : beds) head.push_back(escape(bed.name));
  for (std::size_t b = 1; b < beds.size(); ++b)
    head.push_back(escape(beds[b].name) + " − " + escape(beds[0].name));
  Rows rows;
  for (std::size_t k = 0; k < most_layers(beds); ++k) {
    std::vector<std::string> row{std::to_string(k + 1)};
    for (const Bed& bed : beds) row.push_back(ratio(ratio_of(bed, k)));
    for (std::size_t b = 1; b < beds.size(); ++b)
      row.push_back(difference(Quantity::ratio, ratio_of(beds[b], k) - ratio_of(beds[0], k)));
    rows.push_back(std::move(row));
  }
  return table(head, rows, "class=\"numbers compare\"");
}

std::string compared_deviations(const std::vector<Bed>& beds) {
  const MixtureReference* reference = reference_of(beds);
  if (reference == nullptr) return "";
  std::vector<std::string> head{"layer, |1 − w/w<sub>ref</sub>|", "reference w"};
  for (const Bed& bed : beds) head.push_back(escape(bed.name));
  Rows rows;
  for (std::size_t k = 0; k < reference->layers.size(); ++k) {
    std::vector<std::string> row{std::to_string(k + 1), ratio(reference->layers[k])};
    for (const Bed& bed : beds)
      row.push_back(bed.mixture.deviation ? share(at(bed.mixture.deviation->layers, k)) : "–");
    rows.push_back(std::move(row));
  }
  return table(head, rows, "class=\"numbers compare\"");
}

std::string compared_patterns(const std::vector<Bed>& beds) {
  std::vector<std::string> head{"layer"};
  for (const Bed& bed : beds) head.push_back("largest w at φ, " + escape(bed.name));
  for (const Bed& bed : beds) head.push_back("left–right, " + escape(bed.name));
  Rows rows;
  for (std::size_t k = 0; k < most_layers(beds); ++k) {
    std::vector<std::string> row{std::to_string(k + 1)};
    for (const Bed& bed : beds) row.push_back(peak(bed.mixture, k));
    for (const Bed& bed : beds) row.push_back(share(at(bed.mixture.asymmetry.layers, k)));
    rows.push_back(std::move(row));
  }
  return table(head, rows, "class=\"numbers compare\"");
}

std::vector<std::string> section_row(const std::string& name, const std::vector<double>& ratios,
                                     std::size_t columns) {
  std::vector<std::string> row{name};
  const auto largest = instruments::peak_sector(ratios);
  for (std::size_t s = 0; s < ratios.size(); ++s)
    row.push_back(s == largest ? strong(ratio(ratios[s])) : ratio(ratios[s]));
  row.resize(columns);
  return row;
}

bool is_peak_at_far_side(const std::vector<double>& ratios) {
  const auto sector = instruments::peak_sector(ratios);
  return sector && 2 * *sector == ratios.size();
}

// Whether w on the far side lies under both of its neighbours.
bool is_minimum_at_far_side(const std::vector<double>& ratios) {
  const std::size_t far = ratios.size() / 2;
  return ratios.size() > 2 && ratios.size() % 2 == 0 && ratios[far] < ratios[far - 1] &&
         ratios[far] < ratios[far + 1];
}

std::string verdict(std::size_t reproduced) {
  if (reproduced == 3) return "the azimuthal peak is reproduced. ";
  return reproduced == 0 ? "the azimuthal peak is not reproduced. "
                         : "the azimuthal peak is reproduced in part. ";
}

std::string azimuthal_pattern(const Bed& bed) {
  const auto& sections = bed.mixture.sections;
  std::size_t reproduced = 0;
  std::vector<std::string> peaks;
  for (std::size_t k = 1; k <= 3; ++k) {
    reproduced += is_peak_at_far_side(sections[k]) ? 1 : 0;
    peaks.push_back("layer " + std::to_string(k + 1) + ": φ = " + peak(bed.mixture, k));
  }
  std::string text = strong(escape(bed.name) + ": " + verdict(reproduced));
  text +=
      "The measured beds, and their published simulation, show a peak of w on the far side of the "
      "ramp (φ = 180°) in layers 2 to 4, and in some runs a local minimum there in layer 5. In "
      "this run the largest w stands in " +
      join(peaks, ", ") + ". ";
  if (sections.size() > 4)
    text += std::string("Layer 5 has ") + (is_minimum_at_far_side(sections[4]) ? "a" : "no") +
            " local minimum at 180°. ";
  return text;
}

std::string in_layer(const Bed& bed, std::size_t layer) {
  const LayerFigures& figures = bed.mixture.layers[layer];
  return ratio(figures.mean) + " (" + ratio(figures.whole) + " as a whole) in layer " +
         std::to_string(layer + 1);
}

std::string profile(const Bed& bed) {
  const std::vector<double> means = layer_means(bed.mixture);
  const bool falls = std::is_sorted(means.begin(), means.end(), std::greater<>());
  return std::string("Over depth the mean of w over the sections ") +
         (falls ? "falls from layer to layer" : "does not fall in every layer") + ": " +
         in_layer(bed, 0) + ", " + in_layer(bed, means.size() - 1) +
         ". Stated of the measured beds: about 3.5 on top, about 0.5 in the lower layers, falling "
         "with depth. ";
}

// The layers of the four measured beds and their residuum add up to 1.999 kg on average.
std::string of_another_size(const Bed& bed) {
  constexpr double measured = 1.999;  // [kg]
  double mass = bed.mixture.residuum ? bed.mixture.residuum->mass : 0.0;
  for (const LayerFigures& layer : bed.mixture.layers) mass += layer.mass;
  if (!(mass < 0.9 * measured)) return "";
  return "This bed is one of " + with_unit(Quantity::mass, mass) + ", the measured ones of " +
         with_unit(Quantity::mass, measured) +
         ": a smaller rig of its own, whose figures are no comparison with the measured ones. ";
}

}  // namespace

std::string mixture_indices(const Bed& bed, double lacey_index) {
  const MixtureData& mixture = bed.mixture;
  std::vector<std::string> parts;
  if (std::isfinite(lacey_index))
    parts.push_back("Lacey index " + strong(ratio(lacey_index)) +
                    " (0: apart, 1: mixed at random)");
  if (std::isfinite(mixture.asymmetry.mean))
    parts.push_back(
        "left–right asymmetry: sections opposite about the plane of symmetry differ by " +
        strong(share(mixture.asymmetry.mean)) + " of their mean on average, " +
        strong(share(mixture.asymmetry.largest)) + " at most");
  if (std::isfinite(mixture.beads_per_section) && std::isfinite(mixture.granules_per_section))
    parts.push_back("a section holds " + fixed(mixture.beads_per_section, 0) + " beads and " +
                    fixed(mixture.granules_per_section, 0) +
                    " granules on average, and counting so few would alone make opposite sections "
                    "of a random mixture differ by about " +
                    share(instruments::counting_asymmetry(mixture.beads_per_section,
                                                          mixture.granules_per_section)));
  if (mixture.deviation) {
    parts.push_back("deviation from " + escape(mixture.reference->name) +
                    ", mean |1 − w/w<sub>ref</sub>| over the layers " +
                    strong(share(mixture.deviation->mean)));
  }
  return parts.empty() ? "" : element("p", join(parts, "; ") + ".");
}

std::string layer_table(const Bed& bed) {
  const MixtureData& mixture = bed.mixture;
  std::vector<std::string> head{
      "layer",          "mass",      "thickness", "w, whole layer", "mean w over sections",
      "largest w at φ", "left–right"};
  const bool by_section = mixture.deviation && !mixture.deviation->sections.empty();
  if (mixture.deviation) head.insert(head.end(), {"reference w", "|1 − w/w<sub>ref</sub>|"});
  if (by_section) head.push_back("the same, mean over sections");
  Rows rows;
  for (std::size_t k = 0; k < mixture.layers.size(); ++k) {
    const LayerFigures& layer = mixture.layers[k];
    rows.push_back({std::to_string(k + 1), with_unit(Quantity::mass, layer.mass),
                    with_unit(Quantity::length, layer.thickness), ratio(layer.whole),
                    ratio(layer.mean), peak(mixture, k), share(at(mixture.asymmetry.layers, k))});
    if (mixture.deviation)
      rows.back().insert(rows.back().end(), {ratio(mixture.reference->layers[k]),
                                             share(mixture.deviation->layers[k])});
    if (by_section) rows.back().push_back(share(mixture.deviation->sections[k]));
  }
  if (mixture.residuum) add_residuum(*mixture.residuum, head.size(), rows);
  return table(head, rows, "class=\"numbers compare\"");
}

std::string compared_layers(const std::vector<Bed>& beds) {
  return element("div",
                 compared_ratios(beds, "layer, mean w over sections", mean_ratio) +
                     compared_ratios(beds, "layer, w as a whole", whole_ratio) +
                     compared_patterns(beds) + compared_deviations(beds),
                 "class=\"tables\"");
}

std::string section_table(const std::vector<Bed>& beds) {
  const MixtureReference* reference = reference_of(beds);
  const std::size_t sectors = beds.front().mixture.sections.front().size();
  std::vector<std::string> head{"layer, w at φ ="};
  for (std::size_t s = 0; s < sectors; ++s) head.push_back(fixed(azimuth_of(s, sectors), 0) + "°");
  Rows rows;
  for (std::size_t k = 0; k < most_layers(beds); ++k) {
    const std::string layer = std::to_string(k + 1);
    for (const Bed& bed : beds)
      if (k < bed.mixture.sections.size())
        rows.push_back(section_row(layer + (beds.size() > 1 ? ", " + escape(bed.name) : ""),
                                   bed.mixture.sections[k], head.size()));
    if (reference != nullptr && k < reference->sections.size())
      rows.push_back(section_row(layer + ", reference", reference->sections[k], head.size()));
  }
  return table(head, rows, "class=\"numbers compare\"");
}

std::string against_measurement(const Bed& bed, double settled_time) {
  if (bed.mixture.sections.size() < 4) return "";
  std::string rest = of_another_size(bed);
  if (std::isfinite(settled_time))
    rest += "The published bed needed about 3 s to come to rest, this one " +
            with_unit(Quantity::time, settled_time) + ". ";
  rest +=
      "Chamber height, ramp angle, tube diameters and distances were not published and are "
      "assumed: only the profile over the layers and the sign of the effect of the release delay "
      "can be compared. No temperature or oxygen was published to compare with.";
  return element(
      "div", element("p", azimuthal_pattern(bed)) + element("p", profile(bed)) + element("p", rest),
      "class=\"honest\"");
}

}  // namespace pmr::report
