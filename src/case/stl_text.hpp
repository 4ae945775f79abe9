// STL files as they are written: binary, or text in small or capital letters.
#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pmr::casefile {

struct StlText {
  std::vector<std::array<Eigen::Vector3f, 3>> triangles;  // [file's unit] corners
  std::string problem;                                    // empty when all is well
};

// Corners are single precision: a binary file holds them so, and a text that is the same mesh must
// give the same corners. Normals are not read: the order of the corners says them.
StlText stl_triangles(const std::filesystem::path& file);

}  // namespace pmr::casefile
