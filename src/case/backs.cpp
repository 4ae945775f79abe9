#include "case/backs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/half_line.hpp"
#include "physics/motion.hpp"
#include "physics/pouring.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr double worth_telling = 0.05;  // [1] of the half lines from one place

// Where a half line meets a surface first.
struct Meeting {
  double way = nowhere;  // [m]
  bool at_back = false;
};

Meeting nearer(const Meeting& a, const Meeting& b) { return b.way < a.way ? b : a; }

Meeting meet_flat(const HalfLine& line, double way, const Vec3& normal) {
  return way > 0.0 ? Meeting{way, line.direction.dot(normal) > 0.0} : Meeting{};
}

Meeting meet(const HalfLine& line, const Plane& plane) {
  return meet_flat(line, way_to_plane(line, plane.point, plane.normal), plane.normal);
}

Meeting meet(const HalfLine& line, const Facet& facet) {
  Meeting first;
  for (const auto& triangle : facet.triangles)
    first = nearer(first, meet_flat(line, way_to_triangle(line, triangle), facet.normal));
  return first;
}

// |radial(way)| = r(z(way)), squared: a way^2 + 2 b way + c = 0; r is linear in z.
Meeting meet(const HalfLine& line, const Revolved& shape) {
  const Vec3 start = line.start - shape.origin;
  const double z = start.dot(shape.axis), dz = line.direction.dot(shape.axis);
  const double rise = shape.z1 - shape.z0;
  const Vec3 x = start - z * shape.axis, dx = line.direction - dz * shape.axis;
  const auto meet_at = [&](double way) -> Meeting {
    const Vec3 radial = x + way * dx;
    const double r = radial.norm(), height = z + way * dz;
    const double dr = shape.r1 - shape.r0;
    const double part =  // [1] of the segment
        ((r - shape.r0) * dr + (height - shape.z0) * rise) / (dr * dr + rise * rise);
    if (!(way > 0.0) || part < 0.0 || part > 1.0) return {};
    const Vec3 outwards = r > 0.0 ? Vec3(radial / r) : Vec3::Zero();
    return {way, line.direction.dot(shape.facing * (rise * outwards - dr * shape.axis)) > 0.0};
  };
  if (rise == 0.0) return dz == 0.0 ? Meeting{} : meet_at((shape.z0 - z) / dz);
  const double slope = (shape.r1 - shape.r0) / rise;
  const double r = shape.r0 + slope * (z - shape.z0), dr = slope * dz;
  const double a = dx.squaredNorm() - dr * dr, b = x.dot(dx) - r * dr, c = x.squaredNorm() - r * r;
  if (a == 0.0) return b == 0.0 ? Meeting{} : meet_at(-0.5 * c / b);
  const double root = b * b - a * c;
  if (root < 0.0) return {};
  const auto on_cone = [&](double way) {  // not on its mirror image beyond the tip
    return r + way * dr >= 0.0 ? meet_at(way) : Meeting{};
  };
  return nearer(on_cone((-b - std::sqrt(root)) / a), on_cone((-b + std::sqrt(root)) / a));
}

// Equally spread directions (spiral of Fibonacci).
std::vector<Vec3> directions(std::size_t count) {
  const double golden = pi * (3.0 - std::sqrt(5.0));  // [rad]
  std::vector<Vec3> all;
  for (std::size_t k = 0; k < count; ++k) {
    const double z = 1.0 - 2.0 * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double r = std::sqrt(1.0 - z * z), angle = golden * static_cast<double>(k);
    all.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return all;
}

// Points spread over a region, by additive recurrence with the powers of the root of x^4 = x + 1
// (M. Roberts' R3).
Vec3 part_of(std::size_t k) {  // [1] three numbers in [0, 1)
  const Vec3 at = static_cast<double>(k + 1) * Vec3(0.8191725134, 0.6710436067, 0.5497004779);
  return at - at.array().floor().matrix();
}
Vec3 point_in(const BoxRegion& r, std::size_t k) {
  return r.low + part_of(k).cwiseProduct(r.high - r.low);
}
Vec3 point_in(const CylinderRegion& r, std::size_t k) {
  const Vec3 part = part_of(k);
  const double radius = r.inner_radius + part[0] * (r.radius - r.inner_radius);
  const double angle = 2.0 * pi * part[1];
  return r.base + Vec3(radius * std::cos(angle), radius * std::sin(angle), part[2] * r.height);
}

std::vector<Vec3> beginnings(const Case& c) {
  constexpr std::size_t of_particles = 16, of_region = 8;
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < c.particles.size(); k += 1 + c.particles.size() / of_particles)
    places.push_back(c.particles[k].position);
  const auto add = [&](const Region& region) {
    for (std::size_t k = 0; k < of_region; ++k)
      places.push_back(std::visit([&](const auto& r) { return point_in(r, k); }, region));
  };
  for (const Species& species : c.species) {
    if (species.region) add(*species.region);
    if (species.pour) add(species.pour->region);
  }
  return places;
}

// How much is looked at: some 1e7 triangles in all, whatever the mesh.
std::size_t lines_from(std::size_t places, const Walls& walls) {
  std::size_t pieces = 1;
  for (const Surface& surface : walls.surfaces) {
    const auto* facet = std::get_if<Facet>(&surface.shape);
    pieces += facet == nullptr ? 1 : facet->triangles.size();
  }
  return std::clamp<std::size_t>(10'000'000 / (pieces * places), 40, 400);
}

// What the half lines of one place meet, by body.
struct Sight {
  std::vector<std::size_t> faces, backs;
};

Sight look_round(const Walls& walls, const std::vector<physics::Pose>& poses, double t,
                 const Vec3& place, std::size_t lines) {
  Sight sight{std::vector<std::size_t>(poses.size(), 0), std::vector<std::size_t>(poses.size(), 0)};
  for (const Vec3& direction : directions(lines)) {
    Meeting first;
    std::size_t body = 0;
    for (const Surface& surface : walls.surfaces) {
      if (!is_present(surface, t)) continue;
      const physics::Pose& pose = poses[surface.body];
      const Vec3 start = pose.to_body(place);
      const HalfLine line{start, pose.to_body(place + direction) - start};
      const Meeting one = std::visit([&](const auto& s) { return meet(line, s); }, surface.shape);
      if (one.way < first.way) {
        first = one;
        body = surface.body;
      }
    }
    if (first.way < nowhere) ++(first.at_back ? sight.backs : sight.faces)[body];
  }
  return sight;
}

}  // namespace

void warn_of_backs(std::size_t first, Case& c) {
  const std::vector<Vec3> places = beginnings(c);
  if (places.empty() || first >= c.walls.bodies.size()) return;
  const double begin = physics::begin_of_run(c);
  std::vector<physics::Pose> poses;
  for (const Body& body : c.walls.bodies) poses.push_back(physics::pose(body.motion, begin));
  const std::size_t lines = lines_from(places.size(), c.walls);
  std::vector<std::size_t> faces(poses.size(), 0), most_backs(poses.size(), 0);
  for (const Vec3& place : places) {
    const Sight sight = look_round(c.walls, poses, begin, place, lines);
    for (std::size_t b = 0; b < poses.size(); ++b) {
      faces[b] += sight.faces[b];
      most_backs[b] = std::max(most_backs[b], sight.backs[b]);
    }
  }
  for (std::size_t b = first; b < poses.size(); ++b)
    if (faces[b] == 0 &&
        static_cast<double>(most_backs[b]) > worth_telling * static_cast<double>(lines))
      c.warnings.push_back(fmt::format(
          "wall {}: where the particles begin they see nothing of it but its back, which takes "
          "heat "
          "by radiation and gives none: see its facing, axis, normal or order of corners",
          c.walls.bodies[b].name));
}

}  // namespace pmr::casefile
