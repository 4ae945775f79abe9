// Grains that adhere to a wall: [walls.NAME.grains].
#pragma once
#include <string>
#include <vector>

#include "case/walls.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::casefile {

// What the grains of a wall are strewn on.
struct GrainGround {
  std::uint32_t body;
  std::string kind;                  // of the wall
  const std::vector<Shape>& shapes;  // of the wall
};

// Appends the grains of the wall's table, if it has any: a random layer on its face, or those of a
// CSV file.
void read_grains(Table& wall, const WallSetting& setting, const GrainGround& ground,
                 std::vector<Grain>& grains);

}  // namespace pmr::casefile
