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
    p.iron[i] = is_bead ? 0.0 : p.mass[i] / 0.19;
    p.enthalpy[i] = p.mass[i] * (is_bead ? 1250.0 : 900.0) * (p.temperature[i] - 298.15);
  }
  snapshot.wall_temperature = {600.0, 500.0};
  return snapshot;
}

std::vector<double> row_times() {
  std::vector<double> times;
  for (int k = -4; k < 32; ++k) times.push_back(0.02 * k);
  for (double t = 0.7; t < end; t *= 1.12) times.push_back(t);
  times.push_back(end);
  return times;
}

double pressure(double t) {
  return std::max(1000.0, t < 10 ? 101325.0 : 101325 * std::exp((10 - t) / 14));
}

double cumulative(double t, double total, double tau) {
  return total * (1.0 - std::exp(-std::max(0.0, t) / tau));
}

io::Series series_of() {
  io::Series series;
  const std::vector<double> times = row_times();
  const auto add = [&](const char* name, const char* unit, auto&& of) {
    io::Column column{name, unit, {}};
    for (const double t : times) column.values.push_back(of(t));
    series.columns.push_back(std::move(column));
  };
  const auto mix = [](double t, double from) {
    const double fast = std::exp(-std::max(0.0, t) / 12.0);
    return 1196.0 + (from - 1196.0) * fast - 55.0 * (1.0 - std::exp(-std::max(0.0, t) / 900.0));
  };
  add("time", "s", [](double t) { return t; });
  add("phase", "1", [](double t) { return t < 0 ? 0.0 : t < settled ? 1.0 : 2.0; });
  add("temperature_mean.Al2O3", "K", [&](double t) { return mix(t, 1373.15); });
  add("temperature_p10.Al2O3", "K",
      [&](double t) { return mix(t, 1373.15) - 9 - 40 * std::exp(-t * t / 300); });
  add("temperature_p90.Al2O3", "K", [&](double t) { return mix(t, 1373.15) + 7; });
  add("temperature_mean.SrFeO3", "K", [&](double t) { return mix(t, 973.15); });
  add("temperature_p10.SrFeO3", "K", [&](double t) { return mix(t, 973.15) - 11; });
  add("temperature_p90.SrFeO3", "K",
      [&](double t) { return mix(t, 973.15) + 9 + 60 * std::exp(-t * t / 300); });
  add("delta_mean", "1", [](double t) { return 0.327 + cumulative(t, 0.125, 25); });
  add("delta_p10", "1", [](double t) { return 0.327 + cumulative(t, 0.115, 25); });
  add("delta_p90", "1", [](double t) { return 0.327 + cumulative(t, 0.132, 25); });
  add("pressure", "Pa", pressure);
  add("oxygen_pressure", "Pa",
      [](double t) { return pressure(t) * (0.21 + cumulative(t, 0.78, 40)); });
  add("nitrogen_pressure", "Pa",
      [](double t) { return pressure(t) * (0.79 - cumulative(t, 0.78, 40)); });
  add("gas_temperature", "K", [](double t) { return 298.15 + cumulative(t, 500, 30); });
  add("oxygen_released", "mol", [](double t) { return cumulative(t, 7.0e-3, 25); });
  add("oxygen_rate", "mol s-1",
      [](double t) { return t < 0 ? 0.0 : 7.0e-3 / 25 * std::exp(-t / 25); });
  add("oxygen_pumped", "mol", [](double t) { return cumulative(t - 10, 6.8e-3, 30); });
  add("heat_contact", "J", [](double t) { return cumulative(t, 420, 15); });
  add("heat_gap", "J", [](double t) { return cumulative(t, 2300, 10); });
  add("heat_radiation", "J", [](double t) { return cumulative(t, 1500, 8); });
  add("heat_to_walls", "J", [](double t) { return cumulative(t, 1900, 500); });
  add("heat_reaction", "J", [](double t) { return cumulative(t, 1180, 25); });
  add("heat_to_surroundings", "J", [](double t) { return cumulative(t, 35, 0.3); });
  add("kinetic_energy", "J",
      [](double t) { return t < 0 ? 1e-9 : 0.05 * t * std::exp(-t * t / 0.05) + 1e-10; });
  add("thermocouple.centre", "K", [&](double t) { return mix(t, 1100.0) + 20; });
  return series;
}

const char* summary_text = R"({
 "status": "completed",
 "case": {"title": "Demonstrator, small, hot", "description": "Made up for the report's tests."},
 "provenance": {"version": "0.1.0", "git": "0123abc", "case_hash": "9d1c", "threads": 2,
                "state_hash": "57aa01bc"},
 "command": "pmr run cases/demonstrator-small.toml", "machine": "2 cores, <made up>",
 "warnings": ["pO2 below the fit's range for 3 % of the granules after 40 s"],
 "assumed": [{"key": "chamber.film_coefficient", "value": "5 W/m2/K", "source": "free convection"},
             {"key": "materials.Al2O3.emissivity", "value": "0.45 to 0.75",
             "source": "literature, +-0.15"},
             {"key": "chamber.pump.speed", "value": "0.4 l/s",
             "source": "1000 Pa in about a minute"}],
 "mechanics": {"particles": {"total": 3862, "Al2O3": 387, "SrFeO3": 3475}, "lost": 0,
 "steps": 65000,
   "time_step": 2e-5, "max_overlap_ratio": 0.021, "bed_height": 0.0351, "solid_fraction": 0.597,
   "coordination_number": 5.62, "particle_steps_per_second": 9100000},
 "homogeneity": {"sectors": 8, "lacey_index": 0.712, "layers": [
   {"mass": 0.0052, "thickness": 0.0053, "mass_ratio": 4.28}, {"mass": 0.0053,
   "thickness": 0.0043, "mass_ratio": 3.21},
   {"mass": 0.0054, "thickness": 0.0044, "mass_ratio": 1.63}, {"mass": 0.0058,
   "thickness": 0.0048, "mass_ratio": 0.71},
   {"mass": 0.0053, "thickness": 0.0044, "mass_ratio": 0.32}, {"mass": 0.0052,
   "thickness": 0.0042, "mass_ratio": 0.23},
   {"mass": 0.0037, "thickness": 0.0031, "mass_ratio": 0.63}],
  "sections": [[5.1,4.6,4.1,3.9,4.4,3.6,4.0,4.8],[4.2,3.6,2.9,2.5,2.8,2.7,3.1,3.9],
  [2.6,2.0,1.3,1.1,1.6,1.2,1.4,2.1],
   [1.0,0.8,0.6,0.5,0.8,0.6,0.7,0.9],[0.4,0.35,0.3,0.25,0.33,0.28,0.31,0.36],
   [0.3,0.25,0.2,0.18,0.24,0.19,0.22,0.26],
   [0.8,0.7,0.6,0.5,0.6,0.55,0.6,0.7]]},
 "thermal": {"temperature_mean": {"Al2O3": 1147.2, "SrFeO3": 1145.05},
 "temperature_std": {"Al2O3": 6.1, "SrFeO3": 7.83},
   "biot_max": {"Al2O3": 0.04, "SrFeO3": 0.13}, "heat_to_walls": 1850.0},
 "chemistry": {"delta_initial": 0.3269, "delta_final": 0.4521, "delta_std": 0.0071,
 "oxygen_released": 0.00702,
   "oxygen_pumped": 0.0068, "extent": 0.88, "reaction_heat": 1180.0},
 "chamber": {"pressure_final": 1000.0, "time_to_setpoint": 74.7, "temperature_gas": 798.0},
 "heat_paths": {"contact": 420, "gap": 2300, "radiation": 1500, "to_walls": 1850, "reaction": 1180,
   "to_surroundings": 35, "gas": 210},
 "books": {"energy": {"stored at the start": 39000, "stored at the end": 35725,
 "to the walls": 1850, "reaction": 1180,
   "carried off with gas": 210, "out of the rig": 35}, "oxygen": {"bound at the start": 0.071,
   "released": 0.00702,
   "pumped": 0.0068, "in the chamber": 0.00022}, "particles": {"inserted": 3862, "alive": 3862,
   "lost": 0}},
 "balances": {"energy_relative": 3.1e-9, "oxygen_relative": 2.2e-13},
 "timing": {"fill": 21.0, "mix": 62.0, "react": 48.0, "radiation": 31.0, "output": 2.1}
})";

Surface revolved(const char* name, Vec3 origin, std::array<double, 4> rz, double facing) {
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
  c.models.reaction = true;
  c.chamber = ChamberCase{};
  c.chamber->pump = Pump{10.0, constant(4e-4), 10.0, 1000.0, 0.2};
  c.output.cut_point = Vec3::Zero();
  c.output.cut_normal = Vec3(0, -1, 0);
  return c;
}

}  // namespace

RunData synthetic_run(std::size_t particles, const std::string& name) {
  const auto bed = std::make_shared<Bed>(settle(particles));
  RunData run;
  run.name = name;
  run.header.case_text =
      "# made up\ntitle = \"</script><b>not bold</b>\"\n[run]\nname = \"" + name + "\"\n";
  run.header.species = {"Al2O3", "SrFeO3"};
  run.header.patches = {"chamber.side", "chamber.floor"};
  run.header.provenance = {{"version", "0.1.0"}};
  run.series = series_of();
  for (int k = 0; k <= 12; ++k) run.snapshot_times.push_back(0.05 * k);
  for (const double t : {settled, 2.0, 10.0, 60.0, 300.0, end}) run.snapshot_times.push_back(t);
  const std::vector<double> times = run.snapshot_times;
  run.snapshot = [bed, times](std::size_t index) { return snapshot_at(*bed, times.at(index)); };
  run.summary = parse_json(summary_text);
  run.setup = rig(bed->scale);
  gather_species(run);
  return run;
}

RunData mechanics_only(RunData run) {
  Value kept;
  for (const char* key : {"status", "mechanics", "provenance"})
    kept.set(key, *run.summary.find(key));
  run.summary = kept;
  run.setup.reset();
  std::vector<io::Column> columns;
  for (const io::Column& column : run.series.columns)
    if (column.name == "time" || column.name == "phase" || column.name == "kinetic_energy")
      columns.push_back(column);
  run.series.columns = columns;
  const auto hot = run.snapshot;
  run.snapshot = [hot](std::size_t index) {
    io::Snapshot snapshot = hot(index);
    for (double& t : snapshot.particles.temperature) t = 293.15;
    return snapshot;
  };
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
