#include "case/stl.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "case/stl_text.hpp"

namespace pmr::casefile {
namespace {

constexpr double flat_angle = 1.0e-4;       // [rad] between normals of one flat surface
constexpr double smallest_height = 1.0e-7;  // [1] height over longest side of a proper triangle
constexpr std::size_t told = 5;             // bad triangles that are named one by one

Vec3 normal_of(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

std::string flaw(const Triangle& t) {
  for (const Vec3& corner : t)
    if (!corner.allFinite()) return "a corner that is not finite";
  const double longest =
      std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  const double doubled_area = (t[1] - t[0]).cross(t[2] - t[0]).norm();
  return doubled_area > smallest_height * longest * longest ? "" : "no area";
}

void name_flaws(StlFile& out) {
  std::size_t bad = 0;
  for (std::size_t k = 0; k < out.triangles.size(); ++k) {
    const std::string problem = flaw(out.triangles[k]);
    if (problem.empty()) continue;
    if (++bad <= told)
      out.problems.push_back(fmt::format("triangle {} (0 is the first) has {}", k, problem));
  }
  if (bad > told) out.problems.push_back(fmt::format("{} more bad triangles", bad - told));
}

using Point = std::array<double, 3>;
using Edge = std::pair<Point, Point>;

Edge edge_of(const Triangle& triangle, std::size_t k) {
  const Vec3 &a = triangle[k], &b = triangle[(k + 1) % 3];
  const Point p{a.x(), a.y(), a.z()}, q{b.x(), b.y(), b.z()};
  return p < q ? Edge{p, q} : Edge{q, p};
}

}  // namespace

StlFile read_stl(const std::filesystem::path& file, double scale) {
  StlFile out;
  if (!std::filesystem::is_regular_file(file)) {
    out.problems.push_back(fmt::format("the STL file '{}' does not exist", file.string()));
    return out;
  }
  const StlText text = stl_triangles(file);
  if (!text.problem.empty()) {
    out.problems.push_back(fmt::format("'{}' is no STL file: {}", file.string(), text.problem));
    return out;
  }
  for (const auto& corners : text.triangles)
    out.triangles.push_back({scale * corners[0].cast<double>(), scale * corners[1].cast<double>(),
                             scale * corners[2].cast<double>()});
  if (out.triangles.empty()) out.problems.push_back("the STL file holds no triangle");
  name_flaws(out);
  return out;
}

std::vector<Facet> flat_facets(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<std::size_t>> at_edge;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) at_edge[edge_of(triangles[t], k)].push_back(t);
  std::vector<Facet> facets;
  std::vector<char> taken(triangles.size(), 0);
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (taken[seed] != 0) continue;
    Facet facet{{}, normal_of(triangles[seed])};
    std::vector<std::size_t> open{seed};
    taken[seed] = 1;
    while (!open.empty()) {
      const std::size_t t = open.back();
      open.pop_back();
      facet.triangles.push_back(triangles[t]);
      for (std::size_t k = 0; k < 3; ++k)
        for (const std::size_t next : at_edge.at(edge_of(triangles[t], k))) {
          const Vec3 normal = normal_of(triangles[next]);
          const bool is_flat = normal.cross(facet.normal).norm() < std::sin(flat_angle) &&
                               normal.dot(facet.normal) > 0.0;
          if (taken[next] != 0 || !is_flat) continue;
          taken[next] = 1;
          open.push_back(next);
        }
    }
    facets.push_back(std::move(facet));
  }
  return facets;
}

}  // namespace pmr::casefile
