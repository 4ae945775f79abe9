// Ray tracing against view factors, enclosures with reflections and Cauchy's mean chord.
// Statistical checks pass within 4 standard errors of the number of rays: by chance each would fail
// in 6e-5 of all seeds (fewer in fact: the quasi-random points are closer); the seeds are fixed.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "coupling/tessellate.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"
#include "pmr/base/random.hpp"
#include "radiation/emission.hpp"
#include "radiation/exchange.hpp"
#include "radiation/geometry.hpp"
#include "verify/check.hpp"

namespace pmr::verify {
namespace {

using namespace radiation;

constexpr std::uint64_t many = 1000000;  // [1] rays of a view factor
constexpr std::uint64_t seed = 20240607;

const char* const element_quadrature =
    "element-to-sphere factor (Howell, Catalog of Configuration Factors, B-43) integrated over the "
    "sphere, own quadrature to 1e-7 (D); 4 standard errors";

double sphere_area(double radius) { return 4.0 * pi * radius * radius; }  // [m2]

// A view factor measured by `rays` rays, `hits` of which landed.
Check view_factor(std::string id, std::string what, std::array<double, 3> hits_rays_expected,
                  std::string source) {
  const auto [hits, rays, expected] = hits_rays_expected;
  return {"radiation." + std::move(id),
          std::move(what),
          hits / rays,
          expected,
          4.0 * std::sqrt(expected * (1.0 - expected) / rays),
          "1",
          std::move(source)};
}

double hits_on(const Tracer& tracer, std::uint32_t emitter, std::uint32_t node,
               std::uint32_t nodes) {
  return static_cast<double>(view_counts(tracer, emitter, many, seed, nodes)[node]);
}

constexpr auto all = static_cast<double>(many);

// --- View factors of two spheres
void add_pair(std::vector<Check>& checks, const std::string& name, std::array<double, 3> r1_r2_d,
              double expected) {
  const auto [r1, r2, distance] = r1_r2_d;  // [m]
  const std::vector<Sphere> spheres{{Vec3(0.05, 0.0, 0.0), r1, 0},
                                    {Vec3(0.05, distance, 0.0), r2, 1}};
  const Tracer tracer(spheres, {});
  checks.push_back(view_factor("view." + name, "View factor of two spheres, " + name,
                               {hits_on(tracer, 0, 1, 3), all, expected}, element_quadrature));
}

void add_pairs(std::vector<Check>& checks) {
  add_pair(checks, "equal_touching", {1e-3, 1e-3, 2e-3}, 0.0755868);
  add_pair(checks, "bead_to_granule", {1.495e-3, 0.735e-3, 2.23e-3}, 0.0336211);
  add_pair(checks, "granule_to_bead", {0.735e-3, 1.495e-3, 2.23e-3}, 0.1390976);
  add_pair(checks, "gap_half_radius", {1e-3, 1e-3, 2.5e-3}, 0.0441189);
  add_pair(checks, "gap_one_radius", {1e-3, 1e-3, 3e-3}, 0.0295903);
  add_pair(checks, "gap_two_radii", {1e-3, 1e-3, 4e-3}, 0.0161562);
}

// --- Spheres and walls
void add_planes(std::vector<Check>& checks) {
  // A square of 1e5 radii misses about h/L of the half space's edge: 3e-5, below a tenth of the
  // tolerance.
  const double l = 1e5;
  const std::vector<Triangle> plane{{{Vec3(-l, -l, 0.0), Vec3(l, -l, 0.0), Vec3(l, l, 0.0)}, 1},
                                    {{Vec3(-l, -l, 0.0), Vec3(l, l, 0.0), Vec3(-l, l, 0.0)}, 1}};
  for (const double height : {1.0, 3.0}) {
    const std::vector<Sphere> spheres{{Vec3(0.0, 0.0, height), 1.0, 0}};
    const Tracer tracer(spheres, plane);
    const std::string name = height == 1.0 ? "plane_touching" : "plane_above";
    checks.push_back(view_factor(
        "view." + name,
        "Sphere to infinite plane, centre at " + std::to_string(static_cast<int>(height)) + " R",
        {hits_on(tracer, 0, 1, 3), all, 0.5},
        "closed form: half of all directions; 4 standard errors"));
  }
}

Surface revolved(double r0, double z0, double r1, double z1) {
  Surface surface;
  surface.shape = Revolved{Vec3::Zero(), Vec3::UnitZ(), r0, z0, r1, z1, -1.0};
  return surface;
}

void add_cylinder(std::vector<Check>& checks) {
  const std::array<Surface, 3> surfaces{
      revolved(0.0, -5.0, 5.0, -5.0), revolved(5.0, -5.0, 5.0, 5.0), revolved(5.0, 5.0, 0.0, 5.0)};
  std::vector<Triangle> walls;
  for (std::uint32_t k = 0; k < 3; ++k)
    for (const auto& t : coupling::tessellate(surfaces[k], Vec3::Zero(), Vec3::Zero()))
      walls.push_back({t.corner, k + 1});
  const std::vector<Sphere> spheres{{Vec3::Zero(), 1.0, 0}};
  const Tracer tracer(spheres, walls);
  const auto counts = view_counts(tracer, 0, many, seed, 5);
  // A sphere radiates like a point: a disc takes the solid angle (1 - cos 45 deg)/2.
  const double disc = 0.5 * (1.0 - std::sqrt(0.5));
  const char* const source = "closed form: solid angle from the centre; 4 standard errors";
  const auto add = [&](const char* id, const char* what, std::size_t node, double expected) {
    checks.push_back(
        view_factor(id, what, {static_cast<double>(counts[node]), all, expected}, source));
  };
  add("view.cylinder_floor", "Sphere in a closed cylinder (R 5, H 10) to the floor", 1, disc);
  add("view.cylinder_side", "Sphere in a closed cylinder to the side", 2, std::sqrt(0.5));
  add("view.cylinder_lid", "Sphere in a closed cylinder to the lid", 3, disc);
  checks.push_back({"radiation.view.cylinder_leaks", "Rays that leave the closed cylinder",
                    static_cast<double>(counts[0] + counts[4]), 0.0, 0.0, "1",
                    "closed enclosure: every ray lands on a wall"});
}

// --- Closed meshes that face inwards
// Sphere of 20 * 4^levels triangles (icosahedron), corners at `radius`.
std::vector<Triangle> inward_sphere(double radius, int levels) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<Vec3, 12> v{Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0),
                               Vec3(0, -1, g), Vec3(0, 1, g), Vec3(0, -1, -g), Vec3(0, 1, -g),
                               Vec3(g, 0, -1), Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1)};
  constexpr std::array<std::array<std::size_t, 3>, 20> faces{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  const auto lifted = [&](const Vec3& p) -> Vec3 { return radius * p.normalized(); };
  std::vector<Triangle> mesh;
  for (const auto& f : faces)
    mesh.push_back({{lifted(v[f[0]]), lifted(v[f[2]]), lifted(v[f[1]])}, 0});
  for (int level = 0; level < levels; ++level) {
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh) {
      const auto& [a, b, c] = t.corner;
      const Vec3 ab = lifted(a + b), bc = lifted(b + c), ca = lifted(c + a);
      finer.push_back({{a, ab, ca}, 0});
      finer.push_back({{ab, b, bc}, 0});
      finer.push_back({{ca, bc, c}, 0});
      finer.push_back({{ab, bc, ca}, 0});
    }
    mesh = std::move(finer);
  }
  return mesh;
}

// Box that faces inwards, all of one node.
std::vector<Triangle> inward_box(const Vec3& low, const Vec3& high, std::uint32_t node) {
  std::vector<Triangle> mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {0.0, 1.0}) {
      const Vec3 size = high - low;
      Vec3 u = Vec3::Zero(), v = Vec3::Zero(), a = low;
      u[(axis + 1) % 3] = size[(axis + 1) % 3];
      v[(axis + 2) % 3] = size[(axis + 2) % 3];
      a[axis] += side * size[axis];
      if (side > 0.0) std::swap(u, v);
      mesh.push_back({{a, a + u, a + u + v}, node});
      mesh.push_back({{a, a + u + v, a + v}, node});
    }
  return mesh;
}

double area_of_all(const std::vector<Triangle>& mesh) {
  return std::accumulate(mesh.begin(), mesh.end(), 0.0,
                         [](double sum, const Triangle& t) { return sum + area_of(t); });
}

void add_wall_to_sphere(std::vector<Check>& checks) {
  const std::vector<Sphere> spheres{{Vec3(0.3, -0.4, 0.5), 1.0, 0}};
  const auto walls = inward_box(Vec3::Constant(-2.0), Vec3::Constant(2.0), 1);
  const Tracer tracer(spheres, walls);
  double hits = 0.0;  // the twelve triangles are equal: so are their rays
  for (std::uint32_t k = 0; k < 12; ++k)
    hits += static_cast<double>(view_counts(tracer, 1 + k, many / 10, seed, 3)[0]);
  checks.push_back(view_factor("view.wall_to_sphere", "Walls of a cube to a sphere off its middle",
                               {hits, 1.2 * all, sphere_area(1.0) / 96.0},
                               "reciprocity: A_sphere/A_walls; 4 standard errors"));
}

// --- Enclosures with reflections
// Tolerance of a factor G_12 = E_1 D_12: 4 binomial errors of one of its two estimates.
double factor_tolerance(double factor, double emission, double rays) {
  const double d = factor / emission;
  return 4.0 * emission * std::sqrt(d * (1.0 - d) / rays);
}

void add_concentric(std::vector<Check>& checks) {
  const std::vector<Sphere> spheres{{Vec3::Zero(), 1.0, 0}};
  auto walls = inward_sphere(2.0, 4);
  for (Triangle& t : walls) t.node = 1;
  const double a1 = sphere_area(1.0), a2 = area_of_all(walls);
  const double e1 = 0.6, e2 = 0.3, rays = 3e5;
  const auto traced = trace({spheres, walls, {e1, e2, 1.0}, {a1, a2, 0.0}, 3, rays, seed, 0});
  const double expected = a1 / (1.0 / e1 + a1 / a2 * (1.0 / e2 - 1.0));
  checks.push_back({"radiation.exchange.concentric",
                    "G of concentric grey spheres, radii 1 and 2, emissivities 0.6 and 0.3",
                    traced.factor.value.at(0), expected, factor_tolerance(expected, e1 * a1, rays),
                    "m2",
                    "Christiansen: A1/(1/e1 + A1/A2 (1/e2 - 1)); 4 standard errors of one way"});
}

void add_spherical_cavity(std::vector<Check>& checks) {
  auto walls = inward_sphere(1.0, 5);
  std::array<double, 3> area{0.0, 0.0, 0.0};  // [m2]
  for (Triangle& t : walls) {
    const double z = (t.corner[0].z() + t.corner[1].z() + t.corner[2].z()) / 3.0;
    t.node = z > 0.4 ? 0 : (z < -0.2 ? 1 : 2);
    area[t.node] += area_of(t);
  }
  const double e1 = 0.9, e2 = 0.5, rays = 3e5;
  const auto traced =
      trace({{}, walls, {e1, e2, 0.0, 1.0}, {area[0], area[1], area[2], 0.0}, 4, rays, seed, 0});
  // All of a sphere's inside is seen alike, so each flight lands on j with A_j/A.
  const double expected = e1 * area[0] * e2 * area[1] / (e1 * area[0] + e2 * area[1]);
  checks.push_back({"radiation.exchange.cavity",
                    "G of two zones of a spherical cavity, the third re-radiates (emissivity 0)",
                    traced.factor.value.at(0), expected,
                    factor_tolerance(expected, e1 * area[0], rays), "m2",
                    "closed form, uniform irradiation of a spherical cavity (D): "
                    "E1 E2/(E1 + E2), E = eps A; 4 standard errors of one way"});
  checks.push_back({"radiation.exchange.cavity_rays", "Rays given up in the cavity",
                    traced.unfinished, 0.0, 0.0, "1", "every ray is absorbed in the end"});
}

// --- Beds
// Spheres of diameter 1 that do not overlap, put at random where there is room, in the unit of d.
std::vector<Sphere> random_packing(std::size_t count, double box) {
  std::vector<Sphere> spheres;
  Random random(seed, Purpose::test, 1);
  while (spheres.size() < count) {
    const auto place = [&] { return 0.5 + (box - 1.0) * random.uniform(); };
    const double x = place(), y = place(), z = place();
    const Vec3 centre(x, y, z);
    const bool fits = std::all_of(spheres.begin(), spheres.end(), [&](const Sphere& s) {
      return (s.centre - centre).squaredNorm() > 1.0;
    });
    if (fits) spheres.push_back({centre, 0.5, static_cast<std::uint32_t>(spheres.size())});
  }
  return spheres;
}

// Face-centred cubic, nearest neighbours at most 1 apart (in diameters) after a random shift.
std::vector<Sphere> dense_packing(int cells, double solid_fraction) {
  const double spacing = std::cbrt(pi / (3.0 * std::sqrt(2.0)) / solid_fraction);
  const double shift = 0.5 * (spacing - 1.0) / std::sqrt(3.0);
  const std::array<Vec3, 4> base{Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0.5),
                                 Vec3(0, 0.5, 0.5)};
  std::vector<Sphere> spheres;
  Random random(seed, Purpose::test, 2);
  for (int cell = 0; cell < cells * cells * cells; ++cell)
    for (const Vec3& b : base) {
      const int row = cell / cells, layer = row / cells;
      const Vec3 corner(cell % cells, row % cells, layer);
      const auto uneven = [&] { return shift * (2.0 * random.uniform() - 1.0); };
      const double x = uneven(), y = uneven(), z = uneven();
      const Vec3 centre =
          Vec3::Constant(0.75) + std::sqrt(2.0) * spacing * (corner + b) + Vec3(x, y, z);
      spheres.push_back({centre, 0.5, static_cast<std::uint32_t>(spheres.size())});
    }
  return spheres;
}

struct Flights {
  double count = 0.0, sum = 0.0, squares = 0.0;  // [1], [d], [d2]
};

// Diffuse flights from all surfaces, `per_area` of them a unit area.
Flights fly_all(const std::vector<Sphere>& spheres, const std::vector<Triangle>& walls,
                double per_area) {
  const Tracer tracer(spheres, walls);
  const std::size_t primitives = tracer.scene().primitives();
  std::vector<Flights> each(primitives);
  parallel_for(
      primitives,
      [&](std::size_t k) {
        const auto p = static_cast<std::uint32_t>(k);
        const double area = tracer.scene().is_sphere(p) ? sphere_area(spheres[k].radius)
                                                        : area_of(tracer.scene().triangle(p));
        const QuasiPoints quasi(seed, p, 0);
        const auto rays = static_cast<std::uint64_t>(std::round(area * per_area));
        for (std::uint64_t ray = 0; ray < rays; ++ray) {
          const double d = tracer.follow(emit(tracer.scene(), p, quasi.point(ray))).distance;
          each[k].count += 1.0;
          each[k].sum += d;
          each[k].squares += d * d;
        }
      },
      16);
  return std::accumulate(each.begin(), each.end(), Flights{}, [](Flights a, const Flights& b) {
    return Flights{a.count + b.count, a.sum + b.sum, a.squares + b.squares};
  });
}

void add_mean_flight(std::vector<Check>& checks, const std::string& name,
                     const std::vector<Sphere>& spheres, const Vec3& high) {
  const auto walls = inward_box(Vec3::Zero(), high, static_cast<std::uint32_t>(spheres.size()));
  const auto n = static_cast<double>(spheres.size());
  const double surface = n * sphere_area(0.5) + area_of_all(walls);  // [d2]
  const double solid_fraction = n * pi / 6.0 / high.prod();
  const double expected = 4.0 * (1.0 - solid_fraction) * high.prod() / surface;
  const Flights f = fly_all(spheres, walls, all / surface);
  const double mean = f.sum / f.count;
  const double error = std::sqrt((f.squares / f.count - mean * mean) / f.count);
  checks.push_back({"radiation.flight." + name,
                    "Mean free flight in a closed box of spheres, solid fraction " +
                        std::to_string(solid_fraction).substr(0, 4),
                    mean, expected, 4.0 * error, "d",
                    "Cauchy: 4 V/S of the void, (2/3) d psi/phi of a bed without walls; "
                    "4 standard errors"});
}

void add_mean_flights(std::vector<Check>& checks) {
  add_mean_flight(checks, "random", random_packing(1000, 13.0), Vec3::Constant(13.0));
  const auto dense = dense_packing(6, 0.55);
  Vec3 high = Vec3::Zero();
  for (const Sphere& s : dense) high = high.cwiseMax(s.centre);
  add_mean_flight(checks, "dense", dense, high + Vec3::Constant(0.75));
}

void add_reciprocity(std::vector<Check>& checks) {
  const auto spheres = dense_packing(2, 0.55);
  const Tracer tracer(spheres, {});
  const auto n = static_cast<std::uint32_t>(spheres.size());
  // One ray a seed: independent rays, so that the counts are binomial.
  constexpr std::uint64_t rays = 4000;
  std::vector<std::vector<double>> counts(n, std::vector<double>(n + 1, 0.0));
  parallel_for(
      n,
      [&](std::size_t i) {
        for (std::uint64_t ray = 0; ray < rays; ++ray) {
          const auto p = static_cast<std::uint32_t>(i);
          const QuasiPoints single(seed + ray, p, 0);
          const Hit hit = tracer.follow(emit(tracer.scene(), p, single.point(0)));
          counts[i][hit.is_empty() ? n : hit.node] += 1.0;
        }
      },
      1);
  double chi2 = 0.0, pairs = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double sum = counts[i][j] + counts[j][i], difference = counts[i][j] - counts[j][i];
      if (sum == 0.0) continue;
      chi2 += difference * difference / sum;
      pairs += 1.0;
    }
  checks.push_back({"radiation.reciprocity", "chi2 a pair of the two estimates of each exchange",
                    chi2 / pairs, 1.0, 4.0 * std::sqrt(2.0 / pairs), "1",
                    "reciprocity of equal spheres, binomial counts; 4 standard errors"});
}

// --- The matrix of a closed bed at few rays: what must hold exactly
void add_matrix(std::vector<Check>& checks) {
  const auto spheres = dense_packing(4, 0.55);
  const auto n = static_cast<std::uint32_t>(spheres.size());
  Vec3 high = Vec3::Zero();
  for (const Sphere& s : spheres) high = high.cwiseMax(s.centre);
  high += Vec3::Constant(0.75);
  const auto walls = inward_box(Vec3::Zero(), high, n);
  std::vector<double> emissivity(n + 2, 0.8), area(n + 2, sphere_area(0.5));
  area[n] = area_of_all(walls);
  const auto traced = trace({spheres, walls, emissivity, area, n + 2, 10.0, seed, 0});
  const Csr& g = traced.factor;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> place;
  double heat = 0.0;  // [W] largest net heat of a node of the isothermal bed
  const double power = stefan_boltzmann * std::pow(1273.0, 4);
  for (std::uint32_t i = 0; i < g.rows(); ++i) {
    double net = 0.0;
    for (std::size_t k = 0; k < g.columns(i).size(); ++k) {
      place[{i, g.columns(i)[k]}] = g.values(i)[k];
      net += g.values(i)[k] * (power - power);
    }
    heat = std::max(heat, std::abs(net));
  }
  double unequal = 0.0;
  for (const auto& [at, value] : place) {
    const auto mirror = place.find({at.second, at.first});
    unequal += mirror == place.end() || mirror->second != value ? 1.0 : 0.0;
  }
  checks.push_back({"radiation.matrix.symmetry", "Entries that differ from their mirror in any bit",
                    unequal, 0.0, 0.0, "1", "G_ij = G_ji by construction"});
  const auto sums = row_sums(g);
  double worst = 0.0;  // [1]
  for (std::uint32_t i = 0; i <= n; ++i)
    worst = std::max(worst, std::abs((sums[i] + traced.self[i]) / (0.8 * area[i]) - 1.0));
  checks.push_back({"radiation.matrix.row_sums", "Worst row sum over eps A, less 1, at 10 rays",
                    worst, 0.0, 1e-9, "1", "all that is emitted is absorbed"});
  checks.push_back({"radiation.matrix.isothermal",
                    "Net heat of any node of an isothermal closed bed at 10 rays", heat, 0.0, 0.0,
                    "W", "second law: exactly nothing, whatever the noise"});
}

}  // namespace

std::vector<Check> radiation_checks() {
  std::vector<Check> checks;
  add_pairs(checks);
  add_planes(checks);
  add_cylinder(checks);
  add_wall_to_sphere(checks);
  add_concentric(checks);
  add_spherical_cavity(checks);
  add_mean_flights(checks);
  add_reciprocity(checks);
  add_matrix(checks);
  return checks;
}

}  // namespace pmr::verify
