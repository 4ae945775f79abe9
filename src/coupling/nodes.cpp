#include "coupling/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/tessellate.hpp"
#include "physics/neighbours.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::coupling {
namespace {

std::string patch_name(const Surface& surface, std::uint32_t local) {
  if (patch_count(surface) == 1) return surface.name;
  return surface.name + "[" + std::to_string(local / surface.patches[1]) + "," +
         std::to_string(local % surface.patches[1]) + "]";
}

using Patches = std::array<std::uint32_t, 2>;

std::uint32_t patch_of(const Plane&, const Patches&, const Vec3&) { return 0; }
std::uint32_t patch_of(const Facet&, const Patches&, const Vec3&) { return 0; }
std::uint32_t patch_of(const Revolved& shape, const Patches& patches, const Vec3& point) {
  const Vec3 x = point - shape.origin;
  const double z = x.dot(shape.axis);
  const double r = (x - z * shape.axis).norm();
  const double dr = shape.r1 - shape.r0, dz = shape.z1 - shape.z0;
  const double along = ((r - shape.r0) * dr + (z - shape.z0) * dz) / (dr * dr + dz * dz);
  const Vec3 s = first_direction(shape.axis);
  const double angle = std::atan2(x.dot(shape.axis.cross(s)), x.dot(s)) / (2.0 * pi);
  const auto place = [](double fraction, std::uint32_t count) {
    return std::min(count - 1, static_cast<std::uint32_t>(std::max(0.0, fraction * count)));
  };
  return place(along, patches[0]) * patches[1] +
         place(angle < 0.0 ? angle + 1.0 : angle, patches[1]);
}

}  // namespace

Nodes number_nodes(const Case& c, std::size_t particles) {
  Nodes nodes;
  nodes.particles = particles;
  if (c.models.conduction) nodes.shells = c.models.conduction->shells;
  for (std::uint32_t s = 0; s < c.walls.surfaces.size(); ++s) {
    const Surface& surface = c.walls.surfaces[s];
    nodes.first_patch.push_back(static_cast<std::uint32_t>(nodes.patches.size()));
    const auto* lining = std::get_if<Lining>(&surface.thermal);
    nodes.columns.push_back(lining ? physics::make_column(*lining, c.materials)
                                   : physics::WallColumn{});
    const std::uint32_t count = patch_count(surface);
    const auto areas = patch_areas(tessellate(surface, c.domain_low, c.domain_high), count);
    for (std::uint32_t k = 0; k < count; ++k) {
      nodes.patches.push_back(
          {s, areas[k], patch_name(surface, k), static_cast<std::uint32_t>(nodes.cells)});
      nodes.cells += nodes.columns.back().size();
    }
  }
  return nodes;
}

void number_in_space(const Particles& particles, Nodes& nodes) {
  constexpr Node none = std::numeric_limits<Node>::max();
  nodes.place.assign(nodes.particles, none);
  Node next = 0;
  for (const std::uint32_t i : physics::spatial_order(particles))
    nodes.place[particles.id[i]] = next++;
  for (Node& node : nodes.place)
    if (node == none) node = next++;
}

std::uint32_t patch_at(const Surface& surface, const Vec3& point) {
  if (patch_count(surface) == 1) return 0;
  return std::visit([&](const auto& s) { return patch_of(s, surface.patches, point); },
                    surface.shape);
}

std::vector<double> patch_temperatures(const Case& c, const Nodes& nodes, const WallNodes& walls) {
  std::vector<double> faces;
  std::vector<double> cells;
  for (const Patch& patch : nodes.patches) {
    const auto& column = nodes.columns[patch.surface];
    const auto* held = std::get_if<FixedTemperature>(&c.walls.surfaces[patch.surface].thermal);
    faces.push_back(held ? held->temperature : std::numeric_limits<double>::quiet_NaN());
    if (column.size() == 0) continue;
    cells.resize(column.size());
    physics::column_temperatures(
        column, patch.area, {walls.cell_energy.data() + patch.first_cell, column.size()}, cells);
    faces.back() = cells[0];
  }
  return faces;
}

}  // namespace pmr::coupling
