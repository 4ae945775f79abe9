// Facing sides of facetted walls against the closed forms of a cube.
#include <catch2/catch.hpp>

#include "case/facing.hpp"

using namespace pmr;
using namespace pmr::casefile;

namespace {

// Twelve triangles of the cube |x|, |y|, |z| < half [m] that face outwards.
std::vector<Triangle> cube(double half) {
  const Vec3 p[8] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                     {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  const int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                            {2, 3, 7}, {2, 7, 6}, {1, 2, 6}, {1, 6, 5}, {0, 4, 7}, {0, 7, 3}};
  std::vector<Triangle> triangles;
  for (const auto& f : faces) triangles.push_back({half * p[f[0]], half * p[f[1]], half * p[f[2]]});
  return triangles;
}

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

std::vector<Triangle> inwards(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) turn(triangle);
  return triangles;
}

// Volume that the facing sides look out of [m3] (Gauss): positive if they look outwards.
double volume(const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles) sum += t[0].dot(t[1].cross(t[2])) / 6.0;
  return sum;
}

Case case_of(const std::vector<Triangle>& triangles, const std::vector<Vec3>& particles) {
  Case c{};
  c.walls.bodies.push_back({"box", Rest{}});
  for (const Facet& facet : flat_facets(triangles)) {
    Surface surface;
    surface.shape = facet;
    c.walls.surfaces.push_back(surface);
  }
  for (const Vec3& x : particles) c.particles.push_back({0, x, Vec3::Zero(), Vec3::Zero(), {}, {}});
  return c;
}

// The volume after turning, each facet's normal being that of its triangles.
double faced(Case& c) {
  face_particles(0, c);
  std::vector<Triangle> triangles;
  for (const Surface& surface : c.walls.surfaces)
    for (const Triangle& t : std::get<Facet>(surface.shape).triangles) {
      const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
      CHECK(n.dot(std::get<Facet>(surface.shape).normal) == Approx(1.0));
      triangles.push_back(t);
    }
  return volume(triangles);
}

const Vec3 within(0.1, 0.2, -0.3), outside(3.0, 0.2, 0.1);

}  // namespace

TEST_CASE("triangles that face another side than their neighbours are turned, and counted") {
  std::vector<Triangle> mixed = cube(1.0);
  for (const std::size_t k : {1U, 4U, 6U, 11U}) turn(mixed[k]);
  const Orientation made = agree(mixed);
  CHECK(made.turned == 4);
  CHECK(made.is_closed);
  CHECK_FALSE(made.is_contradictory);
  CHECK(volume(mixed) == Approx(8.0));
  CHECK(agree(mixed).turned == 0);
  mixed.pop_back();
  CHECK_FALSE(agree(mixed).is_closed);
}

TEST_CASE("a closed shell faces the particles in it, an obstacle those round it") {
  for (const auto& triangles : {cube(1.0), inwards(cube(1.0))}) {
    Case shell = case_of(triangles, {within, 0.5 * within});
    CHECK(faced(shell) == Approx(-8.0));
    Case obstacle = case_of(triangles, {outside});
    CHECK(faced(obstacle) == Approx(8.0));
    CHECK(shell.warnings.size() + obstacle.warnings.size() == 1);  // one of them was right
  }
}

TEST_CASE("a thick-walled vessel faces out of its walls, whatever the file says") {
  for (const bool flips_inner : {false, true})
    for (const bool flips_outer : {false, true}) {
      std::vector<Triangle> inner = inwards(cube(1.0)), outer = cube(1.2);
      if (flips_inner) inner = inwards(inner);
      if (flips_outer) outer = inwards(outer);
      inner.insert(inner.end(), outer.begin(), outer.end());
      Case vessel = case_of(inner, {within});
      CHECK(faced(vessel) == Approx(8.0 * (1.2 * 1.2 * 1.2 - 1.0)));
      CHECK(vessel.warnings.empty() == (!flips_inner && !flips_outer));
    }
}

TEST_CASE("open bodies and those with particles on both sides stay as they are") {
  Case both = case_of(cube(1.0), {within, outside});
  CHECK(faced(both) == Approx(8.0));
  std::vector<Triangle> cup = cube(1.0);
  cup.erase(cup.begin() + 2, cup.begin() + 4);  // without its top
  const double before = volume(cup);
  Case open = case_of(cup, {within});
  CHECK(faced(open) == Approx(before));
  CHECK(both.warnings.size() + open.warnings.size() == 0);
}
