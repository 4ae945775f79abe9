// Walls that show their backs to where the particles begin.
#pragma once
#include <cstddef>

#include "pmr/state/case.hpp"

namespace pmr::casefile {

// Warns in c.warnings of bodies from `first` on whose back is what particles see of them (only the
// facing side radiates): of half lines from places where particles begin, in all directions, more
// than a twentieth of some place's meet such a body's back before any other wall, and no one from
// any place its facing side.
void warn_of_backs(std::size_t first, Case& c);

}  // namespace pmr::casefile
