#include <catch2/catch.hpp>
#include <fstream>

#include "case/stl.hpp"
#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

// An ASCII STL of a unit cube, twelve triangles, outward normals.
std::string cube_stl() {
  const double p[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                            {2, 3, 7}, {2, 7, 6}, {1, 2, 6}, {1, 6, 5}, {0, 4, 7}, {0, 7, 3}};
  std::string text = "solid cube\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : face)
      text += "vertex " + std::to_string(p[k][0]) + " " + std::to_string(p[k][1]) + " " +
              std::to_string(p[k][2]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

std::string stl_case(const std::string& file) {
  return small_case + "[walls.cube]\nkind = \"stl\"\nmaterial = \"coated-wall\"\nfile = \"" + file +
         "\"\nscale = \"10 mm\"\n";
}

double area(const Facet& facet) {
  double sum = 0.0;
  for (const auto& t : facet.triangles) sum += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  return sum;
}

}  // namespace

TEST_CASE("an STL cube becomes six flat facets of one body") {
  const std::string file = temporary("pmr_test_cube.stl");
  std::ofstream(file) << cube_stl();
  const Case made = load(stl_case(file));
  REQUIRE(made.walls.bodies.size() == 2);
  REQUIRE(made.walls.surfaces.size() == 7);
  Vec3 sum = Vec3::Zero();
  for (const Surface& surface : made.walls.surfaces) {
    const auto* facet = std::get_if<Facet>(&surface.shape);
    if (facet == nullptr) continue;
    CHECK(facet->triangles.size() == 2);
    CHECK(area(*facet) == Approx(1e-4).epsilon(1e-6));
    sum += area(*facet) * facet->normal;
  }
  CHECK(sum.norm() < 1e-12);  // a closed surface (Gauss)
}

TEST_CASE("a bad STL triangle is named by its number, a broken file by its name") {
  const std::string file = temporary("pmr_test_bad.stl");
  std::string text = cube_stl();
  text = replaced(text, "vertex 1.000000 1.000000 0.000000", "vertex 0.000000 0.000000 0.000000");
  std::ofstream(file) << text;
  const auto faults = faults_of(stl_case(file));
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Contains("walls.cube.file: triangle 0 (0 is the first) has no area"));
  std::ofstream(file) << "this is no STL at all";
  CHECK_THAT(faults_of(stl_case(file)).at(0), Contains("walls.cube.file"));
}

TEST_CASE("an STL wall without a scale is a fault: the format has no unit") {
  const std::string file = temporary("pmr_test_cube.stl");
  std::ofstream(file) << cube_stl();
  CHECK_THAT(faults_of(replaced(stl_case(file), "scale = \"10 mm\"\n", "")).at(0),
             Contains("walls.cube.scale: is missing; wanted a length"));
}

TEST_CASE("a box has six inward faces that close") {
  const Case made = load(small_case +
                         "[walls.room]\nkind = \"box\"\nmaterial = \"coated-wall\"\n"
                         "low = \"-1 -2 -3 cm\"\nhigh = \"1 2 3 cm\"\n");
  REQUIRE(made.walls.surfaces.size() == 7);
  double total = 0.0;
  for (const Surface& surface : made.walls.surfaces) {
    const auto* facet = std::get_if<Facet>(&surface.shape);
    if (facet == nullptr) continue;
    total += area(*facet);
    CHECK(facet->normal.dot(-facet->triangles[0][0]) > 0);  // the middle is inside
    for (const auto& t : facet->triangles)
      CHECK((t[1] - t[0]).cross(t[2] - t[0]).normalized().dot(facet->normal) == Approx(1.0));
  }
  CHECK(total == Approx(2 * (0.02 * 0.04 + 0.04 * 0.06 + 0.02 * 0.06)).epsilon(1e-12));
}

TEST_CASE("every kind of wall, motion and boundary can be written") {
  const Case made = load(small_case + R"(
[walls.disc]
kind = "disc"
material = "coated-wall"
centre = "0 0 1 cm"
axis = [0, 0, -1]
radius = "5 cm"
inner_radius = "1 cm"
thermal = {kind = "fixed", temperature = "300 K"}
[walls.disc.motion]
kind = "fall"
release = "0.1 s"
stroke = "4 cm"
direction = [0, 0, -1]
acceleration = "9.81 m/s2"
[walls.tube]
kind = "cylinder"
material = "coated-wall"
base = "0 0 0 m"
axis = [0, 0, 1]
radius = "5 cm"
height = "10 cm"
facing = "in"
patches = [4, 2]
from = "1 s"
until = "2 s"
motion = {kind = "rotate", pivot = "0 0 0 m", axis = [0, 0, 1], rate = "60 rpm", begin = "0 s"}
[walls.tube.thermal]
kind = "lining"
layers = [{material = "fibre-board", thickness = "12 cm"}]
initial_temperature = "20 degC"
outside_film_coefficient = "8 W/m2/K"
outside_temperature = "20 degC"
[walls.hopper]
kind = "cone"
material = "coated-wall"
base = "0 0 0 m"
axis = [0, 0, 1]
base_radius = "1 cm"
top_radius = "5 cm"
height = "10 cm"
facing = "in"
motion = {kind = "oscillate", amplitude = "0 0 1 mm", frequency = "50 Hz", begin = "0 s"}
[walls.piston]
kind = "plane"
material = "coated-wall"
point = "0 0 -1 cm"
normal = [0, 0, 2]
motion = {kind = "translate", velocity = "0 0 1 mm/s", begin = "0 s", finish = "1 s"}
)");
  REQUIRE(made.walls.surfaces.size() == 5);
  for (const Surface& surface : made.walls.surfaces) {
    CHECK(made.walls.bodies.at(surface.body).name == surface.name);
    if (surface.name == "tube") {
      CHECK(surface.patches == std::array<std::uint32_t, 2>{4, 2});
      CHECK(is_present(surface, 1.5));
      CHECK_FALSE(is_present(surface, 2.0));
      CHECK(std::get<Lining>(surface.thermal).layers.at(0).thickness == Approx(0.12));
    }
    if (surface.name == "piston") CHECK(std::get<Plane>(surface.shape).normal == Vec3(0, 0, 1));
  }
}
