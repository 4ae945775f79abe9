// More than one reacting species: each has its own delta, oxygen, yield, limits and books, and all
// together are their sums.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>

#include "chemistry/gas.hpp"
#include "chemistry/redox.hpp"
#include "chemistry/solids.hpp"
#include "coupling/thermal_state.hpp"
#include "sim/ledger.hpp"
#include "sim/yield.hpp"
#include "small_runs.hpp"

namespace fs = std::filesystem;
using namespace pmr;

namespace {

const std::vector<std::string> reacting{"SrFeO3", "fine", "ceria"};

// The tiny reactor with SrFeO3 in two sizes and ceria among its granules.
std::string mixed_text() {
  std::ifstream in(fs::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto put = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  put("count = 120", "count = 70");
  const std::string like =
      "temperature = \"900 degC\"\nregion = {low = \"-4.5 -4.5 2 mm\", high = \"4.5 4.5 25 mm\"}\n";
  put("[walls.side]",
      "[species.fine]\nmaterial = \"SrFeO3\"\ndiameter = \"1.2 mm\"\ncount = 30\ndelta = 0.2\n" +
          like +
          "[species.ceria]\nmaterial = \"CeO2\"\ndiameter = \"1.47 mm\"\ncount = 20\ndelta = "
          "0.01\n" +
          like + "[walls.side]");
  return text;
}

Case mixed(const std::vector<std::string>& sets) { return test::load(mixed_text(), sets); }

std::size_t index_of(const Case& c, const std::string& name) {
  for (std::size_t s = 0; s < c.species.size(); ++s)
    if (c.species[s].name == name) return s;
  return c.species.size();
}

// [mol O2] that the particles of a species have given off, by their deltas; and their mass [kg].
std::pair<double, double> given_off(const Case& c, const Particles& p, std::size_t s) {
  const double initial = coupling::initial_delta(c, c.species[s]);
  const Redox& redox = *c.materials.list[c.species[s].material].redox;
  double oxygen = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.species[i] == s) {
      oxygen += 0.5 * p.formula_units[i] * (p.delta[i] - initial);
      mass += p.formula_units[i] * (redox.molar_mass - redox.atomic_oxygen * initial);
    }
  return {oxygen, mass};
}

}  // namespace

TEST_CASE("A bed of three reacting species tells each one's delta, oxygen, yield and books") {
  // Only the sums over all are kept exactly: of one species the network's tolerance is left, 1e-6
  // of delta (which moves by some 0.1) unless it is told to keep it closer.
  const Case c = mixed({"react.end=\"6 s\"", "output.snapshot_times=\"1 5 s\"",
                        "chamber.vent.start=\"6 s\"", "models.network.delta_tolerance=1e-8"});
  const auto end = test::run_to_end(c, "mixed");
  CHECK(sim::close_books(c, end.state).closes());
  const auto& chemistry = end.summary["chemistry"];
  const auto& yield = end.summary["yield"];
  double oxygen = 0.0, mass = 0.0;
  for (const std::string& name : reacting) {
    INFO(name);
    const auto [released, charged] = given_off(c, end.state.particles, index_of(c, name));
    REQUIRE(std::abs(released) > 0.0);
    oxygen += released;
    mass += charged;
    const auto& own = chemistry["species"][name];
    CHECK(own["oxygen_released"].get<double>() == Approx(released).epsilon(1e-6));
    CHECK(own["oxygen_per_kilogram"].get<double>() == Approx(released / charged).epsilon(1e-6));
    CHECK(own["delta_initial"].get<double>() ==
          Approx(coupling::initial_delta(c, c.species[index_of(c, name)])));
    CHECK(own["delta_final"].get<double>() ==
          Approx(end.series.values("delta_mean." + name).back()));
    CHECK(end.series.values("oxygen_released." + name).back() ==
          own["oxygen_released"].get<double>());
    CHECK(yield["species"][name]["oxygen_per_kg"].get<double>() ==
          Approx(released / charged).epsilon(1e-6));
    const auto& book = end.summary["books"]["species"][name];
    CHECK(std::abs(book["oxygen"]["residual"].get<double>()) < 1e-6 * std::abs(released));
    CHECK(std::abs(book["energy"]["residual"].get<double>()) <
          1e-3 * end.state.fluxes.heat_exchanged);
  }
  CHECK(chemistry["oxygen_released"].get<double>() == Approx(oxygen).epsilon(1e-6));
  CHECK(chemistry["oxygen_per_kilogram"].get<double>() == Approx(oxygen / mass).epsilon(1e-6));
  CHECK(yield["oxygen_per_kg"].get<double>() == Approx(oxygen / mass).epsilon(1e-6));
  CHECK(end.series.has("delta_mean"));
  // By name: where the rate of the fine ones is extrapolated, and that ceria's fit is of 1000 degC
  // and more. The fine ones end within their equilibrium's fit, from 400.6 degC on, where it begins
  // at 400.
  const std::string warnings = end.summary["warnings"].dump();
  CHECK_THAT(warnings, Catch::Contains("of the ceria particles end outside the range"));
  CHECK_THAT(warnings, Catch::Contains("of the fine particles end outside the temperatures"));
}

TEST_CASE("Several reacting species may also only be mixed") {
  const Case c = mixed({"models.mechanics_only=true"});
  const auto end = test::run_to_end(c, "mixed-mechanics");
  CHECK(end.state.particles.size() == 140);
  for (const std::string& name : reacting) CHECK(end.series.has("delta_mean." + name));
}

namespace {
// That an ideal reactor ends as warm as energy says, in equilibrium with this pressure [Pa].
void check_ideal_end(const Case& c, const State& state, double pressure) {
  const sim::IdealEnd ideal = sim::ideal_end(c, state);
  const double T = ideal.temperature;  // [K]
  double rise = 0.0, oxygen = 0.0;     // [J], [mol]
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Material& material = c.materials.list[c.species[p.species[i]].material];
    const double delta =
        material.redox ? chemistry::equilibrium_delta(material.redox->equilibrium, T, pressure)
                       : 0.0;
    const auto solid = chemistry::solid_of(material, p.mass[i], p.formula_units[i]);
    rise += chemistry::enthalpy(solid, T, delta) - p.enthalpy[i];
    oxygen += 0.5 * p.formula_units[i] * (delta - p.delta[i]);
  }
  rise += oxygen * chemistry::oxygen_heat(T).enthalpy;
  CHECK(std::abs(rise) < 1e-6 * state.opening.heat_content);
  CHECK(ideal.oxygen == Approx(oxygen).epsilon(1e-6));
  double sum = 0.0;
  for (const double part : ideal.by_species) sum += part;
  CHECK(sum == Approx(ideal.oxygen).epsilon(1e-12));
  CHECK(ideal.by_species[index_of(c, "Al2O3")] == 0.0);
}
}  // namespace

TEST_CASE("An ideal reactor brings all species to one temperature, each to its own equilibrium") {
  Case c = mixed({"react.end=\"6 s\"", "chamber.vent.start=\"6 s\""});
  const test::Folder folder("ideal");
  const sim::Simulation simulation(c, folder.path);
  check_ideal_end(c, simulation.state(), 1000.0);  // the pump's set-point
  c.chamber->pump.reset();
  check_ideal_end(c, simulation.state(), 0.21 * 101325.0);
  // Gas without any oxygen: 1e-7 Pa. With none at all an oxide would be reduced to its limit, cold.
  c.chamber->oxygen_fraction = 0.0;
  check_ideal_end(c, simulation.state(), 1e-7);
}

TEST_CASE("Peak, its nine tenths, and its part of the ideal are each species' own") {
  const Case c = mixed({"react.end=\"6 s\"", "chamber.vent.start=\"6 s\""});
  const test::Folder folder("peaks");
  const sim::Simulation simulation(c, folder.path);
  const io::Series series{{{"time", "s", {0.0, 1.0, 3.0, 4.0}},
                           {"pressure", "Pa", {1e5, 1e5, 1000.0, 1000.0}},
                           {"oxygen_released", "mol", {0.0, 0.0, 2e-6, 1e-6}},
                           {"oxygen_released.SrFeO3", "mol", {0.0, 4e-6, 4e-6, 1e-6}},
                           {"oxygen_released.fine", "mol", {0.0, 0.0, 1e-6, 1e-6}},
                           {"oxygen_released.ceria", "mol", {0.0, -1e-6, -2e-6, -3e-6}}}};
  const sim::Yield yield = sim::measure_yield(c, simulation.state(), series);
  const sim::IdealEnd ideal = sim::ideal_end(c, simulation.state());
  CHECK(yield.time_to_90 == Approx(1.0 + 2.0 * 0.9));
  CHECK(yield.part_of_ideal == Approx(2e-6 / ideal.oxygen));
  CHECK(yield.mean_pressure == Approx((2.0 * 0.5 * (1e5 + 1000.0) + 1000.0) / 3.0));
  REQUIRE(yield.species.size() == 3);
  for (const sim::SpeciesYield& one : yield.species) {
    const auto [none, mass] = given_off(c, simulation.state().particles, one.species);
    const std::string& name = c.species[one.species].name;
    if (name == "SrFeO3") {
      CHECK(one.time_to_90 == Approx(0.9));
      CHECK(one.peak_per_kg == Approx(4e-6 / mass));
      CHECK(one.part_of_ideal == Approx(4e-6 / ideal.by_species[one.species]));
    } else if (name == "fine") {
      CHECK(one.time_to_90 == Approx(1.0 + 2.0 * 0.9));
    } else {
      CHECK(std::isnan(one.time_to_90));
    }
  }
}
