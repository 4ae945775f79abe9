// Size distributions of a species, by mass.
#pragma once
#include <optional>

#include "case/reader.hpp"
#include "physics/size_distribution.hpp"

namespace pmr::casefile {

// `size = {law = ..., ...}` of a species; none after a fault.
std::optional<physics::SizeDistribution> read_sizes(Table& species);

}  // namespace pmr::casefile
