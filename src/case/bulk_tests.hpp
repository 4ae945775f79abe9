// Instruments of tests of bulk behaviour: [catch.NAME], [heap], [wall_force.NAME].
#pragma once
#include "case/reader.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

struct Rectangle {
  Vec3 corner, along, across;  // [m]
  Vec3 normal() const { return along.cross(across).normalized(); }
};
// `corner`, `along` and `across` of a table; a fault where the sides are no right angle.
Rectangle read_rectangle(Table& table);

std::vector<CatchInstrument> read_catches(Table& root);
std::optional<HeapInstrument> read_heap(Table& root);
std::vector<WallForce> read_wall_forces(Table& root, const Walls& walls);

}  // namespace pmr::casefile
