// STL files as flat surfaces.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "pmr/state/walls.hpp"

namespace pmr::casefile {

using Triangle = std::array<Vec3, 3>;  // [m] counter-clockwise seen from the facing side

struct StlFile {
  std::vector<Triangle> triangles;
  std::vector<std::string> problems;  // an unreadable file, bad triangles by their number
};

// `scale` [m] is the length of the file's unit.
StlFile read_stl(const std::filesystem::path& file, double scale);

// Groups triangles that hang together by an edge and lie in one plane (1e-4 rad to the group's
// first triangle) into one facet each.
std::vector<Facet> flat_facets(const std::vector<Triangle>& triangles);

}  // namespace pmr::casefile
