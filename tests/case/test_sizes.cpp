// Size distributions of a species.
#include <catch2/catch.hpp>
#include <fstream>

#include "helpers.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

// The small case with a size table instead of its diameter.
std::string sized(const std::string& table) {
  return replaced(small_case, "diameter = \"2.99 mm\"", "size = {" + table + "}");
}

// Its only fault.
std::string told(const std::string& table) {
  const auto faults = faults_of(sized(table));
  return faults.size() == 1 ? faults[0] : std::to_string(faults.size()) + " faults";
}

struct CsvFile {
  std::string path;
  explicit CsvFile(const std::string& text) : path(temporary("pmr_sizes.csv")) {
    std::ofstream(path) << text;
  }
  std::string table() const { return "law = \"csv\", csv = \"" + path + "\""; }
};

}  // namespace

TEST_CASE("A mass is drawn from a distribution to within half a particle") {
  const Case c = load(sized("law = \"log-normal\", median = \"3 mm\", log_deviation = 0.1"));
  const Species& beads = c.species.at(0);
  CHECK(beads.count == beads.diameters.size());
  CHECK(beads.count > 100);
  const double density = c.materials.list[beads.material].density;
  const double largest = density * pi / 6.0 * std::pow(largest_diameter(beads), 3);
  CHECK(std::abs(density * solid_volume(beads) - 0.01) < 0.5 * largest);
  // Without bounds a thousandth of the mass is left out at either end, exp(3.09 * 0.1) times 3 mm.
  CHECK(largest_diameter(beads) <= 3e-3 * std::exp(0.30903));
  CHECK(smallest_diameter(beads) >= 3e-3 * std::exp(-0.30903));
  CHECK(beads.diameter < 3e-3);  // Sauter diameter lies below the median of mass
  const Case again = load(c.text);
  CHECK(again.species[0].diameters == beads.diameters);
  CHECK(load(c.text, {"seed=2"}).species[0].diameters != beads.diameters);
}

TEST_CASE("Stated bounds hold") {
  const Species beads =
      load(sized("law = \"rosin-rammler\", scale = \"3 mm\", exponent = 3, smallest = \"2 mm\", "
                 "largest = \"3.5 mm\""))
          .species.at(0);
  CHECK(smallest_diameter(beads) >= 2e-3);
  CHECK(largest_diameter(beads) <= 3.5e-3);
  CHECK(largest_diameter(beads) > 3.2e-3);
}

TEST_CASE("A CSV file gives classes or a curve") {
  const CsvFile classes("diameter [mm], mass_fraction\n2, 0.25\n3, 0.75\n");
  const Species two = load(sized(classes.table())).species.at(0);
  CHECK(smallest_diameter(two) == Approx(2e-3).epsilon(1e-15));
  CHECK(largest_diameter(two) == Approx(3e-3).epsilon(1e-15));
  const CsvFile curve("diameter [um], passing\n1500, 0\n2500, 0.5\n4000, 1\n");
  const Species many = load(sized(curve.table())).species.at(0);
  CHECK(smallest_diameter(many) >= 1.5e-3);
  CHECK(largest_diameter(many) > 3e-3);
  CHECK(largest_diameter(many) <= 4e-3);
}

TEST_CASE("Faults of a size distribution are named") {
  CHECK_THAT(told("law = \"lognormal\", median = \"3 mm\""), Contains("'log-normal'"));
  CHECK_THAT(told("law = \"normal\", mean = \"3 mm\", deviation = \"1 mm\""),
             Contains("size.deviation") && Contains("below zero"));
  CHECK_THAT(told("law = \"normal\", mean = \"3 mm\", deviaton = \"0.1 mm\""),
             Contains("'deviaton' is unknown; did you mean 'deviation'?"));
  CHECK_THAT(told("law = \"classes\", diameter = \"2 3 mm\", mass_fraction = [0.5, 0.4]"),
             Contains("add up to 0.9; wanted 1"));
  CHECK_THAT(told("law = \"classes\", diameter = \"2 3 mm\", mass_fraction = [1.0]"),
             Contains("1 mass fractions for 2 diameters"));
  CHECK_THAT(told("law = \"csv\", csv = \"nowhere.csv\""), Contains("cannot be read"));
  CHECK_THAT(told(CsvFile("diameter [mm], passing\n2, 0.1\n3, 1\n").table()),
             Contains("ascend from 0 to 1"));
  CHECK_THAT(told(CsvFile("diameter, passing\n2, 0\n3, 1\n").table()),
             Contains(":1:1: diameter: has no unit"));
  CHECK_THAT(told(CsvFile("diameter [mm], passing\n2, 0\nthree, 1\n").table()),
             Contains(":3:1: diameter: 'three'"));
  const auto both = faults_of(replaced(small_case, "mass = ",
                                       "size = {law = \"normal\", mean = \"3 mm\", deviation = "
                                       "\"0.1 mm\"}\nmass = "));
  REQUIRE(both.size() == 1);
  CHECK_THAT(both[0], Contains("diameter or size, not both"));
}
