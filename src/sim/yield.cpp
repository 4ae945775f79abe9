#include "sim/yield.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "chemistry/gas.hpp"
#include "chemistry/redox.hpp"
#include "chemistry/solids.hpp"
#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::sim {
namespace {

constexpr double lowest_pressure = 1e-7;  // [Pa] of oxygen around an ideal reactor

// All of a species as one solid, as it was charged.
struct Charge {
  chemistry::Solid solid;
  double temperature, delta;  // [K], [1] at the start

  const Redox* redox() const { return solid.material->redox ? &*solid.material->redox : nullptr; }
  double mass() const {  // [kg] at the start
    return redox() ? solid.amount * chemistry::molar_mass(*redox(), delta) : solid.amount;
  }
};

std::vector<Charge> charges(const Case& c, const State& state) {
  std::vector<Charge> all;
  for (const Species& species : c.species)
    all.push_back({{&c.materials.list[species.material], 0.0},
                   species.initial_temperature,
                   coupling::initial_delta(c, species)});
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Charge& charge = all[p.species[i]];
    charge.solid.amount += charge.redox() ? p.formula_units[i] : p.mass[i];
  }
  return all;
}

double ideal_pressure(const ChamberCase& chamber) {
  const double pressure =
      chamber.pump ? chamber.pump->set_point : chamber.oxygen_fraction * chamber.pressure;
  return std::max(pressure, lowest_pressure);
}

// What the charge holds at T beyond its start, and the oxygen that left.
struct Held {
  double energy, oxygen;           // [J], [mol]
  std::vector<double> by_species;  // [mol]
};
Held held_at(const std::vector<Charge>& charge, double T, double pressure) {
  Held held{0.0, 0.0, std::vector<double>(charge.size(), 0.0)};
  for (std::size_t s = 0; s < charge.size(); ++s) {
    const Charge& one = charge[s];
    if (!(one.solid.amount > 0.0)) continue;
    const Redox* redox = one.redox();
    const double delta =
        redox ? chemistry::equilibrium_delta(redox->equilibrium, T, pressure) : 0.0;
    held.energy += chemistry::enthalpy(one.solid, T, delta) -
                   chemistry::enthalpy(one.solid, one.temperature, one.delta);
    if (redox) held.by_species[s] = 0.5 * one.solid.amount * (delta - one.delta);
    held.oxygen += held.by_species[s];
  }
  held.energy += held.oxygen * chemistry::oxygen_heat(T).enthalpy;
  return held;
}

// First time [s] at which the column reaches `level`.
double time_to(const io::Series& series, const std::vector<double>& values, double level) {
  const std::vector<double>& time = series.values("time");
  for (std::size_t k = 1; k < values.size(); ++k)
    if (values[k] >= level) {
      const double rise = values[k] - values[k - 1];
      const double part = rise > 0.0 ? (level - values[k - 1]) / rise : 1.0;
      return time[k - 1] + std::clamp(part, 0.0, 1.0) * (time[k] - time[k - 1]);
    }
  return nan;
}

double mean_from(const io::Series& series, const std::vector<double>& values, double begin) {
  const std::vector<double>& time = series.values("time");
  double sum = 0.0, length = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (time[k - 1] < begin) continue;
    const double step = time[k] - time[k - 1];
    sum += 0.5 * (values[k] + values[k - 1]) * step;
    length += step;
  }
  return length > 0.0 ? sum / length : nan;
}

// The most oxygen that was off at any time.
struct Peak {
  double oxygen = nan;      // [mol]
  double time_to_90 = nan;  // [s]

  bool is_known() const { return std::isfinite(oxygen); }
};
Peak peak_of(const io::Series& series, const std::string& column) {
  if (series.rows() == 0 || !series.has(column)) return {};
  const std::vector<double>& released = series.values(column);
  const double most = *std::max_element(released.begin(), released.end());
  return {most, most > 0.0 ? time_to(series, released, 0.9 * most) : nan};
}

// The furnaces' useful heat [J]: all of the charge from the air's temperature, at its own delta.
double charge_heat(const Case& c, const State& state) {
  const double air = std::max(c.chamber->gas_temperature, chemistry::lowest_temperature);
  double heat = 0.0;
  for (const Charge& one : charges(c, state))
    if (one.solid.amount > 0.0)
      heat += chemistry::enthalpy(one.solid, one.temperature, one.delta) -
              chemistry::enthalpy(one.solid, air, one.delta);
  return heat;
}

}  // namespace

// The energy that is held rises with T: bisection.
IdealEnd ideal_end(const Case& c, const State& state) {
  const std::vector<Charge> charge = charges(c, state);
  const double pressure = ideal_pressure(*c.chamber);
  double low = chemistry::lowest_temperature, high = chemistry::highest_temperature;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (held_at(charge, middle, pressure).energy > 0.0 ? high : low) = middle;
  }
  const double T = 0.5 * (low + high);
  const Held held = held_at(charge, T, pressure);
  return {T, held.oxygen, held.by_species};
}

Yield measure_yield(const Case& c, const State& state, const io::Series& series) {
  double redox_mass = 0.0, inert_heat = 0.0;
  const std::vector<Charge> charge = charges(c, state);
  for (const Charge& one : charge)
    if (one.redox())
      redox_mass += one.mass();
    else if (one.solid.amount > 0.0)
      inert_heat += chemistry::enthalpy(one.solid, one.temperature, 0.0);
  const double spent = charge_heat(c, state);
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!charge[p.species[i]].redox()) inert_heat -= p.enthalpy[i];
  const IdealEnd ideal = ideal_end(c, state);
  const bool has_ideal = ideal.oxygen > 0.0;  // a cold charge would only take oxygen up
  const double ideal_oxygen = has_ideal ? ideal.oxygen : nan;
  const Peak peak = peak_of(series, "oxygen_released");
  Yield yield{state.fluxes.oxygen_released / redox_mass,
              peak.oxygen / redox_mass,
              ideal_oxygen / redox_mass,
              has_ideal ? ideal.temperature : nan,
              peak.oxygen / ideal_oxygen,
              state.fluxes.reaction / inert_heat,
              peak.time_to_90,
              peak.is_known() && c.chamber->pump
                  ? mean_from(series, series.values("pressure"), c.chamber->pump->start)
                  : nan,
              state.fluxes.pump_work,
              spent,
              peak.oxygen > 0.0 ? spent / peak.oxygen : nan,
              {}};
  for (std::size_t s = 0; s < charge.size(); ++s) {
    if (!charge[s].redox()) continue;
    const Peak own = peak_of(series, "oxygen_released." + c.species[s].name);
    const double mass = charge[s].mass(), best = has_ideal ? ideal.by_species[s] : nan;
    yield.species.push_back({s, state.breakdown.released[s] / mass, own.oxygen / mass, best / mass,
                             best > 0.0 ? own.oxygen / best : nan, own.time_to_90});
  }
  return yield;
}

}  // namespace pmr::sim
