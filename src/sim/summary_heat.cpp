// summary.json: who gave heat to whom, and the books of each species.
#include "coupling/thermal_state.hpp"
#include "sim/heat_paths.hpp"
#include "sim/ledger.hpp"
#include "sim/summary_parts.hpp"

namespace pmr::sim {

Json heat_paths_of(const SummaryInput& in) {
  const Fluxes& f = in.state.fluxes;
  const HeatPaths paths = heat_paths(in.setup, in.state);
  Json pairs = Json::object();
  for (const HeatPair& pair : heat_pairs(in.setup, in.state))
    pairs[pair.from + " to " + pair.to] = {
        {"contact", pair.contact}, {"gap", pair.gap}, {"radiation", pair.radiation}};
  return {{"contact", paths.contact},
          {"gap", paths.gap},
          {"radiation", paths.radiation},
          {"to_walls", paths.to_walls},
          {"reaction", f.reaction},
          {"to_outside", f.to_outside},
          {"to_surroundings", f.to_surroundings},
          {"gas", f.gas_energy_out - f.gas_energy_in},
          {"pairs", pairs}};
}

Json species_books_of(const SummaryInput& in) {
  const Case& c = in.setup;
  const State& state = in.state;
  const Breakdown& by = state.breakdown;
  const coupling::Holdings there = coupling::holdings(c, state.particles);
  const auto balances = species_books(c, state);
  Json books = Json::object();
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    Json& book = books[c.species[s].name];
    book["energy"] = {{"at the start", number(state.opening.species_energy[s])},
                      {"at the end", number(there.energy[s])},
                      {"reaction", by.reaction[s]},
                      {"with oxygen", by.carried[s]},
                      {"with lost particles", by.lost_energy[s]},
                      {"residual", number(balances[s].energy_residual)}};
    if (!c.materials.list[c.species[s].material].redox) continue;
    book["oxygen"] = {{"bound at the start", state.opening.species_oxygen[s]},
                      {"bound at the end", there.oxygen[s]},
                      {"released", by.released[s]},
                      {"with lost particles", by.lost_oxygen[s]},
                      {"residual", balances[s].oxygen_residual}};
  }
  return books;
}

}  // namespace pmr::sim
