// Values at the border of their allowed range work through every stage, and are the limit of what
// lies just inside.
#include <catch2/catch.hpp>
#include <cmath>

#include "io/run_file.hpp"
#include "sim/ledger.hpp"
#include "small_runs.hpp"

using namespace pmr;
using test::box_case;
using test::run_to_end;
using test::species;

namespace {

const std::string relaxation =
    "materials.SrFeO3.redox.rate={law=\"relaxation\",time=\"40 "
    "s\",reference_temperature=\"673.15 K\",reduction_energy=\"144 kJ/mol\",oxidation_energy=\"92 "
    "kJ/mol\",shortest=\"1 s\"}";

struct Chamber {
  const char* name;
  std::string keys;
};
const std::vector<Chamber> chambers{
    {"open", ""},
    {"closed", "closing = \"1 s\"\nvolume = \"0.1 l\"\n"},
    {"pumped",
     "closing = \"1 s\"\nvolume = \"0.1 l\"\npump = {start = \"1 s\", speed = \"1e-4 m3/s\", "
     "ultimate = \"0 Pa\", set_point = \"1000 Pa\"}\n"},
    {"at its ultimate",
     "closing = \"1 s\"\nvolume = \"0.1 l\"\npump = {start = \"1 s\", speed = \"1e-4 m3/s\", "
     "ultimate = \"100 Pa\", set_point = \"100 Pa\", efficiency = 1}\n"}};

std::string granule_in(const Chamber& chamber) {
  return box_case(
      "1173.15 K",
      species("granule", "SrFeO3",
              "diameter = \"1.47 mm\"\ntemperature = \"1173.15 K\"\ndelta = 0.3", "0 0 0") +
          "[react]\nend = \"60 s\"\n[chamber]\npressure = \"101325 Pa\"\noxygen_fraction = 0.21\n"
          "gas_temperature = \"1173.15 K\"\nfilm_coefficient = \"10 W/m2/K\"\nleak = \"0 "
          "mol/s/Pa\"\n" +
          chamber.keys +
          "[models]\nconduction = true\nreaction = true\n[models.radiation]\nsurroundings = "
          "\"1173.15 K\"\n");
}

test::Ended run_with(const Chamber& chamber, const std::string& set, bool relaxes) {
  std::vector<std::string> sets{set};
  if (relaxes) sets.push_back(relaxation);
  // Of the polynomial law no reaction can start at such a delta: its pressure is out of all range.
  if (set == "species.granule.delta=1e-9")
    sets.emplace_back("materials.SrFeO3.redox.equilibrium.enthalpy=\"arctan\"");
  return run_to_end(test::load(granule_in(chamber), sets), "border");
}

bool has_broken_books(const nlohmann::json& summary) {
  for (const auto& warning : summary["warnings"])
    if (warning.get<std::string>().find("books") != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("Without any oxygen a run ends as with the last trace of it, by both rate laws") {
  for (const bool relaxes : {false, true})
    for (const Chamber& chamber : chambers) {
      INFO(chamber.name << (relaxes ? ", relaxation" : ", power"));
      const auto none = run_with(chamber, "chamber.oxygen_fraction=0.0", relaxes);
      CHECK_FALSE(has_broken_books(none.summary));
      for (const char* trace : {"1e-12", "1e-9"}) {
        const auto some =
            run_with(chamber, std::string("chamber.oxygen_fraction=") + trace, relaxes);
        CHECK_FALSE(has_broken_books(some.summary));
        CHECK(none.state.particles.delta[0] == Approx(some.state.particles.delta[0]).epsilon(1e-5));
        for (const char* key : {"oxygen_per_kg", "ideal_per_kg", "ideal_temperature"}) {
          const auto &a = none.summary["yield"][key], &b = some.summary["yield"][key];
          REQUIRE(a.is_number());
          // With 1e-4 Pa a hot charge holds a little more back.
          CHECK(a.get<double>() == Approx(b.get<double>()).epsilon(2e-2));
        }
      }
    }
}

TEST_CASE("Other values at a border run to their end with books that close") {
  for (const char* set :
       {"chamber.oxygen_fraction=1.0", "chamber.pressure=\"1e-3 Pa\"", "species.granule.delta=1e-9",
        "species.granule.delta=1e-5", "species.granule.delta=0.499999999",
        "species.granule.delta={equilibrium_at=\"300 K\",oxygen=\"1 bar\"}",
        "species.granule.delta={equilibrium_at=\"2900 K\",oxygen=\"1e-30 Pa\"}",
        "materials.SrFeO3.emissivity=1.0", "materials.SrFeO3.emissivity=0.001",
        "materials.coated-wall.emissivity=1.0", "chamber.film_coefficient=\"0 W/m2/K\"",
        "materials.SrFeO3.redox.rate.factor=0.0", "materials.SrFeO3.accommodation=1.0",
        "models.conduction={bed_solid_fraction=0.74}", "models.conduction={gap_reach=2}",
        "models.conduction={shells=2}"})
    for (const Chamber& chamber : {chambers[0], chambers[2]}) {
      INFO(chamber.name << ": " << set);
      const auto end = run_with(chamber, set, false);
      CHECK_FALSE(has_broken_books(end.summary));
      CHECK(std::isfinite(end.state.particles.temperature[0]));
    }
}

TEST_CASE("A run without any oxygen goes on from its checkpoint with the same bits") {
  const Case c = test::load(granule_in(chambers[2]), {"chamber.oxygen_fraction=0.0"});
  const State whole = run_to_end(c, "whole").state;
  const test::Folder folder("cut");
  {
    std::atomic<bool> stop{false};
    sim::Simulation first(c, folder.path);
    first.run(stop, [&](const sim::Simulation& now) { stop = now.state().gas.closed; });
    REQUIRE(first.state().gas.closed);
  }
  const std::atomic<bool> never{false};
  sim::Simulation second(c, folder.path, io::load_checkpoint(folder.path));
  second.run(never, [](const auto&) {});
  CHECK(io::state_hash(second.state()) == io::state_hash(whole));
}
