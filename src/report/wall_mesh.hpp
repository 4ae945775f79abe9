// The walls of a case as triangles for pictures.
#pragma once
#include <optional>
#include <vector>

#include "pmr/state/case.hpp"
#include "radiation/scene.hpp"

namespace pmr::report {

// Walls present at time t [s], where they then are; empty without a case.
std::vector<radiation::Triangle> wall_mesh(const std::optional<Case>& setup, double t);

}  // namespace pmr::report
