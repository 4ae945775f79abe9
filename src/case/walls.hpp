// Walls of a case: [walls.NAME].
#pragma once
#include "case/materials.hpp"
#include "case/reader.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::casefile {

// What the readers of walls share.
struct WallSetting {
  MaterialBook& book;
  bool heat;           // a heat model is on, so every wall says its boundary
  std::uint64_t seed;  // of random layers
};

// Appends the walls of [walls] to `walls`.
void read_walls(Table& root, const WallSetting& setting, Walls& walls);

// Two whole numbers: patches along the profile and round the axis.
std::array<std::uint32_t, 2> read_patches(Table& table, const std::string& key,
                                          std::array<std::uint32_t, 2> fallback);

// {kind = "adiabatic" | "fixed" | "lining", ...}
ThermalBoundary read_thermal(Table& parent, const std::string& key, const WallSetting& setting);

}  // namespace pmr::casefile
