// The rig's parts as surfaces.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "case/rig.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr int circle_corners = 64;  // of round holes in flat parts; a multiple of 8

// Radius of a regular polygon's corners so that it touches a circle from outside [m].
double circumscribed(double radius) { return radius / std::cos(pi / circle_corners); }

// Half spaces that bound the mixer above the ramp's foot. The spout's top is the last one.
std::vector<HalfSpace> mixer_half_spaces(const RigDimensions& s) {
  const double half = s.spout_width / 2;
  const Vec3 foot(0.0, 0.0, s.foot());
  const auto wall = [](double angle, const Vec3& outward) -> Vec3 {
    return std::cos(angle) * Vec3::UnitZ() - std::sin(angle) * outward;
  };
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  return {{"ramp", foot + half * x, wall(s.ramp_angle, x)},
          {"back", foot + s.back_wall * x, -x},
          {"far_foot", foot - half * x, wall(s.far_wall_angle, -x)},
          {"far", foot - s.far_wall * x, x},
          {"right_foot", foot - half * y, wall(s.side_wall_angle, -y)},
          {"right", foot - s.side_wall * y, y},
          {"left_foot", foot + half * y, wall(s.side_wall_angle, y)},
          {"left", foot + s.side_wall * y, -y},
          {"roof", Vec3(0.0, 0.0, s.roof_height), -z},
          {"spout", foot, z}};
}

// A triangle in a horizontal plane, turned so that it faces down.
void add_facing_down(Facet& facet, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double doubled_area = (b - a).cross(c - a).z();
  if (doubled_area == 0.0) return;
  if (doubled_area < 0.0)
    facet.triangles.push_back({a, b, c});
  else
    facet.triangles.push_back({a, c, b});
}

void add_rectangle(Facet& facet, double x0, double x1, double y0, double y1, double z) {
  if (x1 <= x0 || y1 <= y0) return;
  add_facing_down(facet, {x0, y0, z}, {x1, y0, z}, {x1, y1, z});
  add_facing_down(facet, {x0, y0, z}, {x1, y1, z}, {x0, y1, z});
}

// The flat ring between a square and the polygon round a circle, whichever is larger.
void add_square_to_circle(Facet& facet, const Vec3& centre, double half_side, double radius) {
  const double corner_radius = circumscribed(radius);
  const auto direction = [](int k) -> Vec3 {
    const double angle = 2.0 * pi * (k % circle_corners) / circle_corners;
    return {std::cos(angle), std::sin(angle), 0.0};
  };
  const auto on_square = [&](int k) -> Vec3 {
    const Vec3 d = direction(k);
    return centre + d * (half_side / d.cwiseAbs().maxCoeff());
  };
  const auto on_circle = [&](int k) -> Vec3 { return centre + corner_radius * direction(k); };
  for (int k = 0; k < circle_corners; ++k) {
    add_facing_down(facet, on_square(k), on_circle(k), on_circle(k + 1));
    add_facing_down(facet, on_square(k), on_circle(k + 1), on_square(k + 1));
  }
}

// The roof: a rectangle, cut along x into cells with a round hole and strips between them.
Facet roof_with_holes(const Polygon& roof, const RigDimensions& s, std::vector<Valve> valves) {
  std::sort(valves.begin(), valves.end(), [](const Valve& a, const Valve& b) { return a.x < b.x; });
  Vec3 low = roof.corners.front(), high = low;
  for (const Vec3& corner : roof.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  Facet facet{{}, -Vec3::UnitZ()};
  const double cell = roof_cell(s), z = s.roof_height;
  double x = low.x();
  for (const Valve& valve : valves) {
    const double left = valve.x - cell, right = valve.x + cell;
    add_rectangle(facet, x, left, low.y(), high.y(), z);
    add_rectangle(facet, left, right, low.y(), -cell, z);
    add_rectangle(facet, left, right, cell, high.y(), z);
    add_square_to_circle(facet, {valve.x, 0.0, z}, cell, s.tube_radius);
    x = right;
  }
  add_rectangle(facet, x, high.x(), low.y(), high.y(), z);
  return facet;
}

// Surfaces of revolution about a vertical axis.
Shape revolved(double x, double r0, double z0, double r1, double z1, double facing) {
  return Revolved{Vec3(x, 0.0, 0.0), Vec3::UnitZ(), r0, z0, r1, z1, facing};
}

class Builder {
 public:
  Builder(const Rig& rig, Walls& walls) : rig_(rig), s_(rig.size), walls_(walls) {}

  void build() {
    body("rig", Rest{});
    add_chamber();
    add_spout();
    for (const Polygon& face : mixer_faces(s_)) {
      if (face.name == "roof")
        above("mixer.roof", roof_with_holes(face, s_, rig_.valves), rig_.mixer);
      else
        above("mixer." + face.name, triangulated(face), rig_.mixer);
    }
    for (const Valve& valve : rig_.valves) add_tube(valve);
    for (const Valve& valve : rig_.valves) add_plug(valve);
  }

 private:
  void body(const std::string& name, const Motion& motion) {
    body_ = static_cast<std::uint32_t>(walls_.bodies.size());
    walls_.bodies.push_back({name, motion});
  }

  Surface& add(const std::string& name, Shape shape, const ThermalBoundary& thermal) {
    Surface surface;
    surface.name = name;
    surface.shape = std::move(shape);
    surface.body = body_;
    surface.material = rig_.material;
    surface.thermal = thermal;
    walls_.surfaces.push_back(std::move(surface));
    return walls_.surfaces.back();
  }

  // A part that leaves when the chamber is moved and closed.
  Surface& above(const std::string& name, Shape shape, const ThermalBoundary& thermal) {
    Surface& surface = add(name, std::move(shape), thermal);
    surface.until = rig_.closing;
    return surface;
  }

  void add_chamber() {
    const double r = s_.chamber_radius, top = s_.lid_height;
    add("chamber.side", revolved(0, r, 0, r, top, -1), rig_.chamber).patches = rig_.side_patches;
    add("chamber.floor", revolved(0, 0, 0, r, 0, -1), rig_.chamber).patches = rig_.floor_patches;
    if (rig_.closing == infinity) return;
    Surface& door = add("chamber.door", revolved(0, 0, top, r, top, +1), rig_.door);
    door.patches = rig_.door_patches;
    door.holds_particles = false;
    door.from = rig_.closing;
  }

  void add_spout() {
    Facet lid{{}, -Vec3::UnitZ()};
    add_square_to_circle(lid, {0.0, 0.0, s_.lid_height}, s_.spout_width / 2, s_.chamber_radius);
    above("chamber.lid", lid, rig_.mixer);
    const double half = s_.spout_width / 2;
    const Vec3 low(-half, -half, s_.lid_height), high(half, half, s_.foot());
    for (const Polygon& face : faces_of(box_half_spaces(low, high)))
      if (face.name[0] != 'z') above("spout." + face.name, triangulated(face), rig_.mixer);
  }

  void add_tube(const Valve& valve) {
    const double r = s_.tube_radius, z = s_.roof_height, top = s_.tube_top();
    above("tube." + valve.name, revolved(valve.x, r, z, r, top, -1), valve.thermal);
    // lids for light alone: the slivers between the round tube and the roof's hole, and the top
    above("tube." + valve.name + ".seal", revolved(valve.x, r, z, circumscribed(r), z, +1),
          rig_.mixer)
        .holds_particles = false;
    above("tube." + valve.name + ".cap", revolved(valve.x, s_.rod_radius, top, r, top, +1),
          valve.thermal)
        .holds_particles = false;
  }

  // Rod, cone, skirt and bottom, a profile from the top down, so that facing -1 is outwards.
  void add_plug(const Valve& valve) {
    body("valve." + valve.name,
         Fall{valve.release, s_.plug_stroke, -Vec3::UnitZ(), s_.plug_acceleration});
    const double rim = s_.rim_radius(), z = s_.roof_height, rod = s_.rod_radius;
    const double cone = z + s_.plug_cone_height, bottom = z - s_.plug_skirt;
    const double rod_top = s_.tube_top() + s_.plug_stroke;
    const std::string name = "valve." + valve.name;
    above(name + ".rod", revolved(valve.x, rod, rod_top, rod, cone, -1), valve.thermal);
    above(name + ".cone", revolved(valve.x, rod, cone, rim, z, -1), valve.thermal);
    above(name + ".skirt", revolved(valve.x, rim, z, rim, bottom, -1), valve.thermal);
    above(name + ".bottom", revolved(valve.x, rim, bottom, 0.0, bottom, -1), valve.thermal);
  }

  const Rig& rig_;
  const RigDimensions& s_;
  Walls& walls_;
  std::uint32_t body_ = 0;
};

}  // namespace

double roof_cell(const RigDimensions& size) { return 1.02 * circumscribed(size.tube_radius); }

std::vector<Polygon> mixer_faces(const RigDimensions& size) {
  std::vector<Polygon> faces = faces_of(mixer_half_spaces(size));
  std::erase_if(faces, [](const Polygon& face) { return face.name == "spout"; });
  return faces;
}

void build_rig(const Rig& rig, Walls& walls) { Builder(rig, walls).build(); }

}  // namespace pmr::casefile
