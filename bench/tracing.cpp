// Speed of ray tracing in a settled bed: plain Embree against the tracer on the same rays, and the
// exchange factors of the whole bed. Prints one line of CSV under its header.
//   bench_tracing DUMP [rays per granule]
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "io/dump.hpp"
#include "physics/neighbours.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"
#include "pmr/base/timer.hpp"
#include "radiation/emission.hpp"
#include "radiation/exchange.hpp"

using namespace pmr;
using namespace pmr::radiation;

namespace {

constexpr std::size_t rays_of_each = 8;     // [1] flown by both tracers from each sphere
constexpr double emissivity = 0.8;          // [1] of everything
constexpr double radius = 0.05, lid = 0.2;  // [m] of the can
constexpr std::uint32_t facets = 128;

std::vector<Sphere> bed(const std::string& file) {
  Particles p;
  for (const io::DumpAtom& atom : io::read_dump(file).atoms) {
    p.position.push_back(atom.position);
    p.radius.push_back(atom.radius);
    p.id.push_back(static_cast<ParticleId>(p.id.size()));
  }
  for_each_field(p, [&](const char*, const char*, auto& field) { field.resize(p.id.size()); });
  std::vector<Sphere> spheres;
  for (const std::uint32_t i : physics::spatial_order(p))
    spheres.push_back({p.position[i], p.radius[i], static_cast<std::uint32_t>(spheres.size())});
  return spheres;
}

// Nodes: side, floor, lid.
std::vector<Triangle> can(std::uint32_t node) {
  std::vector<Triangle> triangles;
  for (std::uint32_t k = 0; k < facets; ++k) {
    const auto at = [&](std::uint32_t m, double r, double z) {
      const double angle = 2.0 * pi * m / facets;
      return Vec3(r * std::cos(angle), r * std::sin(angle), z);
    };
    const double r = 1.001 * radius;  // outside of every sphere
    const Vec3 a = at(k, r, 0.0), b = at(k + 1, r, 0.0), c = at(k + 1, r, lid), d = at(k, r, lid);
    triangles.push_back({{a, c, b}, node});
    triangles.push_back({{a, d, c}, node});
    triangles.push_back({{a, b, Vec3(0.0, 0.0, 0.0)}, node + 1});
    triangles.push_back({{c, d, Vec3(0.0, 0.0, lid)}, node + 2});
  }
  return triangles;
}

template <class Body>
double seconds(const Body& body) {
  const Stopwatch watch;
  body();
  return watch.seconds();
}

std::vector<Departure> departures(const Scene& scene) {
  std::vector<Departure> all(rays_of_each * scene.spheres().size());
  parallel_for(all.size(), [&](std::size_t k) {
    const std::size_t sphere = k / rays_of_each;
    all[k] = emit(scene, static_cast<std::uint32_t>(sphere),
                  QuasiPoints(1, sphere, 0).point(k % rays_of_each));
  });
  return all;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return std::cerr << "bench_tracing DUMP [rays per granule]\n", 2;
  const double rays = count > 2 ? std::stod(arguments[2]) : 1000.0;
  const std::vector<Sphere> spheres = bed(arguments[1]);
  const auto n = static_cast<std::uint32_t>(spheres.size());
  const std::vector<Triangle> walls = can(n);

  const double scene_seconds = seconds([&] { const Scene only(spheres, walls); });
  const Stopwatch building;
  const Tracer tracer(spheres, walls);
  const double tracer_seconds = building.seconds();

  const std::vector<Departure> rays_flown = departures(tracer.scene());
  std::vector<std::uint32_t> plain(rays_flown.size()), near(rays_flown.size());
  const double plain_seconds = seconds([&] {
    parallel_for(rays_flown.size(), [&](std::size_t k) {
      const Departure& d = rays_flown[k];
      const Sphere& s = spheres[d.primitive];
      plain[k] = tracer.scene()
                     .nearest({s.centre + 1.0001 * s.radius * d.normal, d.direction}, d.primitive)
                     .node;
    });
  });
  const double near_seconds = seconds([&] {
    parallel_for(rays_flown.size(),
                 [&](std::size_t k) { near[k] = tracer.follow(rays_flown[k]).node; });
  });
  std::size_t differ = 0;
  for (std::size_t k = 0; k < plain.size(); ++k) differ += plain[k] != near[k] ? 1 : 0;

  ExchangeInput input{spheres, walls, std::vector<double>(n + 4, emissivity), {}, n + 4, rays,
                      1,       0};
  for (const Sphere& s : spheres) input.area.push_back(4.0 * pi * s.radius * s.radius);
  input.area.insert(input.area.end(),
                    {2.0 * pi * radius * lid, pi * radius * radius, pi * radius * radius, 0.0});
  Exchange traced;
  const double factor_seconds = seconds([&] { traced = trace(input); });
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);

  std::cout << "particles,cores,tree_seconds,tracer_seconds,rays,plain_seconds,near_seconds,ratio,"
               "differ,rays_per_granule,factor_rays,factor_seconds,entries,row_sum_error,peak_MiB\n"
            << n << ',' << ThreadLimit::current() << ',' << scene_seconds << ',' << tracer_seconds
            << ',' << rays_flown.size() << ',' << plain_seconds << ',' << near_seconds << ','
            << plain_seconds / near_seconds << ','
            << static_cast<double>(differ) / static_cast<double>(plain.size()) << ',' << rays << ','
            << traced.rays << ',' << factor_seconds << ',' << traced.factor.column.size() << ','
            << traced.row_sum_error << ',' << usage.ru_maxrss / 1024 << '\n';
}
