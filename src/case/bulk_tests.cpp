#include "case/bulk_tests.hpp"

#include <algorithm>
#include <cmath>

#include "case/nearest.hpp"

namespace pmr::casefile {

Rectangle read_rectangle(Table& table) {
  Rectangle made{table.vector("corner", Dimension::length),
                 table.vector("along", Dimension::length),
                 table.vector("across", Dimension::length)};
  const double area = made.along.norm() * made.across.norm();
  if (std::isfinite(area) && !(std::abs(made.along.dot(made.across)) < 1e-6 * area))
    table.fault("across", "wanted a side at right angles to along, neither of them zero");
  return made;
}

std::vector<CatchInstrument> read_catches(Table& root) {
  std::vector<CatchInstrument> all;
  for_each_table(root, "catch", [&](Table& table, const std::string& name) {
    const Rectangle opening = read_rectangle(table);
    CatchInstrument made{name, opening.corner, opening.along, opening.across, {}, false};
    made.threshold = table.maybe("threshold", {Dimension::mass, positive});
    made.ends_motion = table.flag("ends_motion", false);
    if (made.ends_motion && !made.threshold)
      table.fault("ends_motion", "wanted a threshold with it");
    all.push_back(made);
  });
  return all;
}

std::optional<HeapInstrument> read_heap(Table& root) {
  const Node* node = root.look_table(root.moves_nothing("heap"));
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "heap");
  HeapInstrument heap{};
  heap.centre = table.vector("centre", Dimension::length);
  heap.radius = table.value("radius", a_length);
  heap.sectors = static_cast<std::uint32_t>(table.count("sectors", 3, 24));
  heap.bin = table.value("bin", a_length);
  if (table.has("along"))
    heap.plane = {table.direction("along"), table.value("width", a_length)};
  else
    table.look("along");
  if (heap.plane && heap.plane->along.z() != 0.0) table.fault("along", "wanted horizontal");
  return heap;
}

std::vector<WallForce> read_wall_forces(Table& root, const Walls& walls) {
  std::vector<WallForce> all;
  for_each_table(root, root.moves_nothing("wall_force"),
                 [&](Table& table, const std::string& name) {
                   WallForce made{name, 0, table.vector("about", Dimension::length, Vec3::Zero())};
                   std::vector<std::string> names;
                   for (const Body& body : walls.bodies) names.push_back(body.name);
                   const auto found = std::find(names.begin(), names.end(), name);
                   if (found == names.end())
                     table.reading().fault(table.place(), "wall_force." + name,
                                           unknown_word("wall", name, names));
                   else
                     made.body = static_cast<std::uint32_t>(found - names.begin());
                   all.push_back(made);
                 });
  return all;
}

}  // namespace pmr::casefile
