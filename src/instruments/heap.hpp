// Angle of repose of a heap of spheres round a vertical axis, or of a plane one between two walls
// (rings are then strips across it).
//
// Rings of one bin (a diameter) are cut into cells of two bins along the ring. Of each cell the
// highest top (z + R over the base) counts, or the second where the first lies more than a bin
// above it (a stray). The profile is their mean round the ring; the flank runs outwards from the
// highest ring, from 0.8 to 0.2 of its height: the summit of a heap that was cut or has a dip is
// left out. A line through the flank's rings is fitted anew to the cells' tops within 0.75 bins of
// it. Cells are of one size because the highest of a cell is the higher the more stand in it: with
// a fixed number of sectors the angle came out 0.4 to 0.7 degrees too flat.
#pragma once
#include <optional>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::instruments {

// One ring: of all cells that hold a particle.
struct HeapRing {
  double radius;     // [m] mean of the tops'
  double top;        // [m] mean over the cells
  double deviation;  // [m] standard, over the cells
  std::size_t cells;
};
struct Heap {
  double angle;             // [rad] of the fitted line
  double scatter;           // [rad] standard error of the mean of the sectors' own angles
  double sector_deviation;  // [rad] standard, of the sectors' own angles
  double height;            // [m] largest of the profile
  double foot;              // [m] where the line meets the base
  double reach;             // [m] from the axis, of what lies together: at least half of a ring
  bool is_edged;            // the heap reaches the rim of its base: no free heap
  std::vector<HeapRing> rings;
};

// None where there are fewer than three rings of a flank.
std::optional<Heap> measure_heap(const Particles& particles, const HeapInstrument& tool);

}  // namespace pmr::instruments
