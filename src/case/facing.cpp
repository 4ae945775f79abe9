#include "case/facing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "case/half_line.hpp"

namespace pmr::casefile {
namespace {

using Corner = std::array<double, 3>;
using SharedEdge = std::pair<Corner, Corner>;

// An edge, and whether the triangle runs along it from the lesser point to the greater.
struct Side {
  SharedEdge edge;
  bool is_forward;
};

Side side_of(const Triangle& triangle, std::size_t k) {
  const Vec3 &a = triangle[k], &b = triangle[(k + 1) % 3];
  const Corner p{a.x(), a.y(), a.z()}, q{b.x(), b.y(), b.z()};
  return p < q ? Side{{p, q}, true} : Side{{q, p}, false};
}

struct Use {
  std::size_t triangle;
  bool is_forward;
};

std::map<SharedEdge, std::vector<Use>> uses_of_edges(const std::vector<Triangle>& triangles) {
  std::map<SharedEdge, std::vector<Use>> uses;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Side side = side_of(triangles[t], k);
      uses[side.edge].push_back({t, side.is_forward});
    }
  return uses;
}

double area_of(const Triangle& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm(); }

// Triangles that hang together by edges of exactly two, and which of them face the other side than
// the first one does.
struct Part {
  std::vector<std::size_t> triangles;
  std::vector<char> is_turned;  // of each of them
  bool is_closed = true;
  bool is_contradictory = false;
};

std::vector<Part> parts_of(const std::vector<Triangle>& triangles) {
  const auto uses = uses_of_edges(triangles);
  constexpr int unknown = -1;
  std::vector<int> turned(triangles.size(), unknown);
  std::vector<Part> parts;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (turned[seed] != unknown) continue;
    Part part{{seed}, {}, true, false};
    turned[seed] = 0;
    for (std::size_t at = 0; at < part.triangles.size(); ++at) {
      const std::size_t t = part.triangles[at];
      for (std::size_t k = 0; k < 3; ++k) {
        const Side side = side_of(triangles[t], k);
        const std::vector<Use>& both = uses.at(side.edge);
        part.is_closed = part.is_closed && both.size() == 2;
        if (both.size() != 2) continue;
        const Use& other = both[both[0].triangle == t ? 1 : 0];
        const int wanted = side.is_forward == other.is_forward ? 1 - turned[t] : turned[t];
        if (turned[other.triangle] == unknown) {
          turned[other.triangle] = wanted;
          part.triangles.push_back(other.triangle);
        }
        part.is_contradictory = part.is_contradictory || turned[other.triangle] != wanted;
      }
    }
    for (const std::size_t t : part.triangles) part.is_turned.push_back(turned[t] == 1 ? 1 : 0);
    parts.push_back(std::move(part));
  }
  return parts;
}

// Whether x lies within the closed mesh: most of several half lines leave it through an odd number
// of triangles (one may hit an edge). `on` [1]: x lies on that triangle, which does not count.
bool is_inside_mesh(const std::vector<Triangle>& mesh, const Vec3& x,
                    const std::vector<Vec3>& towards,
                    std::optional<std::size_t> on = std::nullopt) {
  std::size_t odd = 0;
  for (const Vec3& direction : towards) {
    std::size_t crossings = 0;
    for (std::size_t t = 0; t < mesh.size(); ++t)
      crossings += t != on && std::isfinite(way_to_triangle({x, direction}, mesh[t])) ? 1 : 0;
    odd += crossings % 2;
  }
  return 2 * odd > towards.size();
}

// Directions along no axis or diagonal of usual parts.
std::vector<Vec3> slanting(const Vec3& axis) {
  const Vec3 across = axis.unitOrthogonal();
  const Vec3 other = axis.cross(across);
  std::vector<Vec3> directions;
  for (const double angle : {0.37, 2.51, 4.43})  // [rad]
    directions.push_back(axis + 0.29 * (std::cos(angle) * across + std::sin(angle) * other));
  return directions;
}

// Whether the side that the part shows is the inside of the mesh: where its largest triangle looks.
bool shows_inside(const std::vector<Triangle>& mesh, const Part& part) {
  const std::size_t t = *std::max_element(
      part.triangles.begin(), part.triangles.end(),
      [&](std::size_t a, std::size_t b) { return area_of(mesh[a]) < area_of(mesh[b]); });
  const Triangle& largest = mesh[t];
  const Vec3 normal = (largest[1] - largest[0]).cross(largest[2] - largest[0]).normalized();
  const Vec3 middle = 0.36 * largest[0] + 0.33 * largest[1] + 0.31 * largest[2];
  return is_inside_mesh(mesh, middle, slanting(normal), t);
}

Vec3 a_place_in(const CylinderRegion& r) {
  return r.base + Vec3(0.5 * (r.inner_radius + r.radius), 0.0, 0.5 * r.height);
}
Vec3 a_place_in(const BoxRegion& r) { return 0.5 * (r.low + r.high); }

// Where particles begin, as far as the case says it, a few of them [m].
std::vector<Vec3> places_of_particles(const Case& c) {
  constexpr std::size_t enough = 64;
  std::vector<Vec3> places;
  const auto add = [&](const Region& region) {
    places.push_back(std::visit([](const auto& r) { return a_place_in(r); }, region));
  };
  for (std::size_t k = 0; k < c.particles.size(); k += 1 + c.particles.size() / enough)
    places.push_back(c.particles[k].position);
  for (const Species& species : c.species) {
    if (species.region) add(*species.region);
    if (species.pour) add(species.pour->region);
  }
  return places;
}

void turn(Facet& facet) {
  facet.normal = -facet.normal;
  for (Triangle& triangle : facet.triangles) std::swap(triangle[1], triangle[2]);
}

// Surfaces of one body that are there from the beginning, triangle by triangle.
struct Mesh {
  std::vector<Triangle> triangles;
  std::vector<Facet*> facet;  // of each triangle
};

Mesh mesh_of(std::vector<Surface>& surfaces, std::uint32_t body) {
  Mesh mesh;
  for (Surface& surface : surfaces) {
    const bool is_there = surface.body == body && std::isinf(surface.from);
    auto* facet = is_there ? std::get_if<Facet>(&surface.shape) : nullptr;
    for (std::size_t k = 0; facet != nullptr && k < facet->triangles.size(); ++k) {
      mesh.triangles.push_back(facet->triangles[k]);
      mesh.facet.push_back(facet);
    }
  }
  return mesh;
}

}  // namespace

Orientation agree(std::vector<Triangle>& triangles) {
  Orientation result;
  result.is_closed = true;
  for (const Part& part : parts_of(triangles)) {
    double kept = 0.0, turned = 0.0;  // [m2]
    for (std::size_t k = 0; k < part.triangles.size(); ++k)
      (part.is_turned[k] != 0 ? turned : kept) += area_of(triangles[part.triangles[k]]);
    for (std::size_t k = 0; k < part.triangles.size(); ++k)
      if ((part.is_turned[k] != 0) == (turned <= kept)) {
        std::swap(triangles[part.triangles[k]][1], triangles[part.triangles[k]][2]);
        ++result.turned;
      }
    result.is_closed = result.is_closed && part.is_closed;
    result.is_contradictory = result.is_contradictory || part.is_contradictory;
  }
  return result;
}

void face_particles(std::size_t first_body, Case& c) {
  const std::vector<Vec3> places = places_of_particles(c);
  if (places.empty()) return;
  for (auto b = static_cast<std::uint32_t>(first_body); b < c.walls.bodies.size(); ++b) {
    const Mesh mesh = mesh_of(c.walls.surfaces, b);
    if (mesh.triangles.empty()) continue;
    const std::vector<Part> parts = parts_of(mesh.triangles);
    if (!std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.is_closed; }))
      continue;
    const auto has_within = [&](const Vec3& x) {
      return is_inside_mesh(mesh.triangles, x, slanting(Vec3(0.48, 0.6, 0.64)));
    };
    const auto within = std::count_if(places.begin(), places.end(), has_within);
    if (within != 0 && static_cast<std::size_t>(within) != places.size()) continue;
    std::vector<Facet*> away;
    for (const Part& part : parts)
      if (shows_inside(mesh.triangles, part) != (within > 0))
        for (const std::size_t t : part.triangles) away.push_back(mesh.facet[t]);
    if (away.empty()) continue;
    c.warnings.push_back(fmt::format(
        "wall {}: {} of its {} triangles faced away from where the particles begin and were turned "
        "round (only the facing side of a wall radiates)",
        c.walls.bodies[b].name, away.size(), mesh.triangles.size()));
    std::sort(away.begin(), away.end());
    away.erase(std::unique(away.begin(), away.end()), away.end());
    for (Facet* facet : away) turn(*facet);
  }
}

}  // namespace pmr::casefile
