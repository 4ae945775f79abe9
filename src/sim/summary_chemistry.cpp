// summary.json: chemistry and yield, of each redox species and of all together.
#include "chemistry/redox.hpp"
#include "coupling/thermal_state.hpp"
#include "instruments/bed.hpp"
#include "sim/summary_parts.hpp"
#include "sim/yield.hpp"

namespace pmr::sim {
namespace {

// A redox species, or all of them.
struct Reacted {
  double initial;                   // [1] delta
  double room;                      // [mol O2] that its delta's limit leaves, of what is charged
  double charge;                    // [kg] before any oxygen was lost
  instruments::Spread delta;        // [1]
  double released, reaction, gain;  // [mol O2], [J], [mol O2] as delta's mean has it

  double extent() const { return gain / room; }  // [1]
};

Reacted react_of(const SummaryInput& in, std::size_t s) {
  const Case& c = in.setup;
  const Redox& redox = *c.materials.list[c.species[s].material].redox;
  Reacted one{coupling::initial_delta(c, c.species[s]), 0.0, 0.0, {}, 0.0, 0.0, 0.0};
  double formula_units = 0.0;  // [mol]
  const Particles& p = in.state.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.species[i] == s) formula_units += p.formula_units[i];
  one.charge = formula_units * chemistry::molar_mass(redox, one.initial);
  one.delta = instruments::species_figures(p, static_cast<SpeciesIndex>(s)).delta;
  one.room = 0.5 * formula_units * (redox.equilibrium.delta_limit - one.initial);
  one.gain = 0.5 * formula_units * (one.delta.mean - one.initial);
  one.released = in.state.breakdown.released[s];
  one.reaction = in.state.breakdown.reaction[s];
  return one;
}

Json object_of(const Reacted& r) {
  return {{"delta_initial", number(r.initial)},
          {"delta_final", number(r.delta.mean)},
          {"delta_std", number(r.delta.deviation)},
          {"oxygen_released", r.released},
          {"oxygen_per_kilogram", number(r.released / r.charge)},
          {"extent", number(r.extent())},
          {"reaction_heat", r.reaction}};
}

}  // namespace

Json chemistry_of(const SummaryInput& in) {
  const Case& c = in.setup;
  Json species = Json::object();
  std::vector<bool> is_redox(c.species.size(), false);
  std::vector<double> initial, charge;
  Reacted all{};
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    if (!c.materials.list[c.species[s].material].redox) continue;
    is_redox[s] = true;
    const Reacted one = react_of(in, s);
    species[c.species[s].name] = object_of(one);
    initial.push_back(one.initial);
    charge.push_back(one.charge);
    all.charge += one.charge;
    all.room += one.room;
    if (one.charge > 0.0) all.gain += one.gain;
  }
  if (initial.empty()) return nullptr;
  all.initial = instruments::weighted_spread(initial, charge).mean;
  all.delta = instruments::species_figures(in.state.particles, is_redox).delta;
  all.released = in.state.fluxes.oxygen_released;
  all.reaction = in.state.fluxes.reaction;
  Json chemistry = object_of(all);
  chemistry["oxygen_to_air"] = in.state.fluxes.oxygen_to_air;
  chemistry["oxygen_pumped"] = in.state.fluxes.oxygen_pumped;
  chemistry["species"] = species;
  return chemistry;
}

Json yield_of(const SummaryInput& in) {
  const Yield yield = measure_yield(in.setup, in.state, in.series);
  Json species = Json::object();
  for (const SpeciesYield& one : yield.species)
    species[in.setup.species[one.species].name] = {{"oxygen_per_kg", number(one.oxygen_per_kg)},
                                                   {"peak_per_kg", number(one.peak_per_kg)},
                                                   {"ideal_per_kg", number(one.ideal_per_kg)},
                                                   {"part_of_ideal", number(one.part_of_ideal)},
                                                   {"time_to_90", number(one.time_to_90)}};
  return {{"oxygen_per_kg", number(yield.oxygen_per_kg)},
          {"peak_per_kg", number(yield.peak_per_kg)},
          {"ideal_per_kg", number(yield.ideal_per_kg)},
          {"ideal_temperature", number(yield.ideal_temperature)},
          {"part_of_ideal", number(yield.part_of_ideal)},
          {"reaction_over_heat", number(yield.reaction_over_heat)},
          {"time_to_90", number(yield.time_to_90)},
          {"mean_pressure", number(yield.mean_pressure)},
          {"pump_work", number(yield.pump_work)},
          {"charge_heat", number(yield.charge_heat)},
          {"charge_heat_per_mol", number(yield.charge_heat_per_mol)},
          {"species", species}};
}

}  // namespace pmr::sim
