// Where the particles of a species are put, or come from.
#pragma once
#include <optional>

#include "case/reader.hpp"
#include "case/rig.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

// `region` of a species: {rig = "Al2O3"}, or a cylinder (base, radius, height), or a box (low,
// high).
std::optional<Region> read_region(Table& species, const std::optional<Rig>& rig,
                                  bool rig_is_faulty);

// `pour` of a species: a cylinder or a box with a rate, and if wanted a velocity and a beginning.
std::optional<Pour> read_pour(Table& species);

}  // namespace pmr::casefile
