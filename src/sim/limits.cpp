// Where a run left the ground its models stand on.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chemistry/redox.hpp"
#include "coupling/ray_count.hpp"
#include "coupling/thermal_state.hpp"
#include "instruments/heap.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/constants.hpp"
#include "sim/ledger.hpp"
#include "sim/schedule.hpp"
#include "sim/summary.hpp"
#include "sim/yield.hpp"

namespace pmr::sim {
namespace {

constexpr double usual_overlap = 0.05;  // [1] of the radius; common limit of soft spheres
// Fewer than one particle in a thousand outside a fit moves no figure of a run: not told.
constexpr double worth_telling = 1e-3;  // [1] of the particles

// "3.1 %": never 0 % of something that is there.
std::string per_cent(std::size_t part, std::size_t all) {
  const double share = static_cast<double>(part) / static_cast<double>(all);
  return fmt::format("{:.{}f} %", 100.0 * share, share < 0.0995 ? 1 : 0);
}

bool is_worth_telling(std::size_t part, std::size_t all) {
  return static_cast<double>(part) >= worth_telling * static_cast<double>(all) && part > 0;
}

void check_mechanics(const Case& c, const State& state, std::vector<std::string>& limits) {
  if (state.extremes.overlap_ratio > usual_overlap)
    limits.push_back(
        fmt::format("The largest overlap was {:.1f} % of the radius; the soft contact "
                    "model is trusted up to 5 %.",
                    100.0 * state.extremes.overlap_ratio));
  const double fraction = physics::time_step(c).fraction;
  if (fraction > physics::largest_fraction)
    limits.push_back(
        fmt::format("The time step is {:.0f} % of the Rayleigh step; above 40 % it "
                    "may be unstable.",
                    100.0 * fraction));
  if (state.waiting.size() > 0)
    limits.push_back(
        fmt::format("{} particles were still to be poured in at the end.", state.waiting.size()));
  if (!state.lost.empty())
    limits.push_back(fmt::format("{} particles left the domain; the first, {}, at t = {:.4g} s.",
                                 state.lost.size(), state.lost.front().id,
                                 state.lost.front().time));
}

void check_heap(const Case& c, const State& state, std::vector<std::string>& limits) {
  if (!c.heap) return;
  const auto heap = instruments::measure_heap(state.particles, *c.heap);
  if (!heap)
    limits.push_back("There is no heap with a flank whose angle could be measured.");
  else if (heap->is_edged)
    limits.push_back("The heap reaches the rim of its base: its angle is not that of a free heap.");
}

// How many particles of a species there are, and how many of them a test finds [1].
template <class Test>
std::pair<std::size_t, std::size_t> part_of(const State& state, std::size_t species,
                                            const Test& test) {
  std::size_t found = 0, count = 0;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    if (state.particles.species[i] != species) continue;
    ++count;
    found += test(i) ? 1 : 0;
  }
  return {found, count};
}

// Where a rate is extrapolated it matters only if it is slow.
void check_rate_fit(const Species& species, const Redox& redox, const State& state, std::size_t s,
                    std::vector<std::string>& limits) {
  const auto [outside, count] = part_of(state, s, [&](std::size_t i) {
    const double T = state.particles.temperature[i];
    return T < redox.rate_temperature_minimum || T > redox.rate_temperature_maximum;
  });
  if (is_worth_telling(outside, count))
    limits.push_back(
        fmt::format("{} of the {} particles end outside the temperatures that their rate "
                    "was fitted at: extrapolated (above them particles stay near equilibrium).",
                    per_cent(outside, count), species.name));
}

void check_equilibrium_fit(const Species& species, const RedoxEquilibrium& fit, const State& state,
                           std::size_t s, double pressure, std::vector<std::string>& limits) {
  const auto [outside, count] = part_of(state, s, [&](std::size_t i) {
    return !chemistry::is_within_fit(fit, state.particles.temperature[i], state.particles.delta[i],
                                     pressure);
  });
  if (is_worth_telling(outside, count))
    limits.push_back(fmt::format(
        "{} of the {} particles end outside the range that the equilibrium was fitted in "
        "(delta {:.3f}-{:.3f}, {:.0f}-{:.0f} degC, {:g}-{:g} Pa of oxygen; it is "
        "{:.3g} Pa): extrapolated.",
        per_cent(outside, count), species.name, fit.fit_delta_minimum, fit.fit_delta_maximum,
        fit.fit_temperature_minimum - zero_celsius, fit.fit_temperature_maximum - zero_celsius,
        fit.fit_pressure_minimum, fit.fit_pressure_maximum, pressure));
}

// Beyond its rows a table over temperature stays constant.
void check_table(const Case& c, const State& state, std::size_t s, const char* what,
                 const Table& table, std::vector<std::string>& limits) {
  if (table.x.size() < 2) return;
  const auto is_beyond = [&](double T) { return T < table.x.front() || T > table.x.back(); };
  const auto [outside, count] =
      part_of(state, s, [&](std::size_t i) { return is_beyond(state.particles.temperature[i]); });
  const bool begins_outside = is_beyond(c.species[s].initial_temperature);
  if (!begins_outside && !is_worth_telling(outside, count)) return;
  limits.push_back(fmt::format(
      "The {} of {} is given from {:.0f} to {:.0f} degC; {}{}{}: constant beyond.", what,
      c.species[s].name, table.x.front() - zero_celsius, table.x.back() - zero_celsius,
      begins_outside ? "its particles begin outside" : "",
      begins_outside && outside > 0 ? ", " : "",
      outside > 0 ? per_cent(outside, count) + " of them end outside" : ""));
}

void check_tables(const Case& c, const State& state, std::vector<std::string>& limits) {
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    const Material& m = c.materials.list[c.species[s].material];
    if (const auto* heat = std::get_if<TabulatedHeat>(&m.heat))
      check_table(c, state, s, "heat capacity", heat->rows.table, limits);
    if (const auto* k = std::get_if<TabulatedConductivity>(&m.conductivity);
        k != nullptr && c.models.conduction)
      check_table(c, state, s, "conductivity", k->table, limits);
    if (c.models.radiation) check_table(c, state, s, "emissivity", m.emissivity.table, limits);
  }
}

// A delta that froze in above the charge's temperature is a guess; what 50 K of it do to an ideal
// reactor.
void check_initial_delta(const Case& c, const State& state, std::vector<std::string>& limits) {
  constexpr double shift = 50.0;  // [K]
  if (!c.chamber || state.particles.size() == 0) return;
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    const auto* frozen = std::get_if<EquilibriumDelta>(&c.species[s].initial_delta);
    if (frozen == nullptr || !c.materials.list[c.species[s].material].redox) continue;
    if (!(frozen->temperature > c.species[s].initial_temperature)) continue;
    const auto at = [&](double T) {
      Case other = c;
      other.species[s].initial_delta = EquilibriumDelta{T, frozen->oxygen_pressure};
      return std::pair{coupling::initial_delta(other, other.species[s]),
                       ideal_end(other, state).oxygen};
    };
    const double T = frozen->temperature;
    const auto [low, most] = at(T - shift);
    const auto [middle, here] = at(T);
    const auto [high, least] = at(T + shift);
    limits.push_back(fmt::format(
        "The initial delta of {} is a guess: {:.3f}, frozen in at {:.0f} degC. Frozen in at {:.0f} "
        "or {:.0f} degC it would be {:.3f} or {:.3f}, and an ideal reactor would give {:.3g} or "
        "{:.3g} mol of oxygen instead of {:.3g}.",
        c.species[s].name, middle, T - zero_celsius, T - shift - zero_celsius,
        T + shift - zero_celsius, low, high, most, least, here));
  }
}

void check_rays(const Case& c, const State& state, std::vector<std::string>& limits) {
  if (!c.models.radiation || !(state.exchange.rays > 0.0)) return;
  const auto rays = coupling::count_rays(c, c.models.radiation->rays_settled);
  if (rays.wanted > rays.sent)
    limits.push_back(fmt::format(
        "Sizes differ so much that rays of equal power would be {:.2g} a tracing; {:.2g} are sent, "
        "fewer from the largest emitters. The largest factors are known to {:.1g} % in the mean.",
        rays.wanted, rays.sent, 100.0 * state.exchange.relative_error));
}

void check_fits(const Case& c, const State& state, std::vector<std::string>& limits) {
  const auto gas = coupling::atmosphere(c, state);
  const double pressure = gas.oxygen_fraction * gas.pressure;
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    const auto& redox = c.materials.list[c.species[s].material].redox;
    if (!redox) continue;
    check_equilibrium_fit(c.species[s], redox->equilibrium, state, s, pressure, limits);
    check_rate_fit(c.species[s], *redox, state, s, limits);
  }
}

}  // namespace

std::vector<std::string> limits_touched(const Case& c, const State& state) {
  std::vector<std::string> limits;
  check_mechanics(c, state, limits);
  check_heap(c, state, limits);
  if (has_heat(c) && !c.walls.grains.empty())
    limits.push_back("Grains that adhere to walls take no part in heat, radiation and chemistry.");
  check_rays(c, state, limits);
  if (has_heat(c)) check_tables(c, state, limits);
  if (c.models.reaction) check_fits(c, state, limits);
  if (c.models.reaction) check_initial_delta(c, state, limits);
  if (has_heat(c)) {
    const Balance balance = close_books(c, state);
    if (!balance.closes())
      limits.push_back(fmt::format("The books do not close: energy {:.1e}, oxygen {:.1e}.",
                                   balance.energy_relative, balance.oxygen_relative));
    if (!c.models.conduction || c.models.conduction->shells == 1)
      limits.push_back(
          "Particles are taken as isothermal; at Biot numbers above 0.1 this overstates "
          "the exchange (see biot_max).");
  }
  return limits;
}

}  // namespace pmr::sim
