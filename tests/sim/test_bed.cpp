// Runs that start from the bed of another run, or from a text dump.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "case/case.hpp"
#include "folder.hpp"
#include "io/run_file.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/errors.hpp"
#include "sim/simulation.hpp"

namespace fs = std::filesystem;
using namespace pmr;
using Catch::Contains;
using pmr::test::Folder;

namespace {

const std::atomic<bool> never{false};

Case tiny(const std::vector<std::string>& sets = {}) {
  return casefile::load_case(fs::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml", sets);
}

std::string bed_is(const fs::path& path) { return "bed=\"" + path.string() + "\""; }

// A complete run of the tiny case in a folder, with the header that names species and walls.
State run_tiny(const fs::path& folder, const Case& c) {
  io::RunHeader header{c.text, {}, {}, {}};
  for (const Species& species : c.species) header.species.push_back(species.name);
  for (const auto& patch : coupling::number_nodes(c, 0).patches)
    header.patches.push_back(patch.name);
  io::create_run(folder, header);
  sim::Simulation simulation(c, folder);
  REQUIRE(simulation.run(never, [](const auto&) {}) == sim::Ending::completed);
  return simulation.state();
}

std::string refused(const Case& c) {
  try {
    sim::read_bed(c);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string head =
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
    "ITEM: ATOMS id type radius x y z vx vy vz\n";

// A bead and two granules on the cup's floor, none touching.
fs::path dump_in(const Folder& folder, const std::string& atoms) {
  fs::path path = folder.path / "bed.dump";
  std::ofstream(path) << head << atoms;
  return path;
}
const std::string three =
    "30 2 0.0008 0.003 0 0.0009 0 0 0.5\n10 1 0.0015 0 0 0.0015 0 0 0\n"
    "20 2 0.0007 -0.003 0 0.0007 0 0 0\n";

}  // namespace

TEST_CASE("A bed comes from a run bit for bit, with its springs, heated as the case says") {
  const Folder folder("run");
  const State end = run_tiny(folder.path, tiny({"react.end=\"0.2 s\""}));
  REQUIRE(end.phase == Phase::done);
  const Case c = tiny({bed_is(folder.path), "species.Al2O3.temperature=\"900 degC\""});
  sim::Bed bed = sim::read_bed(c);
  CHECK(bed.particles.id == end.particles.id);
  CHECK(bed.particles.species == end.particles.species);
  CHECK(bed.particles.radius == end.particles.radius);
  CHECK(bed.particles.position == end.particles.position);
  CHECK(bed.particles.velocity == end.particles.velocity);
  CHECK(bed.particles.spin == end.particles.spin);
  CHECK(bed.pair_contacts.partner == end.pair_contacts.partner);
  CHECK(bed.pair_contacts.tangential == end.pair_contacts.tangential);
  CHECK(bed.pair_contacts.rolling == end.pair_contacts.rolling);
  CHECK(bed.wall_contacts.partner == end.wall_contacts.partner);
  CHECK(bed.wall_contacts.tangential == end.wall_contacts.tangential);
  CHECK(bed.pair_contacts.partner.size() > 30);
  CHECK(bed.overlap_ratio > 0.0);
  CHECK(bed.time == end.settled_at);

  // The mix phase of the case ends at 80 ms, where the bed's clock stands: it reacts at once.
  const Folder second("second");
  io::create_run(second.path, {});
  sim::Simulation simulation(c, second.path, std::move(bed));
  CHECK(simulation.state().phase == Phase::react);
  CHECK(simulation.state().settled_at == end.settled_at);
  for (std::size_t i = 0; i < end.particles.size(); ++i)
    if (end.particles.species[i] == 0)
      CHECK(simulation.state().particles.temperature[i] == Approx(1173.15));
}

TEST_CASE("A bed's springs follow their walls by name, and go where the wall is not there") {
  const Folder folder("walls");
  const State end = run_tiny(folder.path, tiny({"react.end=\"0.2 s\""}));
  const auto on = [](const ContactHistory& h, std::uint32_t surface) {
    return std::count(h.partner.begin(), h.partner.end(), surface);
  };
  REQUIRE(tiny().walls.surfaces[0].name == "floor");
  REQUIRE(on(end.wall_contacts, 0) > 0);
  REQUIRE(on(end.wall_contacts, 1) > 0);
  // A wall that comes first by name; and the floor called by another.
  const std::string extra =
      "walls.above={kind=\"plane\",material=\"coated-wall\",point=\"0 0 59 mm\",normal=[0,0,-1],"
      "thermal={kind=\"adiabatic\"}}";
  const sim::Bed shifted = sim::read_bed(tiny({bed_is(folder.path), extra}));
  CHECK(on(shifted.wall_contacts, 1) == on(end.wall_contacts, 0));
  CHECK(on(shifted.wall_contacts, 2) == on(end.wall_contacts, 1));
  CHECK(on(shifted.wall_contacts, 0) == 0);
}

TEST_CASE("A bed from a run that goes on moving has the same bits on resuming") {
  const Folder source("source"), whole("whole"), cut("cut");
  run_tiny(source.path, tiny({"react.end=\"0.2 s\""}));
  const Case c = tiny({bed_is(source.path), "mix.duration=\"140 ms\"", "mix.not_before=\"140 ms\"",
                       "react.end=\"1 s\""});
  const auto start = [&](const fs::path& folder) {
    io::create_run(folder, {});
    return sim::Simulation(c, folder, sim::read_bed(c));
  };
  auto first = start(whole.path);
  CHECK(first.state().phase == Phase::mix);
  first.run(never, [](const auto&) {});
  {
    std::atomic<bool> stop{false};
    auto second = start(cut.path);
    second.run(stop, [&](const sim::Simulation& now) { stop = now.state().interval >= 2; });
    REQUIRE(second.state().phase == Phase::mix);
  }
  sim::Simulation third(c, cut.path, io::load_checkpoint(cut.path));
  third.run(never, [](const auto&) {});
  CHECK(io::state_hash(third.state()) == io::state_hash(first.state()));
}

TEST_CASE("A dump opens a run: ids in the dump's order, radii as given, masses by density") {
  const Folder folder("dump");
  Case c = tiny({bed_is(dump_in(folder, three))});
  const sim::Bed bed = sim::read_bed(c);
  const Particles& p = bed.particles;
  REQUIRE(p.size() == 3);
  CHECK(p.id == std::vector<ParticleId>{0, 1, 2});
  CHECK(p.species == std::vector<SpeciesIndex>{0, 1, 1});
  CHECK(p.radius == std::vector<double>{0.0015, 0.0007, 0.0008});
  CHECK(p.velocity[2] == Vec3(0, 0, 0.5));
  // 3690 and 3460 kg/m3 (Richter et al., table 1).
  CHECK(p.mass[0] == Approx(3690.0 * 4.0 / 3.0 * M_PI * std::pow(0.0015, 3)));
  CHECK(p.mass[1] == Approx(3460.0 * 4.0 / 3.0 * M_PI * std::pow(0.0007, 3)));
  CHECK(p.temperature[0] == Approx(1373.15));
  CHECK(bed.time == 0.0);
  sim::count_bed(p, c);
  CHECK(c.species[1].count == 2);
  CHECK(smallest_diameter(c.species[1]) == 0.0014);
  CHECK(physics::time_step(c).smallest_rayleigh ==
        Approx(physics::rayleigh_step(0.0007, 3460.0, 5e6 / 2.6, 0.3)));
}

TEST_CASE("Atom types go to the species that the case names") {
  const Folder folder("types");
  const std::string bed = bed_is(dump_in(folder, three));
  const sim::Bed swapped =
      sim::read_bed(tiny({bed, "species.Al2O3.dump_type=2", "species.SrFeO3.dump_type=1"}));
  CHECK(swapped.particles.species == std::vector<SpeciesIndex>{1, 0, 0});
  CHECK_THAT(refused(tiny({bed, "species.Al2O3.dump_type=1"})),
             Contains("2 atoms are of type 2") && Contains("1 = Al2O3"));
  CHECK_THROWS_WITH(tiny({bed, "species.Al2O3.dump_type=2", "species.SrFeO3.dump_type=2"}),
                    Contains("the same dump_type 2"));
}

TEST_CASE("Beds that cannot be are refused with figures") {
  const Folder folder("bad");
  const auto told = [&](const std::string& atoms) {
    return refused(tiny({bed_is(dump_in(folder, atoms))}));
  };
  CHECK(told(three) == "accepted");
  CHECK_THAT(told("1 1 0.0015 0 0 0.0015 0 0 0\n2 1 0.0015 0 0 0.0036 0 0 0\n"
                  "3 1 0.0015 0 0 0.01 0 0 0\n"),
             Contains("1 pairs overlap") && Contains("60.0 %"));
  CHECK_THAT(told("1 1 0.0015 0 0 0.0006 0 0 0\n2 1 0.0015 0 0 0.006 0 0 0\n"
                  "3 1 0.0015 0 0 0.01 0 0 0\n"),
             Contains("overlap wall 'floor'") && Contains("60.0 %"));
  CHECK_THAT(told("1 1 0.0015 0 0 0.15 0 0 0\n2 1 0.0015 0 0 0.006 0 0 0\n"
                  "3 1 0.0015 0 0 0.01 0 0 0\n"),
             Contains("1 of 3 particles lie outside the domain"));
  CHECK_THAT(refused(tiny({"bed=\"/nowhere/bed\""})), Contains("does not exist"));
  CHECK_THAT(refused(tiny({bed_is(folder.path)})), Contains("holds no checkpoint.h5"));
  fs::create_directories(folder.path / "empty");
  CHECK_THAT(refused(tiny({bed_is(folder.path / "empty")})), Contains("neither a run folder"));
}
