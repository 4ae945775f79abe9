// Heat from particles to walls: one link per surface, by how much, and how far it reaches.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/gas.hpp"
#include "coupling/heat_links.hpp"
#include "physics/gap.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;

namespace {

constexpr double radius = 3e-3;      // [m]
constexpr double in_air = 101325.0;  // [Pa]

Material solid(double conductivity, double young) {
  Material m{};
  m.young_soft = 5e6;
  m.young_real = young;
  m.poisson_soft = m.poisson_real = 0.3;
  m.conductivity = TabulatedConductivity{Table{{300.0}, {conductivity}}};
  m.accommodation = 0.9;
  return m;
}

// Beads and granules of 6 mm, walls of steel at 400 K, air of 300 K at 1 atm.
Case bare_case() {
  Case c{};
  c.materials.list = {solid(1.0, 70e9), solid(3.0, 350e9), solid(20.0, 200e9)};
  c.species.resize(2);
  c.species[1].material = 1;
  c.domain_low = Vec3::Constant(-0.1);
  c.domain_high = Vec3::Constant(0.1);
  c.models.conduction = ConductionModel{true, true, 0.5, 0.6};
  c.chamber = ChamberCase{};
  c.chamber->pressure = in_air;
  c.chamber->oxygen_fraction = 0.21;
  c.chamber->gas_temperature = 300.0;
  return c;
}

void add_wall(Case& c, const Shape& shape) {
  Surface surface;
  surface.shape = shape;
  surface.body = static_cast<std::uint32_t>(c.walls.bodies.size());
  surface.material = 2;
  surface.thermal = FixedTemperature{400.0};
  c.walls.bodies.push_back({"body", Rest{}});
  c.walls.surfaces.push_back(surface);
}

State beads_at(const std::vector<Vec3>& places, SpeciesIndex species = 0) {
  State state;
  Particles& p = state.particles;
  for_each_field(p, [&](const char*, const char*, auto& field) { field.resize(places.size()); });
  for (std::size_t i = 0; i < places.size(); ++i) {
    p.id[i] = static_cast<ParticleId>(i);
    p.species[i] = species;
    p.radius[i] = radius;
    p.position[i] = places[i];
    p.temperature[i] = 300.0;
  }
  state.opening.particles = places.size();
  return state;
}

// Sums over the links of one particle with walls [W/K], and how many there are.
struct Sum {
  double contact = 0.0, gap = 0.0;
  std::size_t links = 0;
};

Sum to_walls(const Case& c, const State& state, std::uint32_t particle = 0) {
  const auto nodes = coupling::number_nodes(c, state.particles.size());
  Sum sum;
  for (const auto& link : coupling::conduct(c, nodes, state)) {
    if (link.a != nodes.particle(particle) || link.b < nodes.solids()) continue;
    sum.contact += link.contact;
    sum.gap += link.gap;
    ++sum.links;
  }
  return sum;
}

const Plane floor_plane{Vec3::Zero(), Vec3::UnitZ()};

Facet rectangle(const Vec3& corner, const Vec3& a, const Vec3& b) {
  return {{{corner, corner + a, corner + a + b}, {corner, corner + a + b, corner + b}},
          a.cross(b).normalized()};
}

// A trough of radius r [m] about the y axis, its lowest line at z = 0, of strips `width` [m] wide,
// whose edges lie on the circle.
void add_trough(Case& c, double r, double width) {
  const double step = width / r;
  const auto at = [&](int k) {
    return Vec3(r * std::sin(k * step), -0.02, r - r * std::cos(k * step));
  };
  const int reach = static_cast<int>(std::min(0.014, pi * r) / width) + 1;
  for (int k = -reach; k < reach; ++k)
    add_wall(c, rectangle(at(k), at(k + 1) - at(k), Vec3(0, 0.04, 0)));
}

}  // namespace

TEST_CASE("a bead and a granule give a wall what the laws say, by contact and by gas") {
  // Overlap of 0.1 % of the radius; contact alone: 4 a k1 k2/(k1 + k2), a = sqrt(R d)
  // (Y*soft/Y*real)^(1/3).
  for (const SpeciesIndex species : {SpeciesIndex{0}, SpeciesIndex{1}}) {
    Case c = bare_case();
    add_wall(c, floor_plane);
    const double k = species == 0 ? 1.0 : 3.0, young = species == 0 ? 70e9 : 350e9;
    const Sum got = to_walls(c, beads_at({Vec3(0, 0, 0.999 * radius)}, species));
    const double softening = std::cbrt((5e6 / 2.0) / (1.0 / (1.0 / young + 1.0 / 200e9)));
    const double a = std::sqrt(radius * 1e-3 * radius) * softening;
    CHECK(got.links == 1);
    const double jump = chemistry::jump_length(0.21, 350.0, in_air, 1.0) * 2.0 * 1.1 / 0.9;
    const physics::GapPair pair{radius, physics::plane_wall, radius, a, 0.6};
    const physics::GapMedium medium{k, 20.0, chemistry::gas_conductivity(0.21, 350.0), jump};
    const auto law = physics::pair_conductance(pair, medium);
    CHECK(got.contact == Approx(law.contact).epsilon(1e-4));  // a table over T stands between
    CHECK(got.gap == Approx(law.gas).epsilon(1e-5));
    CHECK(got.gap > 2.0 * got.contact);  // so that the two cannot be mistaken
    const double bare = 4.0 * a * k * 20.0 / (k + 20.0);
    CHECK(physics::spot_conductance(pair, medium) == Approx(bare).epsilon(0.01));
  }
}

TEST_CASE("heat to a trough does not depend on how finely it is meshed") {
  Case round = bare_case();
  add_wall(round, Revolved{Vec3(0, -0.02, 0.05), Vec3::UnitY(), 0.05, 0.0, 0.05, 0.04, -1.0});
  for (const double aside : {0.0, 1e-4}) {
    const State state = beads_at({Vec3(aside, 0, radius - 2e-6)});
    const double smooth = to_walls(round, state).gap;
    for (const double width : {3.3e-3, 1.7e-3, 0.17e-3, 0.04e-3}) {
      Case meshed = bare_case();
      add_trough(meshed, 0.05, width);
      CAPTURE(width, aside);
      const Sum got = to_walls(meshed, state);
      CHECK(got.links == 1);
      CHECK(got.gap == Approx(smooth).epsilon(0.02));
      add_wall(meshed, round.walls.surfaces[0].shape);  // analytic and mesh on each other
      CHECK(to_walls(meshed, state).gap == Approx(smooth).epsilon(0.02));
    }
  }
}

TEST_CASE("heat to a pipe little wider than the sphere does not depend on its facets") {
  const double r = radius / 0.7;
  Case round = bare_case(), meshed = bare_case();
  add_wall(round, Revolved{Vec3(0, -0.02, r), Vec3::UnitY(), r, 0.0, r, 0.04, -1.0});
  add_trough(meshed, r, 0.02 * r);
  const State state = beads_at({Vec3(1e-5, 0, radius)});
  CHECK(to_walls(meshed, state).links <= 3);  // beneath, and two facets just opposite
  CHECK(to_walls(meshed, state).gap == Approx(to_walls(round, state).gap).epsilon(0.05));
}

TEST_CASE("heat counts seams, cracks, steps and walls behind walls once, corners by their sides") {
  const Vec3 across(0.05, 0, 0), along(0, 0.1, 0), corner(0, -0.05, 0);
  const State state = beads_at({Vec3(1e-7, 1e-3, 0.999 * radius)});
  const auto links = [&](const std::vector<Shape>& shapes) {
    Case c = bare_case();
    for (const Shape& shape : shapes) add_wall(c, shape);
    return to_walls(c, state);
  };
  const double one = links({floor_plane}).gap;
  const Facet left = rectangle(corner - across, across, along);
  for (const double gap : {0.0, 1e-8, 1e-6, 1e-4}) {
    const Vec3 apart(gap, 0, 0), below(0, 0, -std::min(gap, 1e-6));
    const Sum beside = links({left, rectangle(corner + apart, across, along)});
    const Sum lower = links({left, rectangle(corner + below, across, along)});
    const Sum behind = links({floor_plane, Plane{-apart.x() * Vec3::UnitZ(), Vec3::UnitZ()}});
    for (const Sum& sum : {beside, lower, behind}) {
      CHECK(sum.links == 1);
      CHECK(sum.gap == Approx(one).epsilon(0.01));
    }
  }
  const Plane wall{Vec3(-0.999 * radius, 0, 0), Vec3::UnitX()};
  const Vec3 uphill(0.6, 0, 0.8);
  const Plane slope{state.particles.position[0] - 0.999 * radius * uphill, uphill};
  CHECK(links({floor_plane, wall}).links == 2);
  CHECK(links({floor_plane, wall}).gap == Approx(2.0 * one).epsilon(1e-3));
  CHECK(links({floor_plane, slope}).links == 2);
  const double between = 20.0 * pi / 180.0;  // less than two surfaces, more than one
  const Vec3 steep(std::sin(between), 0, std::cos(between));
  const Plane bend{state.particles.position[0] - 0.999 * radius * steep, steep};
  const auto cosine = [](double degrees) { return std::cos(degrees * pi / 180.0); };
  const double share = (cosine(15.0) - cosine(20.0)) / (cosine(15.0) - cosine(25.0));
  const Sum both = links({floor_plane, bend});
  CHECK(both.gap == Approx((1.0 + share) * one).epsilon(1e-3));
  CHECK(both.contact == Approx((1.0 + share) * links({floor_plane}).contact).epsilon(1e-3));
}

TEST_CASE("heat through the gas fades with a wall's distance: it does not end at half a radius") {
  const auto at_gap = [](double gap) {  // [1] of the radius
    Case c = bare_case();
    add_wall(c, floor_plane);
    return to_walls(c, beads_at({Vec3(0, 0, (1.0 + gap) * radius)})).gap;
  };
  const double touching = at_gap(0.0);
  CHECK(at_gap(0.501) == Approx(at_gap(0.499)).epsilon(0.02));
  double before = touching;
  for (double gap = 0.05; gap < 4.0; gap += 0.05) {
    const double now = at_gap(gap);
    CHECK(now <= before);
    CHECK((now > 0.0 || before < 0.004 * touching));  // ends where nobody sees it
    before = now;
  }
  CHECK(at_gap(2.0) > 0.0);
}

TEST_CASE("a particle exchanges no heat with a wall that its neighbours hide") {
  Case c = bare_case();
  add_wall(c, floor_plane);
  const Vec3 up(0, 0, 1);
  // A column of three that touch: the floor is 0, 2 and 4 radii off.
  const State column = beads_at({radius * up, 3.0 * radius * up, 5.0 * radius * up});
  CHECK(to_walls(c, column, 0).links == 1);
  CHECK(to_walls(c, column, 1).links == 0);
  CHECK(to_walls(c, column, 2).links == 0);
  // The same place with the neighbour at its side, or above.
  for (const Vec3& beside : {Vec3(2.0 * radius, 0, 3.0 * radius), Vec3(0, 0, 5.0 * radius)}) {
    const State free = beads_at({beside, 3.0 * radius * up});
    CHECK(to_walls(c, free, 1).links == 1);
  }
}
