// The bed taken apart, on the terminal.
#pragma once
#include "pmr/state/case.hpp"
#include "pmr/state/particles.hpp"

namespace pmr::cli {

// A line per layer and the indices of the mixture; nothing without a decomposition tool.
void print_mixture(const Case& setup, const Particles& bed);

}  // namespace pmr::cli
