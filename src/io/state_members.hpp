// Names every member of State once for checkpoint and hash. The structured bindings are the guard:
// a member added to one of these structs does not compile until it is named here.
#pragma once
#include <string>

#include "pmr/state/state.hpp"

namespace pmr::io {

// visit(path, unit, number or vector&) for a contact history.
template <class C, class Visitor>
void for_each_contact_field(C& history, Visitor&& visit) {
  auto& [start, partner, tangential, rolling] = history;
  visit("start", "1", start);
  visit("partner", "1", partner);
  visit("tangential", "m", tangential);
  visit("rolling", "N m", rolling);
}

template <class E, class Visitor>
void for_each_exchange_field(E& exchange, Visitor&& visit) {
  auto& [factor, self, emissivity, traced_emissivity, traced_place, traced_at, rays, relative_error,
         row_sum_error, unfinished] = exchange;
  auto& [start, column, value] = factor;
  visit("exchange/start", "1", start);
  visit("exchange/column", "1", column);
  visit("exchange/value", "m2", value);
  visit("exchange/self", "m2", self);
  visit("exchange/emissivity", "1", emissivity);
  visit("exchange/traced_emissivity", "1", traced_emissivity);
  visit("exchange/traced_place", "m", traced_place);
  visit("exchange/traced_at", "s", traced_at);
  visit("exchange/rays", "1", rays);
  visit("exchange/relative_error", "1", relative_error);
  visit("exchange/row_sum_error", "1", row_sum_error);
  visit("exchange/unfinished", "1", unfinished);
}

template <class S, class Visitor>
void for_each_book_field(S& state, Visitor&& visit) {
  auto& [closed, oxygen, nitrogen, energy, pore_volume, pore_oxygen, pore_nitrogen, pore_energy] =
      state.gas;
  visit("gas/closed", "1", closed);
  visit("gas/oxygen", "mol", oxygen);
  visit("gas/nitrogen", "mol", nitrogen);
  visit("gas/energy", "J", energy);
  visit("gas/pore_volume", "m3", pore_volume);
  visit("gas/pore_oxygen", "mol", pore_oxygen);
  visit("gas/pore_nitrogen", "mol", pore_nitrogen);
  visit("gas/pore_energy", "J", pore_energy);
  auto& [opening_energy, opening_oxygen, opening_particles, heat_content, species_energy,
         species_oxygen] = state.opening;
  visit("opening/energy", "J", opening_energy);
  visit("opening/oxygen", "mol", opening_oxygen);
  visit("opening/particles", "1", opening_particles);
  visit("opening/heat_content", "J", heat_content);
  visit("opening/species_energy", "J", species_energy);
  visit("opening/species_oxygen", "mol", species_oxygen);
  auto& [overlap_ratio, speed] = state.extremes;
  visit("extremes/overlap_ratio", "1", overlap_ratio);
  visit("extremes/speed", "m s-1", speed);
  for_each_flux(state.fluxes, [&](const char* name, const char* unit, auto& value) {
    visit("fluxes/" + std::string(name), unit, value);
  });
  for_each_part(state.breakdown, [&](const char* name, const char* unit, auto& values) {
    visit("breakdown/" + std::string(name), unit, values);
  });
}

// All of the state but particles, contacts, lost and caught particles, whose order needs care.
template <class S, class Visitor>
void for_each_ordered_field(S& state, Visitor&& visit) {
  auto& [time, phase, step, interval, rest_since, settled_at, set_point_at, elastic_energy,
         network_step, particles, waiting, pair_contacts, wall_contacts, walls, shells, gas,
         exchange, trend, fluxes, breakdown, opening, extremes, lost, caught] = state;
  visit("time", "s", time);
  visit("phase", "1", phase);
  visit("step", "1", step);
  visit("interval", "1", interval);
  visit("rest_since", "s", rest_since);
  visit("settled_at", "s", settled_at);
  visit("set_point_at", "s", set_point_at);
  visit("elastic_energy", "J", elastic_energy);
  visit("network_step", "s", network_step);
  auto& [cell_energy] = walls;
  visit("walls/cell_energy", "J", cell_energy);
  auto& [shell_enthalpy, shell_delta] = shells;
  visit("shells/enthalpy", "J", shell_enthalpy);
  visit("shells/delta", "1", shell_delta);
  auto& [trend_length, trend_ln_pressure, ln_pore_pressure, warming, heating] = trend;
  visit("trend/length", "s", trend_length);
  visit("trend/ln_pressure", "1", trend_ln_pressure);
  visit("trend/ln_pore_pressure", "1", ln_pore_pressure);
  visit("trend/warming", "K", warming);
  visit("trend/heating", "J", heating);
  for_each_exchange_field(exchange, visit);
  for_each_book_field(state, visit);
}

}  // namespace pmr::io
