#include "sim/summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "coupling/bed_gas.hpp"
#include "coupling/thermal_state.hpp"
#include "instruments/bed.hpp"
#include "instruments/course.hpp"
#include "instruments/mixing.hpp"
#include "instruments/section_ratios.hpp"
#include "io/atomic_file.hpp"
#include "io/series.hpp"
#include "physics/conduction.hpp"
#include "physics/mechanics.hpp"
#include "physics/upright.hpp"
#include "pmr/base/constants.hpp"
#include "sim/conductivity.hpp"
#include "sim/heat_paths.hpp"
#include "sim/ledger.hpp"
#include "sim/schedule.hpp"
#include "sim/summary_parts.hpp"

namespace pmr::sim {
namespace {

double wall_seconds(const Timings& timings) {
  double sum = 0.0;
  for (const auto& [stage, seconds] : timings.stages())
    if (stage.rfind("mechanics", 0) == 0) sum += seconds;
  return sum;
}

// The bed along gravity: over the floor of the decomposition tool, else over its own lowest point.
// NaN without particles.
struct BedShape {
  double height = std::nan("");          // [m]; NaN without gravity, too
  double solid_fraction = std::nan("");  // [1]; likewise
  double coordination = std::nan("");    // [1] contacts per particle
};
BedShape shape_of(const SummaryInput& in) {
  BedShape shape;
  if (in.state.particles.size() == 0) return shape;
  shape.coordination = instruments::coordination_number(in.state);
  const auto up = physics::up_against(in.setup.gravity);
  if (!up) return shape;
  const Particles bed = instruments::upright(in.state.particles, *up);
  const double floor = in.setup.decomposition ? in.setup.decomposition->axis_point.z()
                                              : instruments::lowest_point(bed);
  shape.height = instruments::bed_height(bed, Vec3(0.0, 0.0, floor));
  shape.solid_fraction = instruments::solid_fraction(bed, floor);
  return shape;
}

Json mechanics_of(const SummaryInput& in) {
  const State& state = in.state;
  Json particles = {{"total", state.opening.particles}};
  for (std::size_t s = 0; s < in.setup.species.size(); ++s)
    particles[in.setup.species[s].name] =
        instruments::species_figures(state.particles, static_cast<SpeciesIndex>(s)).count;
  const BedShape shape = shape_of(in);
  const double wall = wall_seconds(in.timings);
  const double particle_steps =
      static_cast<double>(state.step) * static_cast<double>(state.opening.particles);
  return {{"particles", particles},
          {"lost", state.lost.size()},
          {"steps", state.step},
          {"time_step", in.time_step},
          {"simulated", static_cast<double>(state.step) * in.time_step},
          {"settled_at", number(state.settled_at)},
          {"wall", wall},
          {"particle_steps_per_second", number(wall > 0.0 ? particle_steps / wall : 0.0)},
          {"max_overlap_ratio", state.extremes.overlap_ratio},
          {"max_speed", state.extremes.speed},
          {"kinetic_energy", physics::kinetic_energy(state.particles)},
          {"dissipated", state.fluxes.dissipated},
          {"bed_height", number(shape.height)},
          {"solid_fraction", number(shape.solid_fraction)},
          {"coordination_number", number(shape.coordination)}};
}

Json layer_of(const instruments::Layer& layer) {
  std::vector<double> ratios;
  for (const auto& sector : layer.sectors) ratios.push_back(sector.mass_ratio());
  return {{"mass", layer.mass},
          {"thickness", layer.thickness()},
          {"mass_ratio", number(layer.content.mass_ratio())},
          {"sector_mean_ratio", number(instruments::sector_mean(ratios))}};
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

// Mean count of a species over the sections of the layers [1].
double per_section(const instruments::BedSections& sections,
                   std::size_t instruments::Portion::*count) {
  double sum = 0.0, sectors = 0.0;
  for (const auto& layer : sections.layers)
    for (const auto& sector : layer.sectors) {
      sum += static_cast<double>(sector.*count);
      ++sectors;
    }
  return sum / sectors;
}

void add_deviation(const instruments::SectionRatios& ratios, const MixtureReference& reference,
                   Json& homogeneity) {
  const instruments::Deviation from = instruments::deviation(ratios, reference);
  homogeneity["mean_relative_deviation"] = number(from.mean);
  homogeneity["deviation"] = {{"reference", reference.name},
                              {"layers", numbers(from.layers)},
                              {"sections", numbers(from.sections)}};
}

Json homogeneity_of(const SummaryInput& in, const instruments::BedSections& sections) {
  const instruments::SectionRatios ratios = instruments::section_ratios(sections);
  const instruments::Asymmetry asymmetry = instruments::left_right_asymmetry(ratios);
  Json layers = Json::array(), rows = Json::array();
  for (const auto& layer : sections.layers) layers.push_back(layer_of(layer));
  for (const auto& row : ratios) rows.push_back(numbers(row));
  Json result = {
      {"layers", layers},
      {"sections", rows},
      {"sectors", in.setup.decomposition->sectors},
      {"residuum", layer_of(sections.residuum)},
      {"beads_per_section", number(per_section(sections, &instruments::Portion::beads))},
      {"granules_per_section", number(per_section(sections, &instruments::Portion::granules))},
      {"lacey_index", number(instruments::lacey_index(sections))},
      {"left_right_asymmetry",
       {{"mean", number(asymmetry.mean)},
        {"largest", number(asymmetry.largest)},
        {"layers", numbers(asymmetry.layers)}}}};
  if (in.setup.decomposition->reference)
    add_deviation(ratios, *in.setup.decomposition->reference, result);
  return result;
}

// Largest Biot number of a species, h R/(3 k) with h = 4 eps sigma T^3 of radiation alone and the
// conduction model's largest link left out: a lower bound named as such in the documentation.
double largest_biot(const Case& c, const State& state, std::size_t species) {
  const Material& material = c.materials.list[c.species[species].material];
  const double pressure = coupling::atmosphere(c, state).pressure;
  double largest = 0.0;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    if (state.particles.species[i] != species) continue;
    const double T = state.particles.temperature[i];
    const double film =
        4.0 * material.emissivity(T, state.particles.delta[i]) * stefan_boltzmann * T * T * T;
    largest = std::max(largest, film * state.particles.radius[i] / 3.0 /
                                    physics::conductivity(material.conductivity, T, pressure));
  }
  return largest;
}

Json thermal_of(const SummaryInput& in) {
  Json mean, deviation, biot, highest, highest_at, highest_std;
  for (std::size_t s = 0; s < in.setup.species.size(); ++s) {
    const auto figures =
        instruments::species_figures(in.state.particles, static_cast<SpeciesIndex>(s));
    const std::string& name = in.setup.species[s].name;
    mean[name] = number(figures.temperature.mean);
    deviation[name] = number(figures.temperature.deviation);
    biot[name] = largest_biot(in.setup, in.state, s);
    const auto peak = io::peak_of(in.series, "temperature_mean." + name);
    highest[name] = peak ? Json(peak->value) : Json(nullptr);
    highest_at[name] = peak ? Json(peak->time) : Json(nullptr);
    highest_std[name] =
        peak ? number(in.series.values("temperature_std." + name)[peak->row]) : Json(nullptr);
  }
  return {{"temperature_mean", mean},
          {"temperature_std", deviation},
          {"temperature_highest", highest},
          {"temperature_highest_at", highest_at},
          {"temperature_highest_std", highest_std},
          {"biot_max", biot},
          {"heat_to_walls", heat_paths(in.setup, in.state).to_walls}};
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Json books_of(const SummaryInput& in) {
  const State& state = in.state;
  const Fluxes& f = state.fluxes;
  double particles = 0.0, walls = 0.0;
  for (const double h : state.particles.enthalpy) particles += h;
  for (const double e : state.walls.cell_energy) walls += e;
  const Json energy = {{"at the start", state.opening.energy},
                       {"in particles", particles},
                       {"in walls", walls},
                       {"in the gas", state.gas.energy + total(state.gas.pore_energy)},
                       {"to the outside of walls", f.to_outside},
                       {"to the surroundings", f.to_surroundings},
                       {"out with gas", f.gas_energy_out},
                       {"in with gas", -f.gas_energy_in},
                       {"with lost particles", f.lost_energy}};
  const Json oxygen = {{"bound at the start", state.opening.oxygen},
                       {"bound at the end", coupling::bound_oxygen(in.setup, state.particles)},
                       {"released", f.oxygen_released},
                       {"to open air", f.oxygen_to_air},
                       {"pumped", f.oxygen_pumped},
                       {"closed in with air", f.oxygen_closed_in},
                       {"leaked in", f.oxygen_leaked},
                       {"in the gas", state.gas.oxygen + total(state.gas.pore_oxygen)}};
  const Json count = {{"inserted", state.opening.particles},
                      {"alive", state.particles.size()},
                      {"waiting", state.waiting.size()},
                      {"caught", state.caught.size()},
                      {"lost", state.lost.size()}};
  return {{"energy", energy},
          {"oxygen", oxygen},
          {"particles", count},
          {"species", species_books_of(in)}};
}

Json lost_of(const State& state) {
  Json lost = Json::array();
  for (const LostParticle& p : state.lost)
    lost.push_back({{"id", p.id},
                    {"time", p.time},
                    {"position", {p.position[0], p.position[1], p.position[2]}}});
  return lost;
}

Json assumed_of(const Case& c) {
  Json assumed = Json::array();
  const auto add = [&](const std::string& prefix, const Provenance& p) {
    if (p.mark != 'A') return;
    assumed.push_back({{"key", prefix + p.key}, {"value", p.value}, {"source", p.source}});
  };
  for (const Material& material : c.materials.list)
    for (const Provenance& p : material.provenance) add(material.name + ".", p);
  for (const Provenance& p : c.provenance) add("", p);
  return assumed;
}

// The last tracing. Pairs that no ray joined are left out: what a single ray carries is the
// cut-off.
Json radiation_of(const Exchange& exchange) {
  return {{"traced_at", number(exchange.traced_at)}, {"rays", exchange.rays},
          {"factors", exchange.factor.entries()},    {"relative_error", exchange.relative_error},
          {"row_sum_error", exchange.row_sum_error}, {"rays_given_up", exchange.unfinished}};
}

void add_heat(const SummaryInput& in, Json& summary) {
  const Balance balance = close_books(in.setup, in.state);
  summary["thermal"] = thermal_of(in);
  if (in.setup.models.reaction) summary["chemistry"] = chemistry_of(in);
  if (in.setup.chamber) {
    const auto gas = coupling::atmosphere(in.setup, in.state);
    summary["chamber"] = {{"pressure_final", gas.pressure},
                          {"time_to_setpoint", number(in.state.set_point_at)},
                          {"temperature_gas", gas.temperature},
                          {"oxygen_fraction", gas.oxygen_fraction}};
    const auto pores = coupling::pore_atmospheres(in.state);
    if (!pores.empty()) {
      summary["chamber"]["bed_pressure_bottom"] = pores.front().pressure;
      summary["chamber"]["bed_pressure_top"] = pores.back().pressure;
    }
  }
  summary["balances"] = {{"energy_relative", balance.energy_relative},
                         {"oxygen_relative", balance.oxygen_relative},
                         {"energy_residual", balance.energy_residual},
                         {"oxygen_residual", balance.oxygen_residual},
                         {"nitrogen_residual", balance.nitrogen_residual},
                         {"heat_exchanged", in.state.fluxes.heat_exchanged}};
  if (in.setup.models.radiation) summary["radiation"] = radiation_of(in.state.exchange);
  summary["heat_paths"] = heat_paths_of(in);
}

Json conductivity_of(const SummaryInput& in) {
  const BedConductivities measured = measure_conductivity(in.setup, in.state);
  Json points = Json::array();
  for (const BedConductivity& k : measured.points)
    points.push_back({{"temperature", k.temperature},
                      {"pressure", k.pressure},
                      {"conductivity", number(k.total())},
                      {"contact", number(k.contact)},
                      {"gap", number(k.gap)},
                      {"radiation", number(k.radiation)},
                      {"zehner_bauer_schluender", number(k.correlation)}});
  return {{"solid_fraction", measured.solid_fraction}, {"points", points}};
}

}  // namespace

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void write_summary(const std::filesystem::path& dir, const SummaryInput& in) {
  Json summary;
  summary["status"] = in.status;
  summary["case"] = {{"title", in.setup.title}, {"description", in.setup.description}};
  summary["provenance"] = in.provenance;
  summary["mechanics"] = mechanics_of(in);
  if (const auto sections = instruments::decompose(in.setup, in.state.particles))
    summary["homogeneity"] = homogeneity_of(in, *sections);
  add_bulk_tests(in, summary);
  if (has_heat(in.setup)) add_heat(in, summary);
  if (in.setup.conductivity && in.status == "completed" && in.state.particles.size() > 1)
    summary["effective_conductivity"] = conductivity_of(in);
  if (in.setup.models.reaction && in.setup.chamber && in.state.particles.size() > 0)
    summary["yield"] = yield_of(in);
  summary["books"] = books_of(in);
  summary["lost_particles"] = lost_of(in.state);
  summary["warnings"] = limits_touched(in.setup, in.state);
  summary["assumed"] = assumed_of(in.setup);
  for (const auto& [stage, seconds] : in.timings.stages()) summary["timing"][stage] = seconds;
  io::replace_text(dir / "summary.json", summary.dump(2) + '\n');
}

}  // namespace pmr::sim
