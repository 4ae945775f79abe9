#include "sim/verdict.hpp"

#include <fmt/format.h>

#include "sim/ledger.hpp"
#include "sim/schedule.hpp"

namespace pmr::sim {

std::vector<std::string> reasons_to_fail(const Case& c, const State& state) {
  std::vector<std::string> reasons;
  const Balance balance = close_books(c, state);
  if (has_heat(c) && !balance.closes())
    reasons.push_back(
        fmt::format("the books do not close: energy {:.2e} (limit {:.0e}), oxygen {:.2e} "
                    "(limit {:.0e}); see balances in summary.json",
                    balance.energy_relative, energy_limit, balance.oxygen_relative, oxygen_limit));
  const std::size_t allowed = c.models.mechanics.allowed_losses;
  if (state.lost.size() > allowed) {
    const LostParticle& first = state.lost.front();
    const Vec3 at = 1e3 * first.position;
    reasons.push_back(fmt::format(
        "{} particles left the domain, and {} may; the first, particle {}, at t = {:.6g} s at "
        "({:.4g}, {:.4g}, {:.4g}) mm. Close the walls, widen the domain, or allow so many: "
        "models.mechanics.allowed_losses",
        state.lost.size(), allowed, first.id, first.time, at[0], at[1], at[2]));
  }
  return reasons;
}

}  // namespace pmr::sim
