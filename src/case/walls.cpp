#include "case/walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/bulk_tests.hpp"
#include "case/facing.hpp"
#include "case/grains.hpp"
#include "case/nearest.hpp"
#include "case/polytope.hpp"
#include "case/stl.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

ThermalBoundary read_lining(Table& table, const WallSetting& setting) {
  Lining lining{};
  const std::string wanted = "a list such as [{material = \"fibre-board\", thickness = \"0.1 m\"}]";
  const Node* layers = table.need("layers", wanted);
  const bool is_list = layers != nullptr && layers->kind == Node::Kind::array;
  if (layers != nullptr && (!is_list || layers->items.empty()))
    table.fault("layers", "wanted " + wanted);
  for (std::size_t k = 0; is_list && k < layers->items.size(); ++k) {
    Table layer(table.reading(), layers->items[k], fmt::format("{}.{}", table.path("layers"), k));
    LiningLayer made{};
    made.material = setting.book.use(layer, "material", MaterialBook::Role::lining);
    made.thickness = layer.value("thickness", a_length);
    lining.layers.push_back(made);
  }
  lining.initial_temperature = table.value("initial_temperature", a_temperature);
  lining.outside_film_coefficient =
      table.value("outside_film_coefficient", {Dimension::film_coefficient, not_negative});
  lining.outside_temperature = table.value("outside_temperature", a_temperature);
  return lining;
}

Motion read_fall(Table& table) {
  return Fall{table.value("release", a_time), table.value("stroke", a_length),
              table.direction("direction"),
              table.value("acceleration", {Dimension::acceleration, positive})};
}

Motion read_rotation(Table& table) {
  return Rotate{table.vector("pivot", Dimension::length), table.direction("axis"),
                table.value("rate", {Dimension::rotation_rate, any}), table.value("begin", a_time),
                table.value("finish", a_time, infinity)};
}

Motion read_motion(Table& parent) {
  const Node* node = parent.look_table("motion");
  if (node == nullptr) return Rest{};
  Table table(parent.reading(), *node, parent.path("motion"));
  const std::string kind =
      table.choice("kind", {"rest", "fall", "translate", "oscillate", "rotate"});
  if (kind == "fall") return read_fall(table);
  if (kind == "rotate") return read_rotation(table);
  if (kind == "translate")
    return Translate{table.vector("velocity", Dimension::speed), table.value("begin", a_time),
                     table.value("finish", a_time, infinity)};
  if (kind == "oscillate")
    return Oscillate{table.vector("amplitude", Dimension::length),
                     table.value("frequency", {Dimension::frequency, positive}),
                     table.value("begin", a_time)};
  if (kind.empty()) table.ignore_rest();
  return Rest{};
}

// +1 or -1 for a cylinder or cone whose profile rises along its axis (state/walls.hpp).
double read_facing(Table& table) {
  return table.choice("facing", {"in", "out"}) == "out" ? 1.0 : -1.0;
}

Shape read_plane(Table& table) {
  return Plane{table.vector("point", Dimension::length), table.direction("normal")};
}

// Faces along its axis.
Shape read_disc(Table& table) {
  const double outer = table.value("radius", a_length);
  const double inner = table.value("inner_radius", {Dimension::length, not_negative}, 0.0);
  if (inner >= outer) table.fault("inner_radius", "wanted less than radius");
  return Revolved{table.vector("centre", Dimension::length),
                  table.direction("axis"),
                  inner,
                  0.0,
                  outer,
                  0.0,
                  -1.0};
}

Shape read_cylinder(Table& table) {
  const double radius = table.value("radius", a_length);
  return Revolved{
      table.vector("base", Dimension::length), table.direction("axis"), radius, 0.0, radius,
      table.value("height", a_length),         read_facing(table)};
}

Shape read_cone(Table& table) {
  const Want radius{Dimension::length, not_negative};
  const double bottom = table.value("base_radius", radius);
  const double top = table.value("top_radius", radius);
  return Revolved{
      table.vector("base", Dimension::length), table.direction("axis"), bottom, 0.0, top,
      table.value("height", a_length),         read_facing(table)};
}

std::vector<Shape> read_box(Table& table) {
  const Vec3 low = table.vector("low", Dimension::length);
  const Vec3 high = table.vector("high", Dimension::length);
  if ((high - low).minCoeff() <= 0.0) table.fault("high", "wanted each component above low");
  std::vector<Shape> sides;
  if (!((high - low).minCoeff() > 0.0)) return sides;
  for (const Polygon& face : faces_of(box_half_spaces(low, high)))
    sides.emplace_back(triangulated(face));
  return sides;
}

std::vector<Shape> read_rectangle_wall(Table& table) {
  const Rectangle r = read_rectangle(table);
  if (!r.normal().allFinite()) return {};
  return {triangulated(
      {"",
       r.normal(),
       {r.corner, r.corner + r.along, r.corner + r.along + r.across, r.corner + r.across}})};
}

std::vector<Shape> read_stl_wall(Table& table) {
  const std::string file = table.file("file", "the name of an STL file");
  const double scale = table.value("scale", a_length);  // an STL file has no unit
  if (file.empty()) return {};
  StlFile stl = read_stl(file, scale);
  for (const std::string& problem : stl.problems) table.fault("file", problem);
  if (!stl.problems.empty()) return {};
  const Orientation made = agree(stl.triangles);
  if (made.turned > 0)
    table.reading().warnings.push_back(
        fmt::format("{}: {} of {} triangles faced another side than their neighbours and were "
                    "turned round{}",
                    table.path("file"), made.turned, stl.triangles.size(),
                    made.is_closed ? "" : "; the mesh is not closed: see that it faces the bed"));
  if (made.is_contradictory)
    table.reading().warnings.push_back(
        fmt::format("{}: no way of turning its triangles makes all neighbours face one side",
                    table.path("file")));
  std::vector<Shape> facets;
  for (const Facet& facet : flat_facets(stl.triangles)) facets.emplace_back(facet);
  return facets;
}

std::vector<Shape> read_shapes(Table& table, const std::string& kind) {
  if (kind == "plane") return {read_plane(table)};
  if (kind == "disc") return {read_disc(table)};
  if (kind == "cylinder") return {read_cylinder(table)};
  if (kind == "cone") return {read_cone(table)};
  if (kind == "box") return read_box(table);
  if (kind == "rectangle") return read_rectangle_wall(table);
  if (kind == "stl") return read_stl_wall(table);
  table.ignore_rest();
  return {};
}

void read_wall(Table& table, const std::string& name, const WallSetting& setting, Walls& walls) {
  Surface pattern;
  pattern.body = static_cast<std::uint32_t>(walls.bodies.size());
  pattern.material = setting.book.use(table, "material", MaterialBook::Role::surface);
  pattern.thermal = read_thermal(table, "thermal", setting);
  pattern.from = table.value("from", a_time, -infinity);
  pattern.until = table.value("until", a_time, infinity);
  pattern.patches = read_patches(table, "patches", {1, 1});
  pattern.holds_particles = table.flag("holds_particles", true);
  walls.bodies.push_back({name, read_motion(table)});
  const std::string kind =
      table.choice("kind", {"plane", "disc", "cylinder", "cone", "box", "rectangle", "stl"});
  const std::vector<Shape> shapes = read_shapes(table, kind);
  read_grains(table, setting, {pattern.body, kind, shapes}, walls.grains);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    Surface surface = pattern;
    surface.name = shapes.size() == 1 ? name : fmt::format("{}.{}", name, k);
    surface.shape = shapes[k];
    if (!std::holds_alternative<Revolved>(shapes[k])) surface.patches = {1, 1};
    walls.surfaces.push_back(std::move(surface));
  }
}

// A wall that moves with another has that one's motion.
struct Follower {
  std::size_t body;
  std::string leader;
  Place place;
};

void lead(Reading& reading, const std::vector<Follower>& followers, Walls& walls) {
  for (const Follower& one : followers) {
    const std::string key = "walls." + walls.bodies[one.body].name + ".moves_with";
    std::vector<std::string> names;
    for (const Body& body : walls.bodies) names.push_back(body.name);
    const auto found = std::find(names.begin(), names.end(), one.leader);
    const bool follows = std::any_of(followers.begin(), followers.end(), [&](const Follower& f) {
      return names[f.body] == one.leader;
    });
    if (found == names.end())
      reading.fault(one.place, key, unknown_word("wall", one.leader, names));
    else if (follows)
      reading.fault(one.place, key, "wanted a wall that moves by itself");
    else
      walls.bodies[one.body].motion =
          walls.bodies[static_cast<std::size_t>(found - names.begin())].motion;
  }
}

}  // namespace

ThermalBoundary read_thermal(Table& parent, const std::string& key, const WallSetting& setting) {
  parent.moves_nothing(key);
  const Node* node = setting.heat ? parent.need_table(key) : parent.look_table(key);
  if (node == nullptr) return Adiabatic{};
  Table table(parent.reading(), *node, parent.path(key));
  const std::string kind = table.choice("kind", {"adiabatic", "fixed", "lining"});
  if (kind == "fixed") return FixedTemperature{table.value("temperature", a_temperature)};
  if (kind == "lining") return read_lining(table, setting);
  if (kind.empty()) table.ignore_rest();
  return Adiabatic{};
}

std::array<std::uint32_t, 2> read_patches(Table& table, const std::string& key,
                                          std::array<std::uint32_t, 2> fallback) {
  if (table.look(key) == nullptr) return fallback;
  const std::vector<double> given = table.values(key, {Dimension::none, {1.0, 1000.0}});
  const bool whole =
      given.size() == 2 && given[0] == std::floor(given[0]) && given[1] == std::floor(given[1]);
  if (whole) return {static_cast<std::uint32_t>(given[0]), static_cast<std::uint32_t>(given[1])};
  if (!given.empty()) table.fault(key, "wanted two whole numbers such as [8, 4]");
  return fallback;
}

void read_walls(Table& root, const WallSetting& setting, Walls& walls) {
  std::vector<Follower> followers;
  for_each_table(root, "walls", [&](Table& table, const std::string& name) {
    const std::string leader = table.word_or("moves_with", "");
    if (!leader.empty() && table.has("motion"))
      table.fault("moves_with", "wanted a motion of its own, or that of another wall");
    if (!leader.empty()) followers.push_back({walls.bodies.size(), leader, table.place()});
    read_wall(table, name, setting, walls);
  });
  lead(root.reading(), followers, walls);
}

}  // namespace pmr::casefile
