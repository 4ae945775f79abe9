// Phases, instruments and output.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "case/nearest.hpp"
#include "case/parts.hpp"
#include "case/reference.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr Want a_speed{Dimension::speed, positive};

// Without one the phase takes its whole duration: no speed is below zero.
RestCriterion read_rest(Table& table) {
  const bool is_given = table.look("rest_speed") != nullptr || table.look("rest_hold") != nullptr;
  if (!is_given) return {0.0, 0.0};
  return {table.value("rest_speed", a_speed), table.value("rest_hold", a_duration)};
}

// A plate of the conductivity instrument, by the name of its surface.
std::uint32_t read_plate(Table& table, const std::string& key, const Walls& walls) {
  std::vector<std::string> names;
  for (const Surface& surface : walls.surfaces) names.push_back(surface.name);
  const std::string name = table.word(key, "the name of a wall");
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end() && !name.empty()) table.fault(key, unknown_word("wall", name, names));
  return static_cast<std::uint32_t>(found - names.begin());
}

}  // namespace

std::optional<FillPhase> read_fill(Table& root) {
  const Node* node = root.look_table("fill");
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "fill");
  return FillPhase{table.value("duration", a_duration), read_rest(table)};
}

std::optional<MixPhase> read_mix(Table& root) {
  const Node* node = root.look_table("mix");
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "mix");
  MixPhase mix{};
  // A settled bed may go straight on to the reaction.
  mix.duration =
      table.value("duration", {Dimension::time, root.has("bed") ? not_negative : positive});
  mix.not_before = table.value("not_before", {Dimension::time, not_negative}, 0.0);
  mix.rest = read_rest(table);
  mix.heat_interval = table.value("heat_interval", a_duration, 0.02);
  return mix;
}

std::optional<ReactPhase> read_react(Table& root) {
  const Node* node = root.look_table(root.moves_nothing("react"));
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "react");
  ReactPhase react{};
  react.end = table.value("end", a_duration);
  react.first_interval = table.value("first_interval", a_duration, 0.02);
  react.growth = table.value("growth", {Dimension::none, not_negative}, 0.3);
  react.longest_interval = table.value("longest_interval", a_duration, 120.0);
  return react;
}

std::optional<Decomposition> read_decomposition(Table& root) {
  const Node* node = root.look_table(root.moves_nothing("decomposition"));
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "decomposition");
  Decomposition tool{};
  tool.axis_point = table.vector("axis_point", Dimension::length);
  tool.ramp_azimuth = table.value("ramp_azimuth", {Dimension::angle, any});
  tool.layer_fraction = table.values("layer_fraction", {Dimension::none, {0, 1, true}});
  const double sum = std::accumulate(tool.layer_fraction.begin(), tool.layer_fraction.end(), 0.0);
  if (sum > 1.0) table.fault("layer_fraction", fmt::format("adds up to {}, more than 1", sum));
  tool.sectors = static_cast<std::uint32_t>(table.count("sectors", 1));
  tool.reference_source = table.word_or("reference_source", "");
  const std::string reference = table.file_if_any("reference");
  const bool is_whole = !tool.layer_fraction.empty() && tool.sectors > 0;
  if (!reference.empty() && is_whole)
    tool.reference = read_reference_csv(root.reading(), reference, tool);
  return tool;
}

std::vector<Thermocouple> read_thermocouples(Table& root) {
  std::vector<Thermocouple> all;
  for_each_table(
      root, root.moves_nothing("thermocouples"), [&](Table& table, const std::string& name) {
        Thermocouple probe{name, table.vector("position", Dimension::length),
                           table.value("radius", a_length)};
        probe.is_plane =
            table.has("reading") && table.choice("reading", {"mean", "plane"}) == "plane";
        table.look("reading");
        all.push_back(probe);
      });
  return all;
}

std::optional<ConductivityInstrument> read_conductivity(Table& root, const Walls& walls) {
  const Node* node = root.look_table(root.moves_nothing("conductivity"));
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "conductivity");
  ConductivityInstrument tool{};
  tool.hot = read_plate(table, "hot", walls);
  tool.cold = read_plate(table, "cold", walls);
  tool.difference = table.value("difference", {Dimension::temperature_difference, positive});
  tool.temperatures = table.values("temperatures", a_temperature);
  tool.pressures = table.values("pressures", {Dimension::pressure, positive});
  for (std::uint32_t s = 0; s < walls.surfaces.size(); ++s) {
    const Surface& surface = walls.surfaces[s];
    if (s == tool.hot || s == tool.cold || std::holds_alternative<Adiabatic>(surface.thermal))
      continue;
    root.fault("conductivity",
               fmt::format("wants all walls but its plates adiabatic; '{}' is not", surface.name));
  }
  return tool;
}

OutputCase read_output(Table& root) {
  const Node empty;
  const Node* node = root.look_table("output");
  Table table(root.reading(), node == nullptr ? empty : *node, "output");
  OutputCase output{};
  output.snapshot_interval = table.value("snapshot_interval", a_duration, 0.04);
  output.snapshot_times = table.values(table.moves_nothing("snapshot_times"), a_time, {});
  output.checkpoint_wall_time =
      table.value(table.moves_nothing("checkpoint_wall_time"), a_duration, 60.0);
  output.cut_point =
      table.vector(table.moves_nothing("cut_point"), Dimension::length, Vec3::Zero());
  output.cut_normal = Vec3::UnitY();
  if (table.look(table.moves_nothing("cut_normal")) != nullptr)
    output.cut_normal = table.direction("cut_normal");
  return output;
}

}  // namespace pmr::casefile
