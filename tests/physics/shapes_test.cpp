// Closest points and motions against brute force.
#include "physics/shapes.hpp"

#include <catch2/catch.hpp>

#include "physics/motion.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::physics;

namespace {

Vec3 random_point(Random& random, double reach) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return reach * (2.0 * Vec3(x, y, z) - Vec3::Ones());
}

// Smallest distance to points sampled over the surface of revolution.
double sampled_distance(const Revolved& s, const Vec3& x) {
  const Vec3 u = s.axis.unitOrthogonal(), v = s.axis.cross(u);
  constexpr int along = 200, round = 720;
  double best = 1e9;
  for (int a = 0; a <= along; ++a) {
    const double t = static_cast<double>(a) / along;
    const double r = s.r0 + t * (s.r1 - s.r0), z = s.z0 + t * (s.z1 - s.z0);
    for (int k = 0; k < round; ++k) {
      const double phi = 2.0 * pi * k / round;
      const Vec3 p = s.origin + z * s.axis + r * (std::cos(phi) * u + std::sin(phi) * v);
      best = std::min(best, (p - x).norm());
    }
  }
  return best;
}

double sampled_distance(const Facet& f, const Vec3& x) {
  double best = 1e9;
  for (const auto& t : f.triangles)
    for (int a = 0; a <= 200; ++a)
      for (int b = 0; a + b <= 200; ++b)
        best = std::min(best,
                        (t[0] + a / 200.0 * (t[1] - t[0]) + b / 200.0 * (t[2] - t[0]) - x).norm());
  return best;
}

}  // namespace

TEST_CASE("Closest points of cylinder, cone, disc and ring agree with brute force") {
  const Vec3 axis = Vec3(0.3, -0.5, 0.8).normalized(), origin(0.1, 0.2, -0.1);
  Random random(3, Purpose::test, 1);
  for (const Revolved& s : {Revolved{origin, axis, 0.5, -0.2, 0.5, 0.4, -1},  // cylinder
                            Revolved{origin, axis, 0.0, 0.3, 0.6, -0.1, 1},   // cone
                            Revolved{origin, axis, 0.0, 0.1, 0.5, 0.1, -1},   // disc
                            Revolved{origin, axis, 0.3, 0.1, 0.6, 0.1, -1}})  // ring
    for (int k = 0; k < 15; ++k) {
      const Vec3 x = random_point(random, 1.0);
      const Vec3 q = closest_point(s, x);
      // Samples are at most 0.6 pi/720 + 0.72/400 apart from the true point.
      CHECK((q - x).norm() <= sampled_distance(s, x) + 1e-12);
      CHECK((q - x).norm() >= sampled_distance(s, x) - 4.5e-3);
      CHECK((closest_point(s, q) - q).norm() < 1e-12);
      const Box box = bounding_box(s);
      CHECK((q.array() >= box.low.array() - 1e-12).all());
      CHECK((q.array() <= box.high.array() + 1e-12).all());
    }
}

TEST_CASE("Closest points of a facet agree with brute force") {
  const Vec3 a(0.1, 0, 0.2), b(0.9, 0.1, 0.3), c(0.8, 0.7, -0.1), d(0.0, 0.6, -0.2);
  const Vec3 n = (b - a).cross(c - a).normalized();
  const Vec3 flat = d - (d - a).dot(n) * n;
  const Facet facet{{{a, b, c}, {a, c, flat}}, n};
  Random random(3, Purpose::test, 2);
  for (int k = 0; k < 60; ++k) {
    const Vec3 x = random_point(random, 1.2);
    const Vec3 q = closest_point(facet, x);
    CHECK((q - x).norm() <= sampled_distance(facet, x) + 1e-12);
    CHECK((q - x).norm() >= sampled_distance(facet, x) - 5e-3);  // step of the samples
    CHECK(std::abs((q - a).dot(n)) < 1e-12);
    if (is_surely_beyond(facet, x, 0.4)) CHECK((q - x).norm() > 0.4);
  }
}

TEST_CASE("The point on a revolved shape nearest to its axis is on the shape") {
  const Revolved cylinder{Vec3::Zero(), Vec3::UnitZ(), 0.5, 0.0, 0.5, 1.0, -1};
  CHECK((closest_point(cylinder, Vec3(0, 0, 0.3)) - Vec3(0, 0, 0.3)).norm() == Approx(0.5));
}

TEST_CASE("Poses move as their velocities say, and no farther than their bounds") {
  const Vec3 axis = Vec3(0.2, 0.3, 0.9).normalized();
  const Box domain{Vec3::Constant(-1.0), Vec3::Constant(1.0)};
  const Motion motions[] = {
      Rest{}, Fall{0.1, 0.05, Vec3(0, 0, -1), 9.81}, Translate{Vec3(0.1, 0.2, 0), 0.1, 0.5},
      Oscillate{Vec3(0, 0.01, 0.002), 5.0, 0.1}, Rotate{Vec3(0.1, 0, 0), axis, 2.0, 0.1, 0.6}};
  const Vec3 body_point(0.3, -0.2, 0.4);
  constexpr double h = 1e-6;  // [s]
  for (const Motion& motion : motions)
    for (const double t : {0.0, 0.15, 0.19, 0.3, 0.7}) {
      const Vec3 before = pose(motion, t - h).to_world(body_point);
      const Vec3 after = pose(motion, t + h).to_world(body_point);
      const Pose now = pose(motion, t);
      const Vec3 x = now.to_world(body_point);
      CHECK((now.to_body(x) - body_point).norm() < 1e-14);
      // Central difference: error h^2/6 of the third derivative, and rounding 1e-16/h.
      CHECK((now.velocity_at(x) - (after - before) / (2.0 * h)).norm() < 1e-8);
      const Vec3 later = pose(motion, t + 0.05).to_world(body_point);
      CHECK((later - x).norm() <= displacement_bound(motion, t, t + 0.05, domain) + 1e-15);
    }
}

TEST_CASE("A falling body stops dead after its stroke") {
  const Motion fall = Fall{0.0, 0.045, Vec3(0, 0, -1), 9.81};
  const double end = std::sqrt(2.0 * 0.045 / 9.81);  // 0.0958 s, at 0.94 m/s
  CHECK(pose(fall, end - 1e-9).velocity[2] == Approx(-9.81 * end));
  CHECK(pose(fall, end + 1e-9).velocity[2] == 0.0);
  CHECK(pose(fall, 1.0).translation[2] == Approx(-0.045));
}
