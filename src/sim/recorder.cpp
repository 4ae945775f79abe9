#include "sim/recorder.hpp"

#include <algorithm>
#include <limits>

#include "coupling/bed_gas.hpp"
#include "coupling/thermal_state.hpp"
#include "instruments/bed.hpp"
#include "instruments/catching.hpp"
#include "instruments/thermocouple.hpp"
#include "physics/adhered.hpp"
#include "physics/mechanics.hpp"
#include "sim/heat_paths.hpp"
#include "sim/ledger.hpp"
#include "sim/schedule.hpp"

namespace pmr::sim {
namespace {

// Appends one value to a named column, making the column on its first use.
class Row {
 public:
  explicit Row(io::Series& series) : series_(series) {}
  void put(const std::string& name, const std::string& unit, double value) {
    if (next_ == series_.columns.size()) series_.columns.push_back({name, unit, {}});
    series_.columns[next_++].values.push_back(value);
  }

 private:
  io::Series& series_;
  std::size_t next_ = 0;
};

void put_delta(const instruments::Spread& delta, const std::string& of, Row& row) {
  row.put("delta_mean" + of, "1", delta.mean);
  row.put("delta_p10" + of, "1", delta.low);
  row.put("delta_p90" + of, "1", delta.high);
}

// Each species by its name; what reacts also as a whole.
void put_species(const Case& c, const State& state, Row& row) {
  std::vector<bool> is_redox;
  for (const Species& species : c.species)
    is_redox.push_back(c.materials.list[species.material].redox.has_value());
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    const auto figures =
        instruments::species_figures(state.particles, static_cast<SpeciesIndex>(s));
    const std::string& name = c.species[s].name;
    row.put("temperature_mean." + name, "K", figures.temperature.mean);
    row.put("temperature_std." + name, "K", figures.temperature.deviation);
    row.put("temperature_p10." + name, "K", figures.temperature.low);
    row.put("temperature_p90." + name, "K", figures.temperature.high);
    if (is_redox[s]) put_delta(figures.delta, "." + name, row);
    if (is_redox[s]) row.put("oxygen_released." + name, "mol", state.breakdown.released[s]);
  }
  const auto kinds = std::count(is_redox.begin(), is_redox.end(), true);
  if (kinds > 0) put_delta(instruments::species_figures(state.particles, is_redox).delta, "", row);
}

void put_gas(const Case& c, const State& state, double oxygen_rate, Row& row) {
  if (!c.chamber) return;
  const auto air = coupling::atmosphere(c, state);
  row.put("pressure", "Pa", air.pressure);
  row.put("oxygen_pressure", "Pa", air.oxygen_fraction * air.pressure);
  row.put("nitrogen_pressure", "Pa", (1.0 - air.oxygen_fraction) * air.pressure);
  row.put("gas_temperature", "K", air.temperature);
  row.put("oxygen_released", "mol", state.fluxes.oxygen_released);
  row.put("oxygen_rate", "mol s-1", oxygen_rate);
  row.put("oxygen_pumped", "mol", state.fluxes.oxygen_pumped);
  if (!c.models.bed_gas) return;
  const auto pores = coupling::pore_atmospheres(state);  // none yet while particles move
  const auto& bottom = pores.empty() ? air : pores.front();
  const auto& top = pores.empty() ? air : pores.back();
  row.put("pressure_bed_bottom", "Pa", bottom.pressure);
  row.put("pressure_bed_top", "Pa", top.pressure);
  row.put("oxygen_pressure_bed_bottom", "Pa", bottom.oxygen_fraction * bottom.pressure);
  row.put("oxygen_pressure_bed_top", "Pa", top.oxygen_fraction * top.pressure);
}

void put_catches(const Case& c, const State& state, Row& row) {
  for (const instruments::Caught& caught : instruments::caught_so_far(c, state)) {
    row.put("catch." + caught.name, "kg", caught.mass);
    for (std::size_t s = 0; s < c.species.size(); ++s)
      row.put("catch." + caught.name + "." + c.species[s].name, "kg", caught.by_species[s]);
  }
}

void put_wall_forces(const Case& c, const std::vector<Wrench>& loads, Row& row) {
  const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  for (const WallForce& wall : c.wall_forces) {
    const Vec3 force = loads.empty() ? none : loads[wall.body].force;
    const Vec3 torque =
        loads.empty() ? none : Vec3(loads[wall.body].torque - wall.about.cross(force));
    const char* axes[] = {".x", ".y", ".z"};
    for (int k = 0; k < 3; ++k) row.put("wall_force." + wall.name + axes[k], "N", force[k]);
    for (int k = 0; k < 3; ++k) row.put("wall_torque." + wall.name + axes[k], "N m", torque[k]);
  }
}

// A bed that came to rest, and not one whose run ended in motion.
bool is_frozen(const Case& c, const State& state) {
  return state.phase == Phase::react || (state.phase == Phase::done && c.react);
}

double mean_wall_temperature(const std::vector<double>& faces, const coupling::Nodes& nodes) {
  double sum = 0.0, area = 0.0;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (nodes.columns[nodes.patches[k].surface].size() == 0) continue;
    sum += nodes.patches[k].area * faces[k];
    area += nodes.patches[k].area;
  }
  return sum / area;
}

}  // namespace

Recorder::Recorder(const Case& c, const coupling::Nodes& nodes, std::filesystem::path dir)
    : case_(c), nodes_(nodes), dir_(std::move(dir)) {}

void Recorder::add_row(const State& state, const std::vector<Wrench>& wall_loads) {
  Row row(rows_);
  const double passed = state.time - last_time_;
  const double rate = passed > 0.0 ? (state.fluxes.oxygen_released - last_released_) / passed : 0.0;
  last_time_ = state.time;
  last_released_ = state.fluxes.oxygen_released;
  row.put("time", "s", state.time);
  row.put("phase", "1", static_cast<double>(state.phase));
  row.put("kinetic_energy", "J",
          is_frozen(case_, state) ? 0.0 : physics::kinetic_energy(state.particles));
  put_catches(case_, state, row);
  put_wall_forces(case_, wall_loads, row);
  put_species(case_, state, row);
  put_gas(case_, state, rate, row);
  if (!has_heat(case_)) return;
  const Fluxes& f = state.fluxes;
  const HeatPaths paths = heat_paths(case_, state);
  row.put("heat_contact", "J", paths.contact);
  row.put("heat_gap", "J", paths.gap);
  row.put("heat_radiation", "J", paths.radiation);
  row.put("heat_to_walls", "J", paths.to_walls);
  row.put("heat_reaction", "J", f.reaction);
  row.put("heat_to_outside", "J", f.to_outside);
  row.put("heat_to_surroundings", "J", f.to_surroundings);
  const Balance balance = close_books(case_, state);
  row.put("energy_residual", "J", balance.energy_residual);
  row.put("oxygen_residual", "mol", balance.oxygen_residual);
  for (const Thermocouple& probe : case_.thermocouples) {
    const auto reading = instruments::read_thermocouple(probe, state.particles);
    const double none = std::numeric_limits<double>::quiet_NaN();  // nothing at its tip yet
    row.put("thermocouple." + probe.name, "K", reading.particles > 0 ? reading.temperature : none);
  }
  if (nodes_.cells > 0)
    row.put(
        "wall_temperature_mean", "K",
        mean_wall_temperature(coupling::patch_temperatures(case_, nodes_, state.walls), nodes_));
}

void Recorder::record(const State& state, bool takes_snapshot,
                      const std::vector<Wrench>& wall_loads) {
  add_row(state, wall_loads);
  if (takes_snapshot)
    snapshots_.push_back({state.time, state.phase, state.particles,
                          coupling::patch_temperatures(case_, nodes_, state.walls),
                          physics::adhered_places(case_.walls, state.time)});
}

void Recorder::start_from(const State& state) {
  last_time_ = state.time;
  last_released_ = state.fluxes.oxygen_released;
}

void Recorder::flush() {
  io::append_run(dir_, rows_, snapshots_);
  rows_ = {};
  snapshots_.clear();
}

void Recorder::checkpoint(const State& state) {
  flush();
  io::save_checkpoint(dir_, state);
  since_checkpoint_ = {};
}

}  // namespace pmr::sim
