// Particles in CSV files as spreadsheets and scripts write them.
#include <catch2/catch.hpp>
#include <fstream>

#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

// The small case with its beads from a CSV file of this text.
class SheetCase {
 public:
  explicit SheetCase(const std::string& sheet) { std::ofstream(file_, std::ios::binary) << sheet; }
  ~SheetCase() { std::filesystem::remove(file_); }

  std::vector<ExplicitParticle> particles() const { return load(text()).particles; }
  std::string faults() const {
    std::string all;
    for (const std::string& fault : faults_of(text())) all += fault + "\n";
    return all;
  }

 private:
  std::string text() const {
    std::string text = replaced(small_case, "mass = \"10 g\"\n", "");
    const std::string region =
        "region = {base = \"0 0 0 m\", radius = \"20 mm\", height = \"80 mm\"}";
    return "particles = {csv = \"" + file_ + "\"}\n" + replaced(text, region, "");
  }
  std::string file_ = temporary("pmr_test_sheet.csv");
};

const std::string header = "species, x [mm], y [mm], z [mm]\n";

}  // namespace

TEST_CASE("a sheet with byte order mark, CRLF, comments, plus signs and exponents is read") {
  const auto particles = SheetCase(
                             "\xEF\xBB\xBFspecies, x [mm], y [mm], z [mm]\r\n# a comment\r\n\r\n"
                             "bead, +1.0, -2e0, +3.0E+00\r\n")
                             .particles();
  REQUIRE(particles.size() == 1);
  CHECK(particles[0].position.isApprox(Vec3(1e-3, -2e-3, 3e-3), 1e-15));
}

TEST_CASE("a column that stands twice is a fault, and so is an angular velocity without angle") {
  CHECK_THAT(SheetCase("species, x [mm], x [mm], y [mm], z [mm]\nbead, 1, 2, 0, 5\n").faults(),
             Contains("sheet.csv:1:1: x: the column stands twice"));
  CHECK_THAT(SheetCase("species, x [mm], y [mm], z [mm], wx [1/s]\n").faults(),
             Contains("wx: ") && Contains("is a frequency; wanted an angular velocity"));
}

TEST_CASE("a cell is a number from end to end") {
  for (const char* cell : {"1.0mm", "1,5", "0x10", "1 2", "+-1", "1e400", "nan", "inf", "1_0", ""})
    CHECK_THAT(SheetCase(header + "bead, " + cell + ", 0, 5\n").faults(),
               Contains("is no finite number") || Contains("has 5 cells"));
}

TEST_CASE("a heading's unit stands at its end and holds no number") {
  CHECK_THAT(SheetCase("species, x [1e-3 m], y [mm], z [mm]\n").faults(),
             Contains("'1e-3 m' is no unit: it holds a number"));
  CHECK_THAT(SheetCase("species, x [mm] left, y [mm], z [mm]\n").faults(), Contains("is unknown"));
}
