// Section 3: how well the two species are mixed, and where.
#include "report/mixture.hpp"

#include <algorithm>
#include <cmath>

#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

std::vector<double> numbers(const Value::Array& items) {
  std::vector<double> values;
  for (const Value& item : items) values.push_back(item.as_number());
  return values;
}

// Rows of section mass ratios, layer by layer from the top.
std::vector<std::vector<double>> sections_of(const RunData& run) {
  std::vector<std::vector<double>> rows;
  for (const Value& row : run.summary.items("homogeneity/sections"))
    if (const auto* cells = std::get_if<Value::Array>(&row.data)) rows.push_back(numbers(*cells));
  return rows;
}

std::vector<double> azimuths(std::size_t sectors) {
  std::vector<double> centres;  // [deg]
  for (std::size_t s = 0; s < sectors; ++s)
    centres.push_back(360.0 * static_cast<double>(s) / static_cast<double>(sectors));
  return centres;
}

// Differences between mirror-image sections, relative to the pair's mean.
struct Asymmetry {
  double mean = 0.0, largest = 0.0;  // [1]
};
Asymmetry asymmetry(const std::vector<std::vector<double>>& rows) {
  Asymmetry result;
  std::size_t pairs = 0;
  for (const auto& row : rows)
    for (std::size_t s = 1; 2 * s < row.size(); ++s) {
      const double a = row[s], b = row[row.size() - s];
      if (!(a + b > 0.0)) continue;
      const double difference = std::abs(a - b) / (0.5 * (a + b));
      result.mean += difference;
      result.largest = std::max(result.largest, difference);
      ++pairs;
    }
  if (pairs > 0) result.mean /= static_cast<double>(pairs);
  return result;
}

// Where the mean of w over layers 2 to 4 is largest [deg].
std::optional<double> peak_azimuth(const std::vector<std::vector<double>>& rows) {
  if (rows.size() < 4 || rows[1].empty()) return std::nullopt;
  std::vector<double> sum(rows[1].size(), 0.0);
  for (std::size_t layer = 1; layer <= 3; ++layer)
    for (std::size_t s = 0; s < std::min(sum.size(), rows[layer].size()); ++s)
      sum[s] += rows[layer][s];
  const auto largest = std::max_element(sum.begin(), sum.end()) - sum.begin();
  return azimuths(sum.size())[static_cast<std::size_t>(largest)];
}

std::string azimuth_chart(const RunData& run, Charts& charts) {
  const auto rows = sections_of(run);
  if (rows.empty()) return absent("No mass ratio over azimuth: the tool cut no sectors.");
  Value::Array lines;
  for (std::size_t layer = 0; layer < rows.size(); ++layer) {
    const double depth =
        rows.size() > 1 ? static_cast<double>(layer) / static_cast<double>(rows.size() - 1) : 0;
    Value line;
    line.set("label", "layer " + std::to_string(layer + 1));
    line.set("colour", hex(colour_at(ColourMap::viridis, 0.88 * depth)));
    line.set("x", Value(azimuths(rows[layer].size())));
    line.set("y", Value(rows[layer]));
    lines.push_back(std::move(line));
  }
  Value spec;
  spec.set("kind", "azimuth");
  spec.set("lines", std::move(lines));
  return charts.add("azimuth", "Mass ratio over azimuth, layer by layer", std::move(spec),
                    "φ = 0 is the ramp's side, 180° its far side. Layer 1 is on top. Logarithmic "
                    "axis: above 1 there are too many beads, below 1 too many granules.");
}

Value layer_line(const RunData& run, std::size_t index, bool is_alone) {
  std::vector<double> ratio, mass;
  for (const Value& layer : run.summary.items("homogeneity/layers")) {
    ratio.push_back(layer.number("mass_ratio"));
    mass.push_back(layer.number("mass"));
  }
  Value line;
  line.set("label", is_alone ? "this run" : run.name);
  line.set("colour", is_alone ? "#222222" : hex(species_colour(index)));
  line.set("w", Value(ratio));
  line.set("mass", Value(mass));
  return line;
}

std::string layer_table(const RunData& run) {
  std::vector<std::vector<std::string>> rows;
  std::size_t number = 0;
  for (const Value& layer : run.summary.items("homogeneity/layers"))
    rows.push_back({std::to_string(++number), with_unit(Quantity::mass, layer.number("mass")),
                    with_unit(Quantity::length, layer.number("thickness")),
                    with_unit(Quantity::ratio, layer.number("mass_ratio"))});
  return table({"layer", "mass", "thickness", "w"}, rows, "class=\"numbers\"");
}

std::string indices(const RunData& run) {
  std::vector<std::string> parts;
  const double lacey = run.summary.number("homogeneity/lacey_index");
  if (std::isfinite(lacey))
    parts.push_back("Lacey index <strong>" + with_unit(Quantity::ratio, lacey) +
                    "</strong> (0: apart, 1: mixed at random)");
  const auto rows = sections_of(run);
  if (!rows.empty())
    parts.push_back("mirror-image sections differ by <strong>" +
                    with_unit(Quantity::share, asymmetry(rows).mean) + "</strong> on average, " +
                    with_unit(Quantity::share, asymmetry(rows).largest) + " at most");
  const double deviation = run.summary.number("homogeneity/mean_relative_deviation");
  if (std::isfinite(deviation))
    parts.push_back("mean deviation |1 − w/w<sub>ref</sub>| over the layers <strong>" +
                    with_unit(Quantity::share, deviation) + "</strong>");
  return parts.empty() ? "" : element("p", join(parts, "; ") + ".");
}

}  // namespace

bool is_demonstrator(const RunData& run) {
  std::string title = run.setup ? run.setup->title : run.summary.text("case/title");
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return title.find("demonstrator") != std::string::npos;
}

bool has_layers(const RunData& run) { return !run.summary.items("homogeneity/layers").empty(); }

std::string layer_chart(const std::vector<const RunData*>& runs, Charts& charts) {
  Value::Array lines;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (has_layers(*runs[r])) lines.push_back(layer_line(*runs[r], r, runs.size() == 1));
  if (lines.empty()) return "";
  const RunData& first = *runs.front();
  Value spec;
  spec.set("kind", "layers");
  if (first.setup && first.setup->decomposition &&
      !first.setup->decomposition->reference_mass_ratio.empty()) {
    Value line;
    line.set("label", first.setup->decomposition->reference_source);
    line.set("colour", "#009e73");
    line.set("dash", "3 3");
    line.set("w", Value(first.setup->decomposition->reference_mass_ratio));
    lines.push_back(std::move(line));
  }
  spec.set("lines", std::move(lines));
  std::string caption = "w = mass of beads over mass of granules.";
  if (is_demonstrator(first)) {
    spec.set("published", true);
    caption +=
        " Grey: what was measured on the rig, in words: about 3.5 in the top layer, about "
        "0.5 in the lower ones (Richter et al., decomposition of the bed).";
  }
  return charts.add("layers", "Mean mass ratio per layer", std::move(spec), caption);
}

std::string unrolled_chart(const RunData& run, const std::string& id, const std::string& title,
                           Charts& charts) {
  const auto rows = sections_of(run);
  if (rows.empty()) return "";
  Value::Array cells;
  for (const auto& row : rows) cells.push_back(Value(row));
  Value::Array colours;
  for (int k = 0; k <= 24; ++k) colours.push_back(hex(colour_at(ColourMap::diverging, k / 24.0)));
  Value spec;
  spec.set("kind", "unrolled");
  spec.set("cells", std::move(cells));
  spec.set("azimuth", Value(azimuths(rows.front().size())));
  spec.set("colours", std::move(colours));
  return charts.add(id, title, std::move(spec),
                    "Orange: too many beads; blue: too many granules; logarithmic round w = 1.");
}

std::string against_measurement(const RunData& run) {
  const std::optional<double> peak = peak_azimuth(sections_of(run));
  const bool is_far_side = peak && std::abs(*peak - 180.0) < 1.0;
  std::string text = "<strong>" + escape(run.name) + ": ";
  text += is_far_side ? "the azimuthal pattern.</strong> " : "not reproduced.</strong> ";
  text +=
      "The measured beds, and their published simulation, show a peak of w on the far side of the "
      "ramp (φ = 180°) in layers 2 to 4, and in some runs a local minimum there in layer 5. ";
  if (peak)
    text += "In this run the largest w of layers 2 to 4 stands at φ = " + fixed(*peak, 0) + "°. ";
  if (std::isfinite(run.settled_time()))
    text += "The published bed needed about 3 s to come to rest, this one " +
            with_unit(Quantity::time, run.settled_time()) + ". ";
  text +=
      "Chamber height, ramp angle, tube diameters and distances were not published and are "
      "assumed: "
      "only the profile over the layers and the sign of the effect of the release delay can be "
      "compared. No temperature or oxygen was published to compare with.";
  return element("p", text, "class=\"honest\"");
}

Section mixture_section(const RunData& run, Charts& charts) {
  if (!has_layers(run))
    return {"mixture", "Mixture", absent("No mixture: no bed was taken apart in this case.")};
  const std::string pair = element("div", layer_chart({&run}, charts) + layer_table(run));
  const std::string rest =
      element("div", azimuth_chart(run, charts) +
                         unrolled_chart(run, "unrolled", "The bed unrolled", charts));
  std::string html = indices(run) + element("div", pair + rest, "class=\"charts\"");
  if (is_demonstrator(run)) html += against_measurement(run);
  return {"mixture", "Mixture", html};
}

}  // namespace pmr::report
