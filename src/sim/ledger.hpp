// The books: what is stored now against what was stored at the start and the fluxes that were
// integrated on their own in between.
#pragma once
#include <cstdint>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

inline constexpr double energy_limit = 1e-6;  // [1] of the heat exchanged
inline constexpr double oxygen_limit = 1e-7;  // [1] of the oxygen released

struct Balance {
  double energy_residual;    // [J]
  double energy_relative;    // [1] of the heat exchanged between all nodes
  double oxygen_residual;    // [mol] the larger of the solids' and the gas'
  double nitrogen_residual;  // [mol] of the gas
  double oxygen_relative;    // [1] of what was released, or of the air shut in if that is more;
                             // nitrogen counts likewise
  std::uint64_t inserted, alive, lost, waiting;  // waiting: yet to be poured in
  bool closes() const {
    return energy_relative <= energy_limit && oxygen_relative <= oxygen_limit &&
           inserted == alive + lost + waiting;
  }
};

Balance close_books(const Case& c, const State& state);

// Heat and oxygen that the particles hold.
struct Holdings {
  double energy = 0.0;  // [J]
  double oxygen = 0.0;  // [mol O2]
};
Holdings holdings(const Case& c, const Particles& particles);
// Particles have left since `before`: what they held goes from the store into the books.
void book_losses(const Case& c, const Holdings& before, State& state);

}  // namespace pmr::sim
