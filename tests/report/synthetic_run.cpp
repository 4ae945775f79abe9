#include "synthetic_run.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

namespace pmr::report {
namespace {

constexpr double bead_radius = 1.495e-3, granule_radius = 0.735e-3;  // [m]
constexpr double small_chamber = 13.57e-3;                           // [m] for 3,862 particles
constexpr double end = 1800.0, settled = 0.62;                       // [s]

double uniform(std::uint64_t i, std::uint64_t k) {
  return Random(7, Purpose::test, i, k).uniform();
}

struct Bed {
  double scale;  // [1] of the rig's lengths, so that the bed is as high as wide as the small one
  std::vector<Vec3> start, rest;  // [m]
  std::vector<double> radius;
  std::vector<std::uint8_t> species;
  double chamber() const { return scale * small_chamber; }
};

// What lies on top of each square of the floor: a sphere is laid on these alone.
class Tops {
 public:
  explicit Tops(double half_width) : half_width_(half_width) {}
  static constexpr std::size_t depth = 12;

  template <class Visit>
  void near(const Vec3& at, const Visit& visit) const {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        if (const auto found = cells_.find({cell(at.x()) + dx, cell(at.y()) + dy});
            found != cells_.end())
          for (const std::size_t i : found->second) visit(i);
  }
  void add(const Vec3& at, std::size_t i) {
    auto& tops = cells_[{cell(at.x()), cell(at.y())}];
    tops.push_back(i);
    if (tops.size() > depth) tops.erase(tops.begin());
  }

 private:
  int cell(double x) const {
    return static_cast<int>(std::floor((x + half_width_) / (2.0 * bead_radius)));
  }
  double half_width_;  // [m]
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells_;
};

// Lowest of some random places on what is already there.
Vec3 place(const Bed& bed, const Tops& tops, std::size_t i, double r) {
  Vec3 best(0, 0, 1e3);
  for (std::uint64_t trial = 0; trial < 24; ++trial) {
    const double rho = (bed.chamber() - r) * std::sqrt(uniform(i, 3 * trial));
    const double phi = 2.0 * pi * uniform(i, 3 * trial + 1);
    Vec3 at(rho * std::cos(phi), rho * std::sin(phi), r);
    tops.near(at, [&](std::size_t j) {
      const double reach = r + bed.radius[j];
      const double across = (at.head<2>() - bed.rest[j].head<2>()).squaredNorm();
      if (across < reach * reach)
        at.z() = std::max(at.z(), bed.rest[j].z() + std::sqrt(reach * reach - across));
    });
    if (at.z() < best.z()) best = at;
  }
  return best;
}

Bed settle(std::size_t count) {
  Bed bed{std::cbrt(static_cast<double>(count) / 3862.0), {}, {}, {}, {}};
  Tops tops(bed.chamber());
  for (std::size_t i = 0; i < count; ++i) {
    const double height = static_cast<double>(i) / static_cast<double>(count);
    const bool is_bead = uniform(i, 1000) < 0.02 + 0.16 * height;
    const double r = is_bead ? bead_radius : granule_radius;
    bed.rest.push_back(place(bed, tops, i, r));
    tops.add(bed.rest.back(), i);
    bed.radius.push_back(r);
    bed.species.push_back(is_bead ? 0 : 1);
    const double rho = 3e-3 + 8e-3 * std::sqrt(uniform(i, 1001)), phi = 6.28 * uniform(i, 1002);
    const Vec3 start((is_bead ? 0.1215 : 0.0135) + rho * std::cos(phi), rho * std::sin(phi),
                     0.25 + 0.05 * uniform(i, 1003));
    bed.start.push_back(bed.scale * start);
  }
  return bed;
}

Vec3 position(const Bed& bed, std::size_t i, double t) {
  const double delay = (bed.species[i] == 0 ? 0.0 : 0.065) + 0.15 * uniform(i, 1004);
  const double s = std::clamp((t - delay) / 0.35, 0.0, 1.0);
  return bed.start[i] + s * s * (bed.rest[i] - bed.start[i]);
}

// [K], with a cooler rim.
double temperature(const Bed& bed, std::size_t i, double t) {
  const double mixed = 1196.0, fast = std::exp(-std::max(0.0, t) / 12.0);
  const double rim = bed.rest[i].head<2>().norm() / bed.chamber();
  const double cooling = 60.0 * (1.0 - std::exp(-std::max(0.0, t) / 900.0)) * (0.4 + rim * rim);
  const double start = bed.species[i] == 0 ? 1373.15 : 973.15;
  return mixed + (start - mixed) * fast - cooling + 6.0 * (uniform(i, 1005) - 0.5) * (1.0 - fast);
}

double delta(const Bed& bed, std::size_t i, double t) {
  const double grown = 1.0 - std::exp(-std::max(0.0, t) / 25.0);
  return bed.species[i] == 0 ? 0.0 : 0.327 + (0.135 - 0.8 * bed.rest[i].norm() / bed.scale) * grown;
}

io::Snapshot snapshot_at(const Bed& bed, double t) {
  io::Snapshot snapshot;
  snapshot.time = t;
  snapshot.phase = t < settled ? Phase::mix : Phase::react;
  Particles& p = snapshot.particles;
  resize(p, bed.rest.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool is_bead = bed.species[i] == 0;
    p.id[i] = static_cast<ParticleId>(i);
    p.species[i] = bed.species[i];
    p.radius[i] = bed.radius[i];
    p.mass[i] = 4.0 / 3.0 * pi * std::pow(bed.radius[i], 3) * (is_bead ? 3690.0 : 3460.0);
    p.position[i] = position(bed, i, t);
    p.temperature[i] = temperature(bed, i, t);
    p.delta[i] = delta(bed, i, t);
    p.formula_units[i] = is_bead ? 0.0 : p.mass[i] / 0.19;
    p.enthalpy[i] = p.mass[i] * (is_bead ? 1250.0 : 900.0) * (p.temperature[i] - 298.15);
  }
  snapshot.wall_temperature = {600.0, 500.0};
  return snapshot;
}

Surface revolved(const char* name, const Vec3& origin, std::array<double, 4> rz, double facing) {
  Surface surface;
  surface.name = name;
  surface.shape = Revolved{origin, Vec3::UnitZ(), rz[0], rz[1], rz[2], rz[3], facing};
  return surface;
}

Case rig(double scale) {
  Case c;
  c.title = "Demonstrator, small, hot";
  c.description = "1/50 of the masses; made up for the report's tests.";
  c.domain_low = scale * Vec3(-0.1, -0.1, -0.01);
  c.domain_high = scale * Vec3(0.2, 0.1, 0.35);
  c.walls.bodies.push_back({"rig", Rest{}});
  const double r = scale * small_chamber, tube = scale * 0.012, length = scale * 0.07;  // [m]
  c.walls.surfaces = {
      revolved("chamber.side", Vec3::Zero(), {r, 0, r, scale * 0.06}, -1),
      revolved("chamber.floor", Vec3::Zero(), {0, 0, r, 0}, -1),
      revolved("tube.Al2O3", scale * Vec3(0.1215, 0, 0.233), {tube, 0, tube, length}, -1),
      revolved("tube.SrFeO3", scale * Vec3(0.0135, 0, 0.233), {tube, 0, tube, length}, -1)};
  c.output.cut_point = Vec3::Zero();
  c.output.cut_normal = Vec3(0, -1, 0);
  return c;
}

}  // namespace

RunData synthetic_run(std::size_t particles, const std::string& name) {
  const auto bed = std::make_shared<Bed>(settle(particles));
  RunData run;
  run.name = name;
  run.header.case_text = "# made up\ntitle = \"" + name + "\"\n";
  run.header.species = {"Al2O3", "SrFeO3"};
  run.header.patches = {"chamber.side", "chamber.floor"};
  run.header.provenance = {{"version", "0.1.0"}};
  run.series.columns = {{"time", "s", {0.0, settled, end}}, {"phase", "1", {1.0, 2.0, 2.0}}};
  for (int k = 0; k <= 12; ++k) run.snapshot_times.push_back(0.05 * k);
  for (const double t : {settled, 2.0, 10.0, 60.0, 300.0, end}) run.snapshot_times.push_back(t);
  const std::vector<double> times = run.snapshot_times;
  run.snapshot = [bed, times](std::size_t index) { return snapshot_at(*bed, times.at(index)); };
  run.setup = rig(bed->scale);
  gather_species(run);
  return run;
}

void write_folder(const RunData& run, const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  io::create_run(folder, run.header);
  std::vector<io::Snapshot> snapshots;
  for (std::size_t k = 0; k < run.snapshot_times.size(); ++k) snapshots.push_back(run.snapshot(k));
  io::append_run(folder, run.series, snapshots);
  std::ofstream(folder / "summary.json") << to_json(run.summary);
}

}  // namespace pmr::report
