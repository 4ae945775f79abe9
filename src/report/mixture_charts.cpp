#include "report/mixture_charts.hpp"

#include "report/colour_map.hpp"

namespace pmr::report {
namespace {

constexpr const char* reference_colour = "#009e73";

std::string line_colour(std::size_t bed, std::size_t beds) {
  return beds == 1 ? "#222222" : hex(species_colour(bed));
}

std::vector<double> layer_middles(const MixtureData& mixture) {
  const std::vector<double> cuts = cut_depths(mixture);
  std::vector<double> middles;  // [mm]
  for (std::size_t k = 1; k < cuts.size(); ++k) middles.push_back(0.5 * (cuts[k - 1] + cuts[k]));
  return middles;
}

Value layer_line(const Bed& bed, const std::string& colour) {
  Value line;
  line.set("label", bed.name);
  line.set("colour", colour);
  line.set("w", Value(layer_means(bed.mixture)));
  line.set("depth", Value(layer_middles(bed.mixture)));
  std::vector<double> whole;
  for (const LayerFigures& layer : bed.mixture.layers) whole.push_back(layer.whole);
  line.set("whole", Value(whole));
  if (bed.mixture.residuum) {
    Value residuum;
    residuum.set("w", bed.mixture.residuum->whole);
    residuum.set("depth", cut_depths(bed.mixture).back() + 0.5e3 * bed.mixture.residuum->thickness);
    line.set("residuum", std::move(residuum));
  }
  return line;
}

const MixtureData* with_reference(const std::vector<Bed>& beds) {
  for (const Bed& bed : beds)
    if (bed.mixture.reference) return &bed.mixture;
  return nullptr;
}

Value reference_line(const MixtureReference& reference) {
  Value line;
  line.set("label", "reference: " + reference.name);
  line.set("colour", reference_colour);
  line.set("dash", "4 3");
  return line;
}

Value rows_of(const instruments::SectionRatios& sections) {
  Value::Array rows;
  for (const auto& row : sections) rows.push_back(Value(row));
  return Value(std::move(rows));
}

std::vector<double> azimuths(std::size_t sectors) {
  std::vector<double> centres;  // [deg]
  for (std::size_t s = 0; s < sectors; ++s) centres.push_back(azimuth_of(s, sectors));
  return centres;
}

}  // namespace

std::string layer_chart(const std::vector<Bed>& beds, Charts& charts) {
  Value::Array lines;
  for (std::size_t b = 0; b < beds.size(); ++b)
    lines.push_back(layer_line(beds[b], line_colour(b, beds.size())));
  if (const MixtureData* compared = with_reference(beds)) {
    Value line = reference_line(*compared->reference);
    line.set("w", Value(compared->reference->layers));
    line.set("depth", Value(layer_middles(*compared)));
    lines.push_back(std::move(line));
  }
  Value spec;
  spec.set("kind", "layers");
  spec.set("lines", std::move(lines));
  spec.set("cuts", Value(cut_depths(beds.front().mixture)));
  std::string caption =
      "w = mass of beads over mass of granules, in the middle of each layer. Points: the mean over "
      "its sections, as the study averages; crosses: the layer as a whole, which few particles in "
      "a section do not lift. Square: the residuum as a whole.";
  if (beds.size() > 1) caption += " Layers are marked where " + beds.front().name + " was cut.";
  if (beds.front().is_demonstrator) {
    spec.set("published", true);
    caption +=
        " Grey: statements about the measured beds, no data: \u201cabout 3.5\u201d in the top "
        "layer, \u201cabout 0.5\u201d in the lower ones (Richter et al.).";
  }
  return charts.add("layers", "Mean mass ratio per layer over depth", std::move(spec), caption);
}

std::string azimuth_chart(const std::vector<Bed>& beds, Charts& charts) {
  const auto& first = beds.front().mixture.sections;
  if (first.empty()) return absent("No mass ratio over azimuth: the tool cut no sectors.");
  Value::Array lines;
  for (std::size_t b = 0; b < beds.size(); ++b) {
    Value line;
    line.set("label", beds[b].name);
    line.set("colour", line_colour(b, beds.size()));
    line.set("cells", rows_of(beds[b].mixture.sections));
    lines.push_back(std::move(line));
  }
  if (const MixtureData* compared = with_reference(beds);
      compared != nullptr && !compared->reference->sections.empty()) {
    Value line = reference_line(*compared->reference);
    line.set("cells", rows_of(compared->reference->sections));
    lines.push_back(std::move(line));
  }
  Value spec;
  spec.set("kind", "azimuth");
  spec.set("lines", std::move(lines));
  spec.set("layers", first.size());
  return charts.add(
      "azimuth", "Mass ratio over azimuth, layer by layer", std::move(spec),
      "φ = 0 and 360° is the ramp's side (the same section), 180° its far side. A "
      "ring marks the largest w of a layer, a gap a section without beads or without "
      "granules. Logarithmic axis, the same in all panels: above 1 there are too many "
      "beads, below 1 too many granules.");
}

std::string unrolled_chart(const Bed& bed, const std::string& id, const std::string& title,
                           Charts& charts) {
  const auto& sections = bed.mixture.sections;
  if (sections.empty()) return "";
  Value::Array colours;
  for (int k = 0; k <= 24; ++k) colours.push_back(hex(colour_at(ColourMap::diverging, k / 24.0)));
  Value spec;
  spec.set("kind", "unrolled");
  spec.set("cells", rows_of(sections));
  spec.set("azimuth", Value(azimuths(sections.front().size())));
  spec.set("colours", std::move(colours));
  return charts.add(id, title, std::move(spec),
                    "Orange: too many beads; blue: too many granules; logarithmic round w = 1.");
}

}  // namespace pmr::report
