// The geometry held against the domain.
#include <catch2/catch.hpp>
#include <fstream>

#include "case/extents.hpp"
#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

// The small case, whose domain is 2 m wide, with one wall more; its faults.
std::string with_wall(const std::string& wall) {
  std::string all;
  const std::string text = small_case + "[walls.other]\nmaterial = \"coated-wall\"\n" + wall;
  for (const std::string& fault : faults_of(text)) all += fault;
  return all;
}

// A square of `side` in the plane z = 0, read in millimetres.
std::string square(double side) {
  const std::string file = temporary("pmr_test_square.stl"), s = std::to_string(side);
  std::ofstream(file) << "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex " << s
                      << " 0 0\nvertex " << s << " " << s << " 0\nendloop\nendfacet\nendsolid\n";
  return "kind = \"stl\"\nscale = \"1 mm\"\nfile = \"" + file + "\"\n";
}

std::string disc(const std::string& centre) {
  return "kind = \"disc\"\naxis = [0, 0, 1]\nradius = \"10 mm\"\ncentre = \"" + centre + "\"\n";
}

}  // namespace

TEST_CASE("a wall that no particle can meet is a fault that tells its extent") {
  CHECK(with_wall(disc("0 0 0.99 m")).empty());
  CHECK_THAT(with_wall(disc("0 0 1.01 m")),
             Contains("'other' (20 x 20 x 0 mm, from (-10, -10, 1010) to (10, 10, 1010) mm) lies "
                      "outside the domain"));
  CHECK(with_wall("kind = \"plane\"\nnormal = [0, 0, 1]\npoint = \"9 9 -1 m\"\n").empty());
  CHECK_THAT(with_wall("kind = \"plane\"\nnormal = [0, 0, 1]\npoint = \"0 0 -1.1 m\"\n"),
             Contains("'other' (infinite) lies outside the domain"));
}

TEST_CASE("a wall for radiation alone, or one that moves, may stand outside the domain") {
  CHECK(with_wall(disc("0 0 1.01 m") + "holds_particles = false\n").empty());
  CHECK(with_wall(disc("0 0 1.01 m") +
                  "motion = {kind = \"translate\", velocity = \"0 0 -1 m/s\", begin = \"0 s\"}\n")
            .empty());
}

TEST_CASE("an STL file in another unit than its scale is a fault") {
  CHECK(with_wall(square(400.0)).empty());  // a wall of 0.4 m
  CHECK_THAT(with_wall(square(0.4)),        // the same in metres, read as millimetres
             Contains("'other' reaches over 0.4 x 0.4 x 0 mm, from (0, 0, 0) to (0.4, 0.4, 0) mm, "
                      "the domain over 2000 mm: is its scale that of another unit?"));
  CHECK_THAT(with_wall(square(800e3)), Contains("is its scale that of another unit?"));
}
