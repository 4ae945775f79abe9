// The books: what is stored now against what was stored at the start and the fluxes that were
// integrated on their own in between.
#pragma once
#include <cstdint>
#include <vector>

#include "coupling/thermal_state.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

// Residuals are parts of what was turned over: all that was exchanged, whichever way it went. Where
// little happens the solver's own tolerance is left, which is of what is stored: a share of the
// store counts with it, so that residuals up to these parts of it pass.
inline constexpr double energy_limit = 1e-6;  // [1] of the heat and gas turned over
inline constexpr double oxygen_limit = 1e-7;  // [1] of the oxygen turned over; likewise nitrogen
inline constexpr double kept_heat = 1e-8;     // [1] of C T; CVODES skips changes below 2e-9 a step
inline constexpr double kept_oxygen = 2e-7;   // [1] of what one granule holds: Newton's last
                                              // correction of delta may be 1e-2 of its tolerance,
                                              // 1e-4; of N granules' store a root of N less
inline constexpr double kept_gas = 1e-12;     // [1] of the gas shut in: rounding

struct Balance {
  double energy_residual;    // [J]
  double energy_relative;    // [1] of the heat and gas turned over
  double oxygen_residual;    // [mol] the larger of the solids' and the gas'
  double nitrogen_residual;  // [mol] of the gas
  double oxygen_relative;    // [1] of what was turned over: the largest of the solids' oxygen, the
                             // gas' oxygen and its nitrogen, each over its own
  std::uint64_t inserted, alive, lost, waiting, caught;  // waiting: yet to be poured in
  bool closes() const {
    return energy_relative <= energy_limit && oxygen_relative <= oxygen_limit &&
           inserted == alive + lost + waiting + caught;
  }
};

Balance close_books(const Case& c, const State& state);

// The same for each species, from integrals of its own; the residual is no sum that the solver
// keeps, but what its tolerance leaves.
struct SpeciesBalance {
  double energy_residual;  // [J]
  double oxygen_residual;  // [mol]
};
std::vector<SpeciesBalance> species_books(const Case& c, const State& state);

// Particles have left since `before`: what they held goes from the store into the books.
void book_losses(const Case& c, const coupling::Holdings& before, State& state);

}  // namespace pmr::sim
