// The chamber's gas, its pump, and the models' numerics.
#include <algorithm>
#include <functional>
#include <limits>

#include "case/parts.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

// A constant, or a curve over the pressure at the inlet.
pmr::Table read_speed(Table& pump) {
  const Want speed{Dimension::flow, positive};
  const Node* node = pump.look("speed");
  if (node == nullptr || node->find("pressure") == nullptr)
    return constant(pump.value("speed", speed));
  Table curve(pump.reading(), *node, pump.path("speed"));
  const pmr::Table rows{curve.values("pressure", {Dimension::pressure, positive}),
                        curve.values("speed", speed)};
  if (rows.x.size() != rows.y.size()) curve.fault("speed", "wanted as many speeds as pressures");
  if (std::adjacent_find(rows.x.begin(), rows.x.end(), std::greater_equal<>()) != rows.x.end())
    curve.fault("pressure", "wanted rising pressures");
  return rows.x.empty() || rows.x.size() != rows.y.size() ? constant(1.0) : rows;
}

std::optional<Pump> read_pump(Table& chamber) {
  const Node* node = chamber.look_table(chamber.moves_nothing("pump"));
  if (node == nullptr) return std::nullopt;
  Table table(chamber.reading(), *node, chamber.path("pump"));
  Pump pump{};
  pump.start = table.value("start", a_time);
  pump.speed = read_speed(table);
  pump.ultimate = table.value("ultimate", a_pressure);
  pump.set_point = table.value("set_point", {Dimension::pressure, positive});
  pump.efficiency = table.value("efficiency", {Dimension::none, {0, 1, true}}, 0.2);
  if (pump.set_point < pump.ultimate)
    table.fault("set_point", "wanted at least the ultimate pressure");
  return pump;
}

std::optional<Vent> read_vent(Table& chamber) {
  const Node* node = chamber.look_table(chamber.moves_nothing("vent"));
  if (node == nullptr) return std::nullopt;
  Table table(chamber.reading(), *node, chamber.path("vent"));
  return Vent{table.value("start", a_time),
              table.value("conductance", {Dimension::leak, positive})};
}

// A model is a table, or true (all defaults), or false or missing (off).
const Node* model(Table& models, const std::string& key, const Node& defaults) {
  const Node* node = models.look(key);
  if (node == nullptr || node->is_table()) return node;
  return models.flag(key, false) ? &defaults : nullptr;
}

// A law that has a name and no figures; without the key it stays what it is.
template <class Law>
void read_bare_law(Table& table, const std::string& key, Law& law) {
  if (table.look(key) != nullptr) choose_law(table, key, law, [&](auto named) { law = named; });
}

MechanicsModel read_mechanics(Table& models) {
  const Node defaults;
  const Node* node = models.look_table("mechanics");
  Table table(models.reading(), node == nullptr ? defaults : *node, models.path("mechanics"));
  MechanicsModel mechanics{};
  const Node* step = table.look("time_step");
  if (step != nullptr && !(step->kind == Node::Kind::string && step->text == "auto"))
    mechanics.time_step = table.value("time_step", a_duration);
  mechanics.allows_long_step = table.flag("allow_long_time_step", false);
  mechanics.allowed_losses = table.count(table.moves_nothing("allowed_losses"), 0, 0);
  mechanics.impact_speed = table.maybe("impact_speed", {Dimension::speed, positive});
  mechanics.fraction_of_rayleigh =
      table.value("fraction_of_rayleigh", {Dimension::none, {0, 1, true}}, 0.189);
  mechanics.skin = table.value("skin", a_positive_number, 0.3);
  read_bare_law(table, "contact", mechanics.contact.force);
  read_bare_law(table, "rolling", mechanics.contact.rolling);
  return mechanics;
}

ConductionModel read_conduction(Table& models, const Node& node) {
  Table table(models.reading(), node, models.path("conduction"));
  ConductionModel conduction{};
  conduction.contact = table.flag("contact", true);
  conduction.gap = table.flag("gap", true);
  conduction.gap_reach = table.value("gap_reach", {Dimension::none, {0, 2, true}}, 0.5);
  conduction.bed_solid_fraction =
      table.value("bed_solid_fraction", {Dimension::none, {0, 0.74, true}}, 0.6);
  conduction.shells = table.count("shells", 1, 1);
  if (table.has("contact_law") &&
      table.choice("contact_law", {"batchelor-obrien", "liggghts"}) == "liggghts")
    conduction.contact_law = ContactConduction::liggghts;
  if (table.has("contact_area") && table.choice("contact_area", {"real", "soft"}) == "soft")
    conduction.contact_area = ContactArea::of_soft_contact;
  return conduction;
}

RadiationModel read_radiation(Table& models, const Node& node) {
  Table table(models.reading(), node, models.path("radiation"));
  const Want rays{Dimension::none, {1.0, 1.0e7}};
  RadiationModel radiation{};
  radiation.rays_moving = table.value("rays_moving", rays, 16.0);
  radiation.rays_settled = table.value("rays_settled", rays, 320.0);
  radiation.retrace_interval = table.value("retrace_interval", a_duration, 0.05);
  radiation.retrace_displacement = table.value("retrace_displacement", a_positive_number, 0.05);
  radiation.emissivity_change = table.value("emissivity_change", a_positive_number, 0.005);
  radiation.emissivity_change_traced =
      table.value("emissivity_change_traced", a_positive_number, 0.05);
  radiation.surroundings = table.value("surroundings", a_temperature);
  if (table.has("law") && table.choice("law", {"traced", "environment"}) == "environment")
    radiation.law = RadiationLaw::environment;
  return radiation;
}

BedGasModel read_bed_gas(Table& models, const Node& node) {
  Table table(models.reading(), node, models.path("bed_gas"));
  return {table.count("layers", 1, 12),
          table.value("tortuosity", {Dimension::none, {1.0, 10.0}}, 1.5)};
}

NetworkModel read_network(Table& models) {
  const Node defaults;
  const Node* node = models.look_table(models.moves_nothing("network"));
  Table table(models.reading(), node == nullptr ? defaults : *node, models.path("network"));
  NetworkModel network{};
  network.relative_tolerance =
      table.value("relative_tolerance", {Dimension::none, {0, 0.1, true}}, 1.0e-4);
  network.temperature_tolerance =
      table.value("temperature_tolerance", {Dimension::temperature_difference, positive}, 1.0e-3);
  network.delta_tolerance = table.value("delta_tolerance", {Dimension::none, {0, 0.1, true}}, 1e-6);
  return network;
}

}  // namespace

double read_closing(Table& root) {
  const Node* node = root.look_table("chamber");
  const Node* closing = node == nullptr ? nullptr : node->find("closing");
  if (closing == nullptr) return infinity;
  const Node* figure = closing->is_table() ? closing->find("value") : closing;
  if (figure == nullptr || figure->kind != Node::Kind::string) return infinity;
  const Quantities read = root.reading().units.parse(figure->text, Dimension::time);
  if (read.values.size() != 1) return infinity;  // read_chamber tells the fault
  return read.values.front();
}

std::optional<ChamberCase> read_chamber(Table& root, const std::optional<Rig>& rig,
                                        bool rig_is_faulty) {
  const Node* node = root.look_table("chamber");
  if (node == nullptr) return std::nullopt;
  Table table(root.reading(), *node, "chamber");
  ChamberCase chamber{};
  const Want volume{Dimension::volume, positive};
  chamber.closing = table.value("closing", a_time, infinity);
  const bool is_closed = table.has("closing");
  table.moves_nothing("volume");
  if (!is_closed)
    chamber.volume = table.value("volume", volume, std::numeric_limits<double>::quiet_NaN());
  else if (rig)
    chamber.volume = table.value("volume", volume, rig->size.chamber_volume());
  else if (rig_is_faulty)
    table.maybe("volume", volume);
  else
    chamber.volume = table.value("volume", volume);
  chamber.pressure = table.value(table.moves_nothing("pressure"), {Dimension::pressure, positive});
  chamber.oxygen_fraction = table.value(table.moves_nothing("oxygen_fraction"), a_fraction);
  chamber.gas_temperature =
      table.value(table.moves_nothing("gas_temperature"), a_state_temperature);
  chamber.film_coefficient = table.value(table.moves_nothing("film_coefficient"),
                                         {Dimension::film_coefficient, not_negative});
  chamber.leak = table.value(table.moves_nothing("leak"), {Dimension::leak, not_negative});
  chamber.pump = read_pump(table);
  chamber.vent = read_vent(table);
  if (chamber.vent && chamber.vent->start < chamber.closing)
    table.fault("vent", "wanted a start after the closing");
  if (chamber.pump && chamber.pump->start < chamber.closing)
    table.fault("closing", "the pump starts before the chamber is closed");
  return chamber;
}

Models read_models(Table& root) {
  const Node defaults;
  const Node* node = root.look_table("models");
  Table table(root.reading(), node == nullptr ? defaults : *node, "models");
  Models models{};
  models.mechanics = read_mechanics(table);
  if (const Node* on = model(table, table.moves_nothing("conduction"), defaults); on != nullptr)
    models.conduction = read_conduction(table, *on);
  if (const Node* on = model(table, table.moves_nothing("radiation"), defaults); on != nullptr)
    models.radiation = read_radiation(table, *on);
  models.reaction = table.flag(table.moves_nothing("reaction"), false);
  if (const Node* on = model(table, table.moves_nothing("bed_gas"), defaults); on != nullptr) {
    models.bed_gas = read_bed_gas(table, *on);
    if (root.look("chamber") == nullptr) table.fault("bed_gas", "the bed's gas wants [chamber]");
  }
  models.mechanics_only = table.flag(table.moves_nothing("mechanics_only"), false);
  models.network = read_network(table);
  return models;
}

}  // namespace pmr::casefile
