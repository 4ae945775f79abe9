// Reading [rig] and checking that its parts fit each other.
#include "case/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr Want steep{Dimension::angle, {0.0, pi / 2, true, true}};

RigDimensions read_dimensions(Table& table, double scale) {
  const auto length = [&](const char* key) { return scale * table.value(key, a_length); };
  RigDimensions size{};
  size.chamber_radius = length("chamber_radius");
  size.lid_height = length("lid_height");
  size.spout_width = length("spout_width");
  size.spout_height = length("spout_height");
  size.ramp_angle = table.value("ramp_angle", steep);
  size.back_wall = length("back_wall");
  size.far_wall_angle = table.value("far_wall_angle", steep);
  size.far_wall = length("far_wall");
  size.side_wall_angle = table.value("side_wall_angle", steep);
  size.side_wall = length("side_wall");
  size.roof_height = length("roof_height");
  size.tube_radius = length("tube_radius");
  size.tube_length = length("tube_length");
  size.rod_radius = length("rod_radius");
  size.plug_clearance = length("plug_clearance");
  size.plug_cone_height = length("plug_cone_height");
  size.plug_skirt = length("plug_skirt");
  size.plug_stroke = length("plug_stroke");
  size.plug_acceleration = table.value("plug_acceleration", {Dimension::acceleration, positive});
  return size;
}

void read_valves(Table& table, double scale, const WallSetting& setting, Rig& rig) {
  table.need_table("valves");
  for_each_table(table, "valves", [&](Table& valve, const std::string& name) {
    rig.valves.push_back({name, scale * valve.value("x", {Dimension::length, any}),
                          valve.value("release", a_time), Adiabatic{}});
    Reading& reading = valve.reading();
    reading.records_plain_values = false;  // a boundary is no dimension
    rig.valves.back().thermal = read_thermal(valve, "thermal", setting);
    reading.records_plain_values = true;
  });
}

// Height at which a slope from the spout's edge reaches its vertical wall [m].
double bend(const RigDimensions& s, double wall, double angle) {
  return s.foot() + (wall - s.spout_width / 2) * std::tan(angle);
}

// What must hold for the parts to form one closed rig.
void check_fit(Table& table, const RigDimensions& s) {
  const auto demand = [&](bool holds, const char* key, const char* problem) {
    if (!holds) table.fault(key, problem);
  };
  demand(s.spout_width / std::sqrt(2.0) <= s.chamber_radius, "spout_width",
         "the spout's corners stand out of the chamber; wanted at most sqrt(2) chamber_radius");
  demand(s.far_wall > s.spout_width / 2, "far_wall", "wanted more than half of spout_width");
  demand(s.side_wall > s.spout_width / 2, "side_wall", "wanted more than half of spout_width");
  demand(s.roof_height > s.foot(), "roof_height", "wanted above lid_height + spout_height");
  demand(bend(s, s.far_wall, s.far_wall_angle) < s.roof_height, "far_wall",
         "the far wall's slope reaches the roof; wanted less");
  demand(bend(s, s.side_wall, s.side_wall_angle) < s.roof_height, "side_wall",
         "the side walls' slope reaches the roof; wanted less");
  demand(bend(s, s.back_wall, s.ramp_angle) < s.roof_height, "back_wall",
         "the ramp reaches the roof; wanted less");
  demand(s.back_wall > s.spout_width / 2, "back_wall", "wanted more than half of spout_width");
  demand(s.rod_radius < s.rim_radius(), "rod_radius",
         "wanted less than tube_radius - plug_clearance");
  demand(s.plug_cone_height < s.tube_length, "plug_cone_height", "wanted less than tube_length");
  demand(s.plug_stroke > s.plug_cone_height, "plug_stroke",
         "the open plug still fills the tube's end; wanted more than plug_cone_height");
}

void check_valves(Table& table, const Rig& rig) {
  const RigDimensions& s = rig.size;
  const double cell = roof_cell(s);
  if (cell > s.side_wall) table.fault("side_wall", "the tubes do not fit between the side walls");
  for (const Valve& valve : rig.valves) {
    const auto fault = [&](const char* problem) {
      table.reading().fault(table.place(), table.path("valves") + "." + valve.name + ".x", problem);
    };
    if (valve.x - cell < -s.far_wall || valve.x + cell > s.back_wall)
      fault("the tube does not fit into the roof between far_wall and back_wall");
    for (const Valve& other : rig.valves)
      if (valve.x < other.x && valve.x + 2 * cell > other.x) fault("two tubes meet");
  }
}

}  // namespace

double RigDimensions::chamber_volume() const {
  return pi * chamber_radius * chamber_radius * lid_height;
}

std::optional<Rig> read_rig(Table& root, const WallSetting& setting, double closing) {
  const Node* node = root.look_table("rig");
  if (node == nullptr) return std::nullopt;
  Reading& reading = root.reading();
  const std::size_t before = reading.faults();
  reading.records_plain_values = true;
  Rig rig{};
  {
    Table table(reading, *node, "rig");
    const double scale = table.value("scale", a_positive_number);
    rig.size = read_dimensions(table, scale);
    read_valves(table, scale, setting, rig);
    reading.records_plain_values = false;
    rig.material = setting.book.use(table, "material", MaterialBook::Role::surface);
    rig.chamber = read_thermal(table, "chamber_thermal", setting);
    rig.door = read_thermal(table, "door_thermal", setting);
    rig.mixer = read_thermal(table, "mixer_thermal", setting);
    rig.side_patches = read_patches(table, "side_patches", {8, 4});
    rig.floor_patches = read_patches(table, "floor_patches", {3, 4});
    rig.door_patches = read_patches(table, "door_patches", {2, 1});
    rig.closing = closing;
    if (reading.faults() == before) {
      check_fit(table, rig.size);
      check_valves(table, rig);
    }
  }
  if (reading.faults() != before) return std::nullopt;
  return rig;
}

CylinderRegion tube_region(const RigDimensions& size, const Valve& valve) {
  const double bottom = size.roof_height + size.plug_cone_height;
  return {Vec3(valve.x, 0.0, bottom), size.tube_radius, size.rod_radius, size.tube_top() - bottom};
}

std::pair<Vec3, Vec3> rig_domain(const RigDimensions& size) {
  const double y = std::max(size.side_wall, size.chamber_radius);
  const Vec3 low(-std::max(size.far_wall, size.chamber_radius), -y, 0.0);
  const Vec3 high(std::max(size.back_wall, size.chamber_radius), y,
                  size.tube_top() + size.plug_stroke);
  const Vec3 margin = 0.1 * (high - low);
  return {low - margin, high + margin};
}

}  // namespace pmr::casefile
