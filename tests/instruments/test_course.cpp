// The CSV files of the instruments.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "beds.hpp"
#include "instruments/course.hpp"

using namespace pmr;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> lines(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> found;
  for (std::string line; std::getline(in, line);) found.push_back(line);
  return found;
}

// Beads are species 1 here: the redox material tells.
Case two_species() {
  Case setup{};
  setup.gravity = Vec3(0.0, 0.0, -9.80665);
  setup.materials.list.resize(2);
  setup.materials.list[0].redox = Redox{};
  setup.species.resize(2);
  setup.species[0].material = 0;
  setup.species[1].material = 1;
  setup.materials.list[0].density = 1000.0;
  setup.materials.list[1].density = 2000.0;
  setup.decomposition = test::tool({0.5, 0.25});
  setup.decomposition->reference = MixtureReference{"measured.csv", {3.0, 2.0}, {}};
  setup.thermocouples = {{"core", Vec3::Zero(), 0.01}};
  setup.species[0].name = "granule";
  setup.species[1].name = "bead";
  return setup;
}

Particles ring_bed() {
  Particles bed;
  for (std::size_t s = 0; s < 8; ++s)
    for (const double z : {0.001, 0.002, 0.003, 0.004}) {
      test::add_sphere(bed, 0, test::on_ring(s, z), 0.0005, 0.9);  // lighter by its oxygen
      test::add_sphere(bed, 1, test::on_ring(s, z), 0.0005, 1.0);
    }
  return bed;
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("pmr_course_" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

State with(Particles bed) {
  State state;
  state.particles = std::move(bed);
  return state;
}

}  // namespace

TEST_CASE("Redox tells granules from beads, whatever their order") {
  using enum instruments::Side;
  using Sides = instruments::Sides;
  CHECK(instruments::beads_and_granules(two_species()) == Sides{granules, beads});
  Case three = two_species();  // two sizes of granules with the beads
  three.species.push_back(three.species[0]);
  CHECK(instruments::beads_and_granules(three) == Sides{granules, beads, granules});
  Case inert = two_species();
  inert.materials.list[0].redox.reset();
  CHECK(instruments::beads_and_granules(inert) == Sides{beads, granules});
  inert.species.pop_back();
  CHECK_FALSE(instruments::beads_and_granules(inert));
}

TEST_CASE("Instruments write what was recorded, each its file, with units") {
  const Folder folder;
  const io::Series series{{{"time", "s", {0.0, 1.0}},
                           {"pressure", "Pa", {101325.0, 1000.0}},
                           {"oxygen_released", "mol", {0.0, 0.5}},
                           {"thermocouple.core", "K", {300.0, 950.5}}}};
  instruments::write_instruments(folder.path(), two_species(), series, with(ring_bed()));
  const fs::path dir = folder.path() / "instruments";
  CHECK(lines(dir / "gauge.csv") ==
        std::vector<std::string>{"time [s],pressure [Pa]", "0,101325", "1,1000"});
  CHECK(lines(dir / "oxygen.csv") ==
        std::vector<std::string>{"time [s],oxygen_released [mol]", "0,0", "1,0.5"});
  CHECK(lines(dir / "thermocouples.csv").at(2) == "1,950.5");
  const auto layers = lines(dir / "decomposition.csv");
  REQUIRE(layers.size() == 1 + 2 + 1);
  CHECK(layers[0] ==
        "layer [1],mass [kg],thickness [m],top [m],mass_ratio [1],sector_mean_ratio [1],"
        "left_right_asymmetry [1],reference_mass_ratio [1],deviation [1]");
  // w = 2 in every section by the stated densities, against 3 and 2; alike left and right.
  CHECK_THAT(layers[1], Catch::EndsWith(",2,2,0,3,0.33333333333333337"));
  CHECK_THAT(layers[2], Catch::EndsWith(",2,2,0,2,0"));
  const double sphere = 4.0 / 3.0 * pi * 0.0005 * 0.0005 * 0.0005;               // [m3]
  CHECK(std::stod(layers[3].substr(2)) == Approx(0.25 * 32 * 3000.0 * sphere));  // the residuum
  CHECK_THAT(layers[3], Catch::EndsWith(",nan,nan"));
  CHECK(lines(dir / "sections.csv").size() == 1 + 2 * 8);
  // Of each species one sphere in the same place: it touches that one, and those above and below.
  const auto contacts = lines(dir / "contacts.csv");
  REQUIRE(contacts.size() == 1 + 10);
  CHECK_THAT(contacts[0],
             Catch::StartsWith("layer [1],top [m],bottom [m],particles.granule [1],") &&
                 Catch::Contains(",touched_by.bead.granule [1]"));
  CHECK(contacts[1] == "1,0.004,0.0036,0,nan,nan,nan,0,nan,nan,nan");  // radii keep centres below
  CHECK_THAT(contacts[2], Catch::StartsWith("2,0.0036") && Catch::Contains(",8,"));
}

TEST_CASE("Instruments that a case does not have write no file") {
  const Folder folder;
  const io::Series series{{{"time", "s", {0.0}}, {"kinetic_energy", "J", {0.0}}}};
  instruments::write_instruments(folder.path(), Case{}, series, State{});
  CHECK(fs::is_empty(folder.path() / "instruments"));
}
