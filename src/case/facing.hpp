// Which side of a facetted wall faces the particles: only that side emits radiation.
#pragma once
#include <string>
#include <vector>

#include "case/stl.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

// What was done to a mesh so that neighbours face the same side.
struct Orientation {
  std::size_t turned = 0;         // triangles
  bool is_closed = false;         // every edge is shared by exactly two triangles
  bool is_contradictory = false;  // no way of turning makes all neighbours agree (Moebius)
};

// Turns triangles so that all that share an edge face the same side: in each part that hangs
// together the side that most of its area had.
Orientation agree(std::vector<Triangle>& triangles);

// Turns the closed facetted bodies whose facing sides do not show to where the particles begin,
// part by part: a shell round particles faces inwards, an obstacle outwards, a thick-walled vessel
// out of its walls. From body `first` on; bodies with particles on both sides stay as they are.
// Says what it did in c.warnings.
void face_particles(std::size_t first, Case& c);

}  // namespace pmr::casefile
