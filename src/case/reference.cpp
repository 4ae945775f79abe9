#include "case/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "case/csv_text.hpp"
#include "case/nearest.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/text.hpp"

namespace pmr::casefile {
namespace {

const std::vector<std::string> known_columns{"layer",        "azimuth", "mass_ratio", "bead_mass",
                                             "granule_mass", "beads",   "granules"};

class ReferenceSheet {
 public:
  ReferenceSheet(Reading& reading, std::string file, const Decomposition& tool)
      : reading_(reading), file_(std::move(file)), tool_(tool) {}

  void read_header(const CsvLine& header) {
    const auto& [line, text] = header;
    for (const std::string& cell : cells_of(text)) read_column(line, heading_of(cell));
    for (const char* name : {"layer", "mass_ratio"})
      if (!has(name)) fault(line, name, "the column is missing");
  }

  void read_row(const CsvLine& row) {
    const auto& [line, text] = row;
    const std::vector<std::string> cells = cells_of(text);
    if (cells.size() != columns_.size())
      return fault(line, "",
                   fmt::format("has {} cells; the header has {}", cells.size(), columns_.size()));
    const auto layer = read_layer(line, cells[at("layer")]);
    const auto sector = has("azimuth") ? read_sector(line, cells[at("azimuth")]) : std::size_t{0};
    const double ratio = read_ratio(line, cells[at("mass_ratio")]);
    if (!layer || !sector) return;
    const auto [earlier, is_new] = lines_.insert({{*layer, *sector}, line});
    if (!is_new)
      return fault(line, "layer", fmt::format("stands twice, first in line {}", earlier->second));
    ratios_[{*layer, *sector}] = ratio;
  }

  // The table, each layer with at least one ratio; faults where one has none.
  MixtureReference finish(std::string name) {
    MixtureReference reference{std::move(name), {}, {}};
    const std::size_t sectors = has("azimuth") ? tool_.sectors : 1;
    for (std::size_t layer = 0; layer < tool_.layer_fraction.size(); ++layer) {
      std::vector<double> row(sectors, nan);
      for (std::size_t s = 0; s < sectors; ++s)
        if (const auto found = ratios_.find({layer, s}); found != ratios_.end())
          row[s] = found->second;
      reference.layers.push_back(mean_of_measured(row));
      if (std::isnan(reference.layers.back()))
        fault(0, "layer", fmt::format("layer {} has no mass ratio", layer + 1));
      if (has("azimuth")) reference.sections.push_back(std::move(row));
    }
    return reference;
  }

 private:
  void fault(unsigned line, const std::string& key, const std::string& problem) {
    reading_.fault({file_, line, 1}, key, problem);
  }
  bool has(const std::string& name) const {
    return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
  }
  std::size_t at(const std::string& name) const {
    return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), name) -
                                    columns_.begin());
  }

  void read_column(unsigned line, const Heading& heading) {
    const bool is_known =
        std::find(known_columns.begin(), known_columns.end(), heading.name) != known_columns.end();
    if (!is_known) fault(line, heading.name, unknown_word("column", heading.name, known_columns));
    if (has(heading.name)) fault(line, heading.name, "the column stands twice");
    columns_.push_back(heading.name);
    if (heading.name == "azimuth") read_angle_unit(line, heading);
    const bool is_number = heading.name == "layer" || heading.name == "mass_ratio";
    if (is_number && heading.unit.value_or("1") != "1")
      fault(line, heading.name, fmt::format("is in '{}'; wanted bare numbers", *heading.unit));
  }

  void read_angle_unit(unsigned line, const Heading& heading) {
    if (!heading.unit) return fault(line, "azimuth", "has no unit; wanted 'azimuth [deg]'");
    const Scale scale = reading_.units.scale(*heading.unit, Dimension::angle);
    if (!scale.problem.empty()) return fault(line, "azimuth", scale.problem);
    angle_unit_ = scale.factor;
  }

  std::optional<std::size_t> read_layer(unsigned line, const std::string& cell) {
    const double number = finite_number(cell).value_or(0.0);
    const std::size_t layers = tool_.layer_fraction.size();
    if (number >= 1.0 && number <= static_cast<double>(layers) && number == std::floor(number))
      return static_cast<std::size_t>(number) - 1;
    fault(line, "layer",
          fmt::format("'{}' is no layer of the tool; wanted a whole number from 1 to {}", cell,
                      layers));
    return std::nullopt;
  }

  std::optional<std::size_t> read_sector(unsigned line, const std::string& cell) {
    const double width = 2.0 * pi / tool_.sectors;  // [rad]
    const double place = finite_number(cell).value_or(nan) * angle_unit_ / width;
    const double sectors = tool_.sectors, nearest_place = std::round(place);
    const bool is_centre = std::abs(place - nearest_place) < 0.01 && std::abs(place) <= sectors;
    if (is_centre) return static_cast<std::size_t>(nearest_place + sectors) % tool_.sectors;
    fault(line, "azimuth",
          fmt::format("'{}' is no sector's centre; the tool's {} sectors have theirs every {:.6g} "
                      "deg from 0 on",
                      cell, tool_.sectors, 360.0 / sectors));
    return std::nullopt;
  }

  double read_ratio(unsigned line, const std::string& cell) {
    if (cell.empty() || cell == "nan") return nan;
    const std::optional<double> ratio = finite_number(cell);
    if (!ratio || !(*ratio > 0.0))
      fault(line, "mass_ratio",
            fmt::format("'{}' is no mass ratio; wanted a number above 0, or nothing where none was "
                        "measured",
                        cell));
    return ratio.value_or(nan);
  }

  static double mean_of_measured(const std::vector<double>& row) {
    double sum = 0.0, count = 0.0;
    for (const double ratio : row)
      if (std::isfinite(ratio)) sum += ratio, ++count;
    return count > 0.0 ? sum / count : nan;
  }

  Reading& reading_;
  std::string file_;
  const Decomposition& tool_;
  double angle_unit_ = 1.0;  // [rad]
  std::vector<std::string> columns_;
  std::map<std::pair<std::size_t, std::size_t>, double> ratios_;   // by layer and sector
  std::map<std::pair<std::size_t, std::size_t>, unsigned> lines_;  // where they stand
};

}  // namespace

std::optional<MixtureReference> read_reference_csv(Reading& reading,
                                                   const std::filesystem::path& file,
                                                   const Decomposition& tool) {
  const auto lines = csv_lines(file);
  if (!lines) {
    reading.fault({file.string()}, "", "cannot be read; wanted a CSV file of mass ratios");
    return std::nullopt;
  }
  ReferenceSheet sheet(reading, file.string(), tool);
  const std::size_t before = reading.faults();
  if (lines->empty()) reading.fault({file.string()}, "", "is empty; wanted 'layer, mass_ratio'");
  if (!lines->empty()) sheet.read_header(lines->front());
  if (reading.faults() != before) return std::nullopt;
  for (std::size_t k = 1; k < lines->size(); ++k) sheet.read_row((*lines)[k]);
  if (reading.faults() != before) return std::nullopt;
  MixtureReference reference = sheet.finish(file.filename().string());
  return reading.faults() == before ? std::optional(std::move(reference)) : std::nullopt;
}

MixtureReference load_reference(const std::filesystem::path& file, const Decomposition& tool) {
  Reading reading;
  std::optional<MixtureReference> reference = read_reference_csv(reading, file, tool);
  reading.finish();
  return *std::move(reference);
}

void set_reference(Case& setup, const std::filesystem::path& file, const std::string& name) {
  if (!setup.decomposition)
    throw CaseError({{name, "decomposition",
                      "this case has no decomposition tool to compare with a reference"}});
  setup.decomposition->reference = load_reference(file, *setup.decomposition);
}

}  // namespace pmr::casefile
