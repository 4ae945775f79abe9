// What a run says of the ground its models stand on: each limit at its figure, on both sides.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "chemistry/redox.hpp"
#include "coupling/thermal_state.hpp"
#include "physics/time_step.hpp"
#include "sim/ledger.hpp"
#include "sim/summary.hpp"
#include "sim/yield.hpp"
#include "small_runs.hpp"

using namespace pmr;
using Catch::Contains;

namespace {

State opening(const Case& c) {
  const test::Folder folder("limits");
  return sim::Simulation(c, folder.path).state();
}

// The tiny reactor as it begins: 20 beads of 1100 degC, 120 granules of 700 degC.
struct Tiny {
  explicit Tiny(const std::vector<std::string>& sets = {})
      : setup(casefile::load_case(std::filesystem::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml",
                                  sets)),
        state(opening(setup)) {}

  std::string told() const {
    std::string all;
    for (const std::string& limit : sim::limits_touched(setup, state)) all += limit + "\n";
    return all;
  }
  // Of so many granules.
  void set(std::size_t granules, std::vector<double> Particles::*figure, double value) {
    Particles& p = state.particles;
    for (std::size_t i = 0; i < p.size() && granules > 0; ++i)
      if (setup.species[p.species[i]].name == "SrFeO3") {
        (p.*figure)[i] = value;
        --granules;
      }
  }

  Case setup;
  State state;
};

const Redox& ferrite(const Tiny& tiny) {
  for (const Material& material : tiny.setup.materials.list)
    if (material.redox) return *material.redox;
  throw std::logic_error("the tiny reactor has granules");
}

}  // namespace

TEST_CASE("An overlap of more than a twentieth of the radius is told") {
  Tiny tiny;
  tiny.state.extremes.overlap_ratio = 0.0499;
  CHECK_THAT(tiny.told(), !Contains("overlap"));
  tiny.state.extremes.overlap_ratio = 0.0731;
  CHECK_THAT(tiny.told(), Contains("The largest overlap was 7.3 % of the radius"));
}

TEST_CASE("A time step above 40 % of Rayleigh's is told") {
  const Tiny tiny;
  CHECK_THAT(tiny.told(), !Contains("Rayleigh"));
  const double critical =
      physics::time_step(tiny.setup).step / physics::time_step(tiny.setup).fraction;  // [s]
  const auto with = [&](double fraction) {
    return Tiny({"models.mechanics.allow_long_time_step=true",
                 "models.mechanics.time_step=\"" + std::to_string(1e9 * fraction * critical) +
                     " ns\""})
        .told();
  };
  CHECK_THAT(with(0.399), !Contains("Rayleigh"));
  CHECK_THAT(with(0.44), Contains("The time step is 44 % of the Rayleigh step"));
}

TEST_CASE("Particles that never came in, or left, are told with number and first time") {
  Tiny tiny;
  CHECK_THAT(tiny.told(), !Contains("poured in") && !Contains("left the domain"));
  resize(tiny.state.waiting, 3);
  tiny.state.lost = {{17, 0.25, Vec3::Zero()}, {18, 0.5, Vec3::Zero()}};
  CHECK_THAT(tiny.told(),
             Contains("3 particles were still to be poured in") &&
                 Contains("2 particles left the domain; the first, 17, at t = 0.25 s"));
}

TEST_CASE(
    "A fit that a thousandth of a species' particles have left is told, by part and species") {
  Tiny tiny;
  const Redox& redox = ferrite(tiny);
  const RedoxEquilibrium& fit = redox.equilibrium;
  tiny.set(120, &Particles::temperature, 0.5 * (fit.fit_temperature_minimum + 973.15));
  tiny.set(120, &Particles::delta, 0.5 * (fit.fit_delta_minimum + fit.fit_delta_maximum));
  CHECK_THAT(tiny.told(), !Contains("equilibrium was fitted"));
  // Each border by itself, just beyond; the rest of the bed within.
  const std::vector<std::pair<std::vector<double> Particles::*, double>> beyond{
      {&Particles::delta, fit.fit_delta_minimum - 1e-6},
      {&Particles::delta, fit.fit_delta_maximum + 1e-6},
      {&Particles::temperature, fit.fit_temperature_minimum - 1e-3},
      {&Particles::temperature, fit.fit_temperature_maximum + 1e-3}};
  for (const auto& [figure, value] : beyond) {
    Tiny out = tiny;
    out.set(12, figure, value);
    CHECK_THAT(out.told(), Contains("10 % of the SrFeO3 particles end outside the range"));
    out = tiny;
    out.set(1, figure, value);
    CHECK_THAT(out.told(), Contains("0.8 % of the SrFeO3 particles end outside the range"));
  }
  // Air of the open chamber has 0.21 bar of oxygen; a fit that ends below holds for no particle.
  for (Material& material : tiny.setup.materials.list)
    if (material.redox) material.redox->equilibrium.fit_pressure_maximum = 21000.0;
  CHECK_THAT(tiny.told(), Contains("100 % of the SrFeO3 particles end outside the range"));
}

TEST_CASE("The temperatures of a rate's fit are told apart from those of the equilibrium's") {
  Tiny tiny;
  const Redox& redox = ferrite(tiny);
  tiny.set(120, &Particles::temperature, redox.rate_temperature_maximum - 1.0);
  CHECK_THAT(tiny.told(), !Contains("their rate was fitted"));
  for (const double T :
       {redox.rate_temperature_maximum + 1.0, redox.rate_temperature_minimum - 1.0}) {
    tiny.set(30, &Particles::temperature, T);
    CHECK_THAT(tiny.told(), Contains("25 % of the SrFeO3 particles end outside the temperatures "
                                     "that their rate was fitted at"));
  }
}

TEST_CASE("Tables over temperature say where particles began or ended beyond them") {
  const std::string rows = "materials.Al2O3.conductivity={law=\"table\", value=\"6 7 W/m/K\", ";
  const Tiny within({rows + "temperature=\"100 1200 degC\"}"});
  CHECK_THAT(within.told(), !Contains("conductivity of Al2O3"));
  const Tiny beyond({rows + "temperature=\"100 1000 degC\"}"});
  CHECK_THAT(beyond.told(),
             Contains("The conductivity of Al2O3 is given from 100 to 1000 degC; its "
                      "particles begin outside, 100 % of them end outside"));
}

TEST_CASE("An initial delta that is frozen in above the charge is told with what 50 K of it do") {
  CHECK_THAT(Tiny().told(), !Contains("is a guess"));
  const Tiny tiny({"species.SrFeO3.delta.equilibrium_at=\"800 degC\""});
  const RedoxEquilibrium& eq = ferrite(tiny).equilibrium;
  const auto delta = [&](double celsius) {
    return fmt::format("{:.3f}", chemistry::equilibrium_delta(eq, celsius + zero_celsius, 0.21e5));
  };
  CHECK_THAT(tiny.told(),
             Contains("The initial delta of SrFeO3 is a guess: " + delta(800.0) +
                      ", frozen in at 800 degC. Frozen in at 750 or 850 degC it would be " +
                      delta(750.0) + " or " + delta(850.0)) &&
                 Contains(fmt::format("instead of {:.3g}",
                                      sim::ideal_end(tiny.setup, tiny.state).oxygen)));
}

TEST_CASE("Books that do not close are told with their residuals") {
  Tiny tiny;
  CHECK_THAT(tiny.told(), !Contains("books"));
  tiny.state.fluxes.to_outside += 1e-3 * tiny.state.opening.heat_content;
  const sim::Balance books = sim::close_books(tiny.setup, tiny.state);
  CHECK_THAT(tiny.told(),
             Contains(fmt::format("The books do not close: energy {:.1e}", books.energy_relative)));
}

TEST_CASE("Particles that are taken as isothermal are told, shells are not") {
  CHECK_THAT(Tiny().told(), Contains("Particles are taken as isothermal"));
  CHECK_THAT(Tiny({"models.conduction={shells=4}"}).told(), !Contains("isothermal"));
}
