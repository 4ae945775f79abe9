// Whether a run that came to its end may be trusted.
#pragma once
#include <string>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

// Why it failed all the same: books that do not close, more particles lost than
// `mechanics.allowed_losses`. None: it may.
std::vector<std::string> reasons_to_fail(const Case& c, const State& state);

}  // namespace pmr::sim
