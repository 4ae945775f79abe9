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

double mesh_area(const Facet& facet) {
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
    CHECK(mesh_area(*facet) == Approx(1e-4).epsilon(1e-6));
    sum += mesh_area(*facet) * facet->normal;
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
    total += mesh_area(*facet);
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

TEST_CASE("a rectangle is one facet that faces along x across") {
  const Case made = load(small_case +
                         "[walls.plate]\nkind = \"rectangle\"\nmaterial = \"coated-wall\"\n"
                         "corner = \"10 0 5 mm\"\nalong = \"20 0 0 mm\"\nacross = \"0 30 0 mm\"\n");
  const auto& facet = std::get<Facet>(made.walls.surfaces.back().shape);
  CHECK(mesh_area(facet) == Approx(600e-6));
  CHECK((facet.normal - Vec3::UnitZ()).norm() < 1e-12);
  CHECK(faults_of(small_case + "[walls.plate]\nkind = \"rectangle\"\nmaterial = \"coated-wall\"\n"
                               "corner = \"10 0 5 mm\"\nalong = \"20 0 0 mm\"\n"
                               "across = \"20 30 0 mm\"\n")
            .size() == 1);
}

namespace {
const std::string rough_plate =
    "[walls.plate]\nkind = \"disc\"\nmaterial = \"coated-wall\"\ncentre = \"0 0 -10 mm\"\n"
    "axis = [0, 0, 1]\nradius = \"20 mm\"\n";
const std::string layer =
    "[walls.plate.grains]\nmaterial = \"Al2O3\"\ndiameter = \"2 mm\"\narea_fraction = 0.7\n"
    "height_deviation = 0.05\n";
}  // namespace

// 0.7 * (20 mm / 1 mm)^2 = 280 grains.
TEST_CASE("a layer of grains stands on its wall's face and belongs to its body") {
  const Case made = load(small_case + rough_plate + layer);
  REQUIRE(made.walls.grains.size() == 280);
  double lowest = 1.0, highest = -1.0;
  for (const Grain& grain : made.walls.grains) {
    CHECK(made.walls.bodies[grain.body].name == "plate");
    CHECK(made.materials.list[grain.material].name == "Al2O3");
    CHECK(grain.radius == Approx(1e-3));
    CHECK(grain.centre.head<2>().norm() < 19.001e-3);
    lowest = std::min(lowest, grain.centre.z());
    highest = std::max(highest, grain.centre.z());
  }
  CHECK(lowest == Approx(-10e-3 + 1e-3 - 0.1e-3).margin(0.01e-3));
  CHECK(highest == Approx(-10e-3 + 1e-3 + 0.1e-3).margin(0.01e-3));
  CHECK(load(made.text).walls.grains.front().centre == made.walls.grains.front().centre);
}

TEST_CASE("grains come from a file too, and what cannot be is told") {
  const std::string file = temporary("pmr_test_grains.csv");
  std::ofstream(file) << "x [mm], y [mm], z [mm]\n1, 2, 3\n-4, 5, -6\n";
  const std::string sheet =
      "[walls.floor.grains]\nmaterial = \"Al2O3\"\ndiameter = \"2 mm\"\ncsv = \"" + file + "\"\n";
  const Case made = load(small_case + sheet);
  REQUIRE(made.walls.grains.size() == 2);
  CHECK((made.walls.grains[1].centre - Vec3(-4e-3, 5e-3, -6e-3)).norm() < 1e-12);
  const auto fault_of = [](const std::string& more) {
    const auto faults = faults_of(small_case + more);
    return faults.size() == 1 ? faults.front() : std::to_string(faults.size()) + " faults";
  };
  CHECK_THAT(fault_of(rough_plate + replaced(layer, "0.7", "0.9")), Contains("area_fraction"));
  CHECK_THAT(fault_of(replaced(rough_plate, "radius", "until = \"1 s\"\nradius") + layer),
             Contains("from and until"));
  CHECK_THAT(fault_of("[walls.floor.grains]\nmaterial = \"Al2O3\"\ndiameter = \"2 mm\"\n"
                      "area_fraction = 0.7\nheight_deviation = 0.0\n"),
             Contains("disc or rectangle"));
  CHECK_THAT(fault_of("[walls.bar]\nkind = \"rectangle\"\nmaterial = \"Al2O3\"\n"
                      "corner = \"0 0 -8 mm\"\nalong = \"20 0 0 mm\"\nacross = \"0 3.1 0 mm\"\n"
                      "[walls.bar.grains]\nmaterial = \"Al2O3\"\ndiameter = \"2.99 mm\"\n"
                      "area_fraction = 0.78\nheight_deviation = 0.0\n"),
             Contains("do not fit"));
}

TEST_CASE("a wall that moves with another has its motion") {
  const std::string led = rough_plate + "moves_with = \"shaker\"\n";
  const std::string shaker =
      "[walls.shaker]\nkind = \"disc\"\nmaterial = \"coated-wall\"\ncentre = \"0 0 -20 mm\"\n"
      "axis = [0, 0, 1]\nradius = \"20 mm\"\n"
      "motion = {kind = \"oscillate\", amplitude = \"1 0 0 mm\", frequency = \"5 Hz\", begin = "
      "\"0 s\"}\n";
  const Case made = load(small_case + led + shaker);
  for (const Body& body : made.walls.bodies)
    CHECK(std::holds_alternative<Oscillate>(body.motion) == (body.name != "floor"));
  const auto unknown =
      faults_of(small_case + led + replaced(shaker, "walls.shaker", "walls.shakr"));
  REQUIRE(unknown.size() == 1);
  CHECK_THAT(unknown.front(), Contains("did you mean 'shakr'"));
}

TEST_CASE("openings that catch, heaps and forces on walls are read, and wrong ones told") {
  const Case made = load(small_case +
                         "[catch.out]\ncorner = \"0 0 -10 mm\"\nalong = \"10 0 0 mm\"\n"
                         "across = \"0 10 0 mm\"\nthreshold = \"2 g\"\nends_motion = true\n"
                         "[heap]\ncentre = \"0 0 0 mm\"\nradius = \"50 mm\"\nbin = \"3 mm\"\n"
                         "[wall_force.floor]\nabout = \"0 0 1 mm\"\n");
  REQUIRE(made.catches.size() == 1);
  CHECK(*made.catches[0].threshold == Approx(2e-3));
  CHECK(made.heap->sectors == 24);
  CHECK(made.walls.bodies[made.wall_forces.at(0).body].name == "floor");
  const auto faults = faults_of(small_case +
                                "[catch.out]\ncorner = \"0 0 -10 mm\"\nalong = \"10 0 0 mm\"\n"
                                "across = \"0 10 0 mm\"\nends_motion = true\n"
                                "[wall_force.flor]\n");
  REQUIRE(faults.size() == 2);
  CHECK_THAT(faults[0], Contains("threshold"));
  CHECK_THAT(faults[1], Contains("did you mean 'floor'"));
}
