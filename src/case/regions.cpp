#include "case/regions.hpp"

#include <limits>

#include "case/nearest.hpp"

namespace pmr::casefile {
namespace {

std::optional<Region> rig_region(Table& table, const Rig& rig) {
  const std::string name = table.word("rig", "the name of a valve");
  std::vector<std::string> names;
  for (const Valve& valve : rig.valves) {
    if (valve.name == name) return tube_region(rig.size, valve);
    names.push_back(valve.name);
  }
  table.fault("rig", unknown_word("valve", name, names));
  return std::nullopt;
}

Region read_cylinder_region(Table& table) {
  CylinderRegion region{};
  region.base = table.vector("base", Dimension::length);
  region.radius = table.value("radius", a_length);
  region.inner_radius = table.value("inner_radius", {Dimension::length, not_negative}, 0.0);
  region.height = table.value("height", a_length);
  if (region.inner_radius >= region.radius) table.fault("inner_radius", "wanted below radius");
  return region;
}

Region read_box_region(Table& table) {
  const BoxRegion region{table.vector("low", Dimension::length),
                         table.vector("high", Dimension::length)};
  if ((region.high - region.low).minCoeff() <= 0.0)
    table.fault("high", "wanted each component above low");
  return region;
}

}  // namespace

std::optional<Region> read_region(Table& species, const std::optional<Rig>& rig,
                                  bool rig_is_faulty) {
  const Node* node = species.look_table("region");
  if (node == nullptr) return std::nullopt;
  Table table(species.reading(), *node, species.path("region"));
  if (table.has("rig") && rig_is_faulty) {
    table.ignore_rest();
    return std::nullopt;
  }
  if (table.has("rig") && rig) return rig_region(table, *rig);
  if (table.has("low") || table.has("high")) return read_box_region(table);
  if (!table.has("rig")) return read_cylinder_region(table);
  table.word("rig", "");
  table.fault("rig", "the case has no [rig]");
  return std::nullopt;
}

std::optional<Pour> read_pour(Table& species) {
  const Node* node = species.look_table("pour");
  if (node == nullptr) return std::nullopt;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Table table(species.reading(), *node, species.path("pour"));
  Pour pour{};
  if (table.has("low") || table.has("high"))
    pour.region = read_box_region(table);
  else
    pour.region = read_cylinder_region(table);
  if (table.has("mass_rate") && table.has("particle_rate"))
    table.fault("particle_rate", "wanted mass_rate or particle_rate, not both");
  pour.particle_rate = table.value("particle_rate", {Dimension::event_rate, positive}, none);
  pour.mass_rate = table.has("particle_rate")
                       ? table.value("mass_rate", {Dimension::mass_rate, positive}, none)
                       : table.value("mass_rate", {Dimension::mass_rate, positive});
  pour.velocity = table.vector("velocity", Dimension::speed, Vec3::Zero());
  pour.begin = table.value("begin", a_time, -std::numeric_limits<double>::infinity());
  return pour;
}

}  // namespace pmr::casefile
