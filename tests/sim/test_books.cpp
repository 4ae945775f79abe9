// What the books' residuals are parts of: right runs pass, and a flux that is left out does not.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/redox.hpp"
#include "sim/ledger.hpp"
#include "small_runs.hpp"

using namespace pmr;
using test::box_case;
using test::run_to_end;
using test::species;

namespace {

const std::string air = R"([chamber]
closing = "0 s"
volume = "8 l"
pressure = "101325 Pa"
oxygen_fraction = 0.21
gas_temperature = "300 K"
film_coefficient = "10000 W/m2/K"
leak = "0 mol/s/Pa"
)";

const std::string open_air = R"([chamber]
pressure = "101325 Pa"
oxygen_fraction = 0.21
gas_temperature = "1000 K"
film_coefficient = "10 W/m2/K"
leak = "0 mol/s/Pa"
)";

// Gas alone: a pump of constant speed on a chamber whose walls hold it at 300 K.
Case pumped() {
  return test::load(box_case(
      "300 K",
      species("grain", "Al2O3", "diameter = \"1 mm\"\ntemperature = \"300 K\"", "0 0 0") +
          "[react]\nend = \"20 s\"\n[models]\nconduction = {contact = false, gap = false}\n" + air +
          "pump = {start = \"0 s\", speed = \"0.001 m3/s\", ultimate = \"0 Pa\", set_point = \"1 "
          "Pa\"}\n"));
}

// Granules in equilibrium with the air and with the walls.
Case at_rest() {
  return test::load(box_case(
      "1000 K", species("granule", "SrFeO3",
                        "diameter = \"1.47 mm\"\ntemperature = \"1000 K\"\ndelta = {equilibrium_at "
                        "= \"1000 K\", oxygen = \"21278.25 Pa\"}",
                        "0 0 0") +
                    "[react]\nend = \"600 s\"\n[models]\nconduction = true\nreaction = true\n"
                    "[models.radiation]\nsurroundings = \"1000 K\"\n" +
                    open_air));
}

// One flux of the books, `part` of it left out.
bool closes_without(const Case& c, const State& state, double Fluxes::*flux, double part) {
  State changed = state;
  changed.fluxes.*flux *= 1.0 - part;
  return sim::close_books(c, changed).closes();
}

}  // namespace

TEST_CASE("Gas that a pump draws counts as turned over: the books of a pumped chamber close") {
  const Case c = pumped();
  const State end = run_to_end(c, "pumped").state;
  // p = p0 exp(-S t/V) of an isothermal volume.
  const double n = end.gas.oxygen + end.gas.nitrogen;
  const double volume = 0.008 - pi / 6.0 * 1e-9;
  CHECK(n * gas_constant * 300.0 / volume ==
        Approx(101325.0 * std::exp(-0.001 * 20.0 / volume)).epsilon(2e-3));
  const sim::Balance balance = sim::close_books(c, end);
  CHECK(balance.energy_relative < 1e-2 * sim::energy_limit);
  CHECK(balance.closes());
  // A thousandth of any flux that passed the border is missed.
  for (const auto flux : {&Fluxes::to_outside, &Fluxes::gas_energy_in, &Fluxes::oxygen_pumped,
                          &Fluxes::nitrogen_pumped, &Fluxes::oxygen_closed_in}) {
    REQUIRE(std::abs(end.fluxes.*flux) > 0.0);
    CHECK_FALSE(closes_without(c, end, flux, 1e-3));
  }
}

TEST_CASE("Where nothing happens the books close, and notice a millionth of what is stored") {
  const Case c = at_rest();
  const State end = run_to_end(c, "rest").state;
  CHECK(sim::close_books(c, end).closes());
  CHECK(end.particles.temperature[0] == Approx(1000.0).epsilon(1e-9));
  State warmer = end;
  warmer.fluxes.to_outside += 1e-6 * end.opening.heat_content;
  CHECK_FALSE(sim::close_books(c, warmer).closes());
  State poorer = end;
  poorer.fluxes.oxygen_released += 1e-6 * end.opening.oxygen;
  CHECK_FALSE(sim::close_books(c, poorer).closes());
}

TEST_CASE("Oxygen that leaves and comes back counts both ways") {
  // Far too hot at first, it gives off much and takes most of it up again.
  const Case c = test::load(
      box_case(
          "1173.15 K",
          species("granule", "SrFeO3",
                  "diameter = \"1.47 mm\"\ntemperature = \"2000 degC\"\ndelta = 0.3", "0 0 0") +
              "[react]\nend = \"3000 s\"\n[models]\nconduction = true\nreaction = true\n"
              "[models.radiation]\nsurroundings = \"1173.15 K\"\n" +
              open_air),
      {"chamber.gas_temperature=\"1173.15 K\""});
  const State end = run_to_end(c, "hot").state;
  const auto& redox = *c.materials.list[c.species[0].material].redox;
  CHECK(end.particles.delta[0] ==
        Approx(chemistry::equilibrium_delta(redox.equilibrium, 1173.15, 0.21 * 101325.0))
            .epsilon(1e-4));
  CHECK(end.fluxes.grain_turnover > 1.5 * std::abs(end.fluxes.oxygen_released));
  CHECK(sim::close_books(c, end).closes());
  CHECK_FALSE(closes_without(c, end, &Fluxes::oxygen_released, 1e-3));
  CHECK_FALSE(closes_without(c, end, &Fluxes::gas_energy_out, 1e-3));
  CHECK_FALSE(closes_without(c, end, &Fluxes::to_outside, 1e-3));
}

TEST_CASE("Residuals are parts of what was turned over and of a stated share of the store") {
  const Case c = pumped();
  State state;  // nothing is left: what was stored is in the fluxes, less a residual
  state.opening.energy = 50.0;
  state.opening.heat_content = 1000.0;
  state.fluxes.to_outside = 50.0 + 1e-5;
  state.fluxes.heat_exchanged = 10.0;
  state.fluxes.gas_turnover = 90.0;
  state.opening.oxygen = 2.0;
  state.fluxes.oxygen_released = state.gas.oxygen = 2.0 - 1e-6;
  state.fluxes.grain_turnover = state.fluxes.oxygen_turnover = 3.0;
  const sim::Balance one = sim::close_books(c, state);
  CHECK(one.energy_relative == Approx(1e-5 / (10.0 + 90.0 + 1e-2 * 1000.0)));
  CHECK(one.oxygen_relative == Approx(1e-6 / (3.0 + 2.0 * 2.0)));
  // Of a hundred granules: what each leaves has either sign.
  for (int i = 0; i < 100; ++i) state.waiting.formula_units.push_back(1.0);
  CHECK(sim::close_books(c, state).oxygen_relative == Approx(1e-6 / (3.0 + 0.2 * 2.0)));
}
