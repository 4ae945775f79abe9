// Contact, gap, radiation and wall shares of a bead and a granule whose conductances are known.
#include <catch2/catch.hpp>
#include <cmath>

#include "coupling/network.hpp"
#include "coupling/outlook.hpp"
#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"
#include "sim/heat_paths.hpp"
#include "sim/ledger.hpp"
#include "small_runs.hpp"

using namespace pmr;

namespace {

constexpr double hot = 1373.15, cold = 973.15, wall = 300.0;  // [K]

struct Scene {
  Case setup;
  State state;
  coupling::Nodes nodes;

  explicit Scene(const std::string& granule) {
    const std::string delta = granule == "Al2O3" ? "" : "\ndelta = 0.3";
    setup = test::load(test::box_case(
        "300 K",
        test::species("bead", "Al2O3", "diameter = \"3 mm\"\ntemperature = \"1373.15 K\"",
                      "0 0 0") +
            test::species("granule", granule,
                          "diameter = \"1.5 mm\"\ntemperature = \"973.15 K\"" + delta, "5 0 0") +
            "[react]\nend = \"1 s\"\n[models]\nconduction = {gap = false}\n"));
    resize(state.particles, 2);
    Particles& p = state.particles;
    for (std::size_t i = 0; i < 2; ++i) {
      p.id[i] = static_cast<ParticleId>(i);
      p.species[i] = static_cast<SpeciesIndex>(i);
      p.radius[i] = 0.5 * setup.species[i].diameter;
      p.mass[i] = setup.materials.list[setup.species[i].material].density * pi / 6.0 *
                  std::pow(setup.species[i].diameter, 3);
      p.temperature[i] = i == 0 ? hot : cold;
    }
    nodes = coupling::number_nodes(setup, 2);
    coupling::begin_thermal_state(setup, nodes, state);
    state.phase = Phase::react;
  }

  void advance(double dt, std::vector<coupling::HeatLink> links) {
    coupling::advance_network(setup, nodes, coupling::look_ahead(setup, state, 0.0),
                              std::move(links), {}, 0.0, dt, state);
  }
  sim::HeatPair pair(const std::string& from, const std::string& to) const {
    for (const sim::HeatPair& found : sim::heat_pairs(setup, state))
      if (found.from == from && found.to == to) return found;
    FAIL("no pair " << from << " to " << to);
    return {};
  }
};

// Factors [m2] bead-granule, bead-wall, granule-wall, in symmetric rows of all radiating nodes.
void radiate(Scene& scene, double between, double bead, double granule) {
  const std::size_t nodes = scene.nodes.radiating();
  const std::uint32_t patch = scene.nodes.patch(0);
  Csr& g = scene.state.exchange.factor;
  g.start.assign(1, 0);
  g.column = {1, patch, 0, patch, 0, 1};
  g.value = {between, bead, between, granule, bead, granule};
  for (std::size_t row = 0; row < nodes; ++row)
    g.start.push_back(row == 0 ? 2 : row < patch ? 4 : 6);
}

}  // namespace

TEST_CASE("Each path carries what its conductance says, and is booked as that path") {
  for (const char* granule : {"SrFeO3", "Al2O3"}) {  // with a redox species, and without
    INFO(granule);
    Scene scene(granule);
    const coupling::Node patch = scene.nodes.patch(0);
    constexpr double dt = 1e-3;  // [s] so short that temperatures change by less than 0.1 %
    radiate(scene, 2e-6, 3e-6, 5e-7);
    scene.advance(dt, {{0, 1, 2e-3, 5e-3}, {0, patch, 1e-3, 3e-3}, {1, patch, 7e-4, 4e-3}});
    const auto emission = [](double T) { return stefan_boltzmann * T * T * T * T; };
    const auto carried = [&](double conductance, double from, double to) {
      return Approx(conductance * (from - to) * dt).epsilon(2e-3);
    };
    const auto radiated = [&](double factor, double from, double to) {
      return Approx(factor * (emission(from) - emission(to)) * dt).epsilon(4e-3);
    };
    const sim::HeatPair both = scene.pair("bead", "granule");
    CHECK(both.contact == carried(2e-3, hot, cold));
    CHECK(both.gap == carried(5e-3, hot, cold));
    CHECK(both.radiation == radiated(2e-6, hot, cold));
    const sim::HeatPair bead = scene.pair("bead", "walls"), small = scene.pair("granule", "walls");
    CHECK(bead.contact == carried(1e-3, hot, wall));
    CHECK(bead.gap == carried(3e-3, hot, wall));
    CHECK(bead.radiation == radiated(3e-6, hot, wall));
    CHECK(small.contact == carried(7e-4, cold, wall));
    CHECK(small.gap == carried(4e-3, cold, wall));
    CHECK(small.radiation == radiated(5e-7, cold, wall));
    const sim::HeatPaths paths = sim::heat_paths(scene.setup, scene.state);
    CHECK(paths.contact == both.contact);
    CHECK(paths.gap == both.gap);
    CHECK(paths.radiation == both.radiation);
    CHECK(paths.to_walls == Approx(bead.contact + bead.gap + bead.radiation + small.contact +
                                   small.gap + small.radiation));
    CHECK(scene.state.fluxes.to_outside == Approx(paths.to_walls).epsilon(1e-9));
    // What the particles hold less, as well as the solver's tolerance tells.
    for (const sim::SpeciesBalance& book : sim::species_books(scene.setup, scene.state))
      CHECK(std::abs(book.energy_residual) < 1e-3 * both.gap);
  }
}

TEST_CASE("Particles of one species exchange no heat with others, however much among themselves") {
  Scene scene("Al2O3");
  scene.state.particles.species[1] = 0;
  coupling::begin_thermal_state(scene.setup, scene.nodes, scene.state);
  scene.advance(1e-3, {{0, 1, 2e-3, 5e-3}});
  for (const sim::HeatPair& pair : sim::heat_pairs(scene.setup, scene.state)) {
    CHECK(pair.contact == 0.0);
    CHECK(pair.gap == 0.0);
  }
}

TEST_CASE("A film of gas is booked between a species and the gas") {
  Scene scene("SrFeO3");
  const double air = scene.state.particles.temperature[1] - 400.0;
  scene.setup.chamber = ChamberCase{};
  scene.setup.chamber->closing = 1e9;
  scene.setup.chamber->pressure = 1e5;
  scene.setup.chamber->gas_temperature = air;
  scene.advance(1e-3, {{1, scene.nodes.gas(), 0.0, 2e-3}});
  CHECK(scene.pair("granule", "gas").gap == Approx(2e-3 * 400.0 * 1e-3).epsilon(2e-3));
  CHECK(scene.pair("bead", "gas").gap == 0.0);
}
