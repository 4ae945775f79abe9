#include "case/extents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pmr::casefile {
namespace {

constexpr double another_unit = 300.0;  // [1] metre and millimetre are 1000 apart

using physics::Box;

bool cuts(const Plane& plane, const Vec3& low, const Vec3& high) {
  const Vec3 half = 0.5 * (high - low);
  const double reach = half.dot(plane.normal.cwiseAbs());
  return std::abs((plane.point - low - half).dot(plane.normal)) <= reach;
}
template <class Bounded>
bool cuts(const Bounded& shape, const Vec3& low, const Vec3& high) {
  const Box box = physics::bounding_box(shape);
  return (box.low.array() <= high.array()).all() && (box.high.array() >= low.array()).all();
}

// Whether particles within the domain can come to the surface's middle.
bool is_within(const Surface& surface, const Vec3& low, const Vec3& high) {
  return std::visit([&](const auto& s) { return cuts(s, low, high); }, surface.shape);
}

void check_place(Table& root, const Case& made, std::uint32_t body) {
  const Body& wall = made.walls.bodies[body];
  bool holds = false, is_inside = !std::holds_alternative<Rest>(wall.motion);
  for (const Surface& surface : made.walls.surfaces) {
    if (surface.body != body || !surface.holds_particles) continue;
    holds = true;
    is_inside = is_inside || is_within(surface, made.domain_low, made.domain_high);
  }
  if (holds && !is_inside)
    root.fault("walls", fmt::format("'{}' ({}) lies outside the domain, where no particle meets "
                                    "it; wanted within, or holds_particles = false",
                                    wall.name, to_text(extent_of(made.walls, body))));
}

double smallest_particle(const Case& made) {  // [m] diameter; infinite where a bed says it
  double smallest = std::numeric_limits<double>::infinity();
  for (const Species& species : made.species)
    if (species.diameter > 0.0) smallest = std::min(smallest, smallest_diameter(species));
  return smallest;
}

void check_size(Table& root, const Case& made, std::uint32_t body) {
  const Box box = extent_of(made.walls, body);
  const double wall = (box.high - box.low).maxCoeff();
  const double domain = (made.domain_high - made.domain_low).maxCoeff();
  const bool is_tiny = wall * another_unit < domain && wall < smallest_particle(made);
  if (is_tiny || wall > another_unit * domain)
    root.fault("walls", fmt::format("the STL file of '{}' reaches over {}, the domain over {:.4g} "
                                    "mm: is its scale that of another unit?",
                                    made.walls.bodies[body].name, to_text(box), 1e3 * domain));
}

bool is_mesh(Table& root, const std::string& name) {
  const Node* walls = root.node().find("walls");
  const Node* wall = walls == nullptr ? nullptr : walls->find(name);
  const Node* kind = wall == nullptr ? nullptr : wall->find("kind");
  return kind != nullptr && kind->text == "stl";
}

}  // namespace

Box extent_of(const Walls& walls, std::size_t body) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box all{Vec3::Constant(infinity), Vec3::Constant(-infinity)};
  for (const Surface& surface : walls.surfaces) {
    if (surface.body != body) continue;
    const Box one = physics::bounding_box(surface.shape);
    all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  }
  return all;
}

std::string to_text(const Box& extent) {
  const Vec3 low = 1e3 * extent.low, high = 1e3 * extent.high, size = high - low;
  if (!size.allFinite()) return "infinite";
  return fmt::format(
      "{:.4g} x {:.4g} x {:.4g} mm, from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, "
      "{:.4g}) mm",
      size[0], size[1], size[2], low[0], low[1], low[2], high[0], high[1], high[2]);
}

void check_extents(Table& root, std::size_t first, const Case& made) {
  for (auto body = static_cast<std::uint32_t>(first); body < made.walls.bodies.size(); ++body) {
    const std::size_t before = root.reading().faults();
    if (is_mesh(root, made.walls.bodies[body].name)) check_size(root, made, body);
    if (root.reading().faults() == before) check_place(root, made, body);
  }
}

}  // namespace pmr::casefile
