// Walls that show their backs to the particles are told; what is right is not.
#include <catch2/catch.hpp>
#include <filesystem>

#include "case/backs.hpp"
#include "case/polytope.hpp"
#include "helpers.hpp"

using namespace pmr;
using casefile::warn_of_backs;
using Catch::Contains;

namespace {

const Vec3 up = Vec3::UnitZ();

Surface wall(const Shape& shape, std::uint32_t body) {
  Surface surface;
  surface.shape = shape;
  surface.body = body;
  return surface;
}

// One body a shape; particles begin in a cylinder of 10 to 30 mm height, 10 mm wide.
std::vector<std::string> backs_told(const std::vector<Shape>& shapes,
                                    const Motion& motion = Rest{}) {
  Case c{};
  c.species.resize(1);
  c.species[0].region = CylinderRegion{Vec3(0, 0, 0.01), 0.01, 0.0, 0.02};
  for (const Shape& shape : shapes) {
    const auto body = static_cast<std::uint32_t>(c.walls.bodies.size());
    c.walls.bodies.push_back({"w" + std::to_string(body), motion});
    c.walls.surfaces.push_back(wall(shape, body));
  }
  warn_of_backs(0, c);
  return c.warnings;
}

Shape cylinder(double radius, double facing) {
  return Revolved{Vec3::Zero(), up, radius, 0.0, radius, 0.05, facing};
}
Shape cone(double facing) { return Revolved{Vec3::Zero(), up, 0.002, -0.02, 0.02, 0.03, facing}; }
Shape disc_of(double z, double facing) {
  return Revolved{Vec3(0, 0, z), up, 0.0, 0.0, 0.02, 0.0, facing};
}
Shape sheet(bool faces_up) {
  const Vec3 a(-0.02, -0.02, 0), b(0.02, -0.02, 0), c(0.02, 0.02, 0);
  if (faces_up) return Facet{{{a, b, c}}, up};
  return Facet{{{a, c, b}}, -up};
}

}  // namespace

TEST_CASE(
    "a wall of any shape whose back alone is seen is told by its name, turned round it is not") {
  const std::vector<std::pair<Shape, Shape>> right_and_wrong{
      {Plane{Vec3::Zero(), up}, Plane{Vec3::Zero(), -up}},
      {cylinder(0.02, -1.0), cylinder(0.02, 1.0)},
      {cone(-1.0), cone(1.0)},
      {disc_of(0.0, -1.0), disc_of(0.0, 1.0)},
      {disc_of(0.04, 1.0), disc_of(0.04, -1.0)},
      {sheet(true), sheet(false)}};
  for (const auto& [right, wrong] : right_and_wrong) {
    CAPTURE(right.index());
    CHECK(backs_told({right}).empty());
    const auto warnings = backs_told({wrong});
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("wall w0: ") && Contains("nothing of it but its back"));
  }
}

TEST_CASE("what is seen from both sides, hidden, far off or not there yet is not told") {
  CHECK(backs_told({cylinder(0.001, 1.0)}).empty());  // a rod in the bed
  CHECK(
      backs_told({cylinder(0.02, -1.0), cylinder(0.03, 1.0)}).empty());  // the outside of a vessel
  CHECK(backs_told({Plane{Vec3(0, 0, 0.02), up}}).empty());              // amid the particles
  Case later{};
  later.particles.push_back({0, Vec3(0, 0, 0.01), Vec3::Zero(), Vec3::Zero(), {}, {}});
  later.walls.bodies.push_back({"lid", Rest{}});
  later.walls.surfaces.push_back(wall(disc_of(0.04, -1.0), 0));
  later.walls.surfaces[0].from = 1.0;
  warn_of_backs(0, later);
  CHECK(later.warnings.empty());
  later.walls.surfaces[0].from = -1.0;
  warn_of_backs(0, later);
  CHECK(later.warnings.size() == 1);
}

TEST_CASE("a moved wall is looked at where it stands at the start") {
  // Half a turn a second about x since -1.5 s: from z = 0 under the particles, upside down now.
  const Rotate turned{Vec3::Zero(), Vec3::UnitX(), 3.14159265358979, -1.0, 10.0};
  CHECK(backs_told({Plane{Vec3::Zero(), up}}, turned).size() == 1);
  CHECK(backs_told({Plane{Vec3::Zero(), -up}}, turned).empty());
}

TEST_CASE("no wall of a shipped case shows its back to its particles alone") {
  for (const auto& entry : std::filesystem::directory_iterator(PMR_SOURCE_DIR "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path());
    Case made = casefile::load_case(entry.path());
    CHECK(made.warnings.empty());
    warn_of_backs(0, made);  // the rig's too, which are not looked at
    CHECK(made.warnings.empty());
  }
}
