// Section 5: the books. Where the energy went, the oxygen, the particles; and whether it adds up.
#include <algorithm>
#include <cmath>

#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/page.hpp"

namespace pmr::report {
namespace {

// Builds nodes and links of a flow diagram; links that carry nothing are left out.
class Flow {
 public:
  explicit Flow(double smallest) : smallest_(smallest) {}

  void node(const char* id, const std::string& label, const std::string& colour, int column) {
    Value node;
    node.set("id", id);
    node.set("label", label);
    node.set("colour", colour);
    node.set("column", column);
    nodes_.push_back(std::move(node));
  }
  void link(const char* from, const char* to, double size, const char* label, const char* colour) {
    if (!(size > smallest_)) return;
    Value link;
    link.set("from", from);
    link.set("to", to);
    link.set("value", size);
    link.set("label", label);
    link.set("colour", colour);
    links_.push_back(std::move(link));
  }
  bool is_empty() const { return links_.empty(); }
  Value spec(const char* unit) {
    Value spec;
    spec.set("kind", "flow");
    spec.set("unit", unit);
    spec.set("nodes", std::move(nodes_));
    spec.set("links", std::move(links_));
    return spec;
  }

 private:
  double smallest_;
  Value::Array nodes_, links_;
};

// Who gave heat to whom: inert species to the reactive ones, or the hottest to all others.
struct Roles {
  std::vector<std::size_t> givers, receivers;  // species
};
Roles roles_of(const RunData& run) {
  Roles roles;
  for (std::size_t s = 0; s < run.species.size(); ++s)
    (run.species[s].is_reactive ? roles.receivers : roles.givers).push_back(s);
  if (!roles.givers.empty() && !roles.receivers.empty()) return roles;
  roles = {{*run.hottest()}, {}};
  for (std::size_t s = 0; s < run.species.size(); ++s)
    if (s != *run.hottest()) roles.receivers.push_back(s);
  return roles;
}

struct HeatPaths {
  double contact, gap, radiation;             // [J] beads to granules
  double walls, reaction, surroundings, gas;  // [J] out of the bed
  double beads;                               // [J] given by the beads in all
  double exchanged() const { return contact + gap + radiation; }
  double lost() const {
    return std::max(0.0, walls) + std::max(0.0, surroundings) + std::max(0.0, gas);
  }
};

HeatPaths heat_paths(const RunData& run) {
  const auto path = [&](const char* key) {
    const double heat = run.summary.number(std::string("heat_paths/") + key);
    return std::isfinite(heat) ? heat : 0.0;
  };
  HeatPaths h{path("contact"),   path("gap"),
              path("radiation"), path("to_walls"),
              path("reaction"),  path("to_surroundings"),
              path("gas"),       0.0};
  for (const std::size_t s : roles_of(run).givers)
    h.beads += run.species[s].first_enthalpy - run.species[s].last_enthalpy;
  h.beads = std::max(h.beads, h.exchanged());
  return h;
}

void link_losses(Flow& flow, const char* from, double share, const HeatPaths& h) {
  flow.link(from, "walls", share * h.walls, "to the walls", "#8c564b");
  flow.link(from, "gas", share * h.gas, "with gas and oxygen", "#56b4e9");
  flow.link(from, "surroundings", share * h.surroundings, "radiated out of the rig", "#999999");
}

// Beads give to granules by three paths, and directly to what surrounds them; the granules pass on
// what is neither taken up by the reaction nor stored.
Flow energy_flow(const RunData& run, const HeatPaths& h) {
  Flow flow(1e-4 * h.beads);
  const Roles roles = roles_of(run);
  const std::string receivers = names_of(run, roles.receivers);
  const std::size_t hot = roles.givers.front(), cold = roles.receivers.front();
  flow.node("beads", names_of(run, roles.givers) + " gave off", hex(species_colour(hot)), 0);
  flow.node("granules", "through the " + receivers, hex(species_colour(cold)), 1);
  if (h.reaction < 0.0) flow.node("oxidation", "re-oxidation gave", "#009e73", 0);
  flow.node("stored", "warmer granules", hex(species_colour(cold)), 2);
  flow.node("reaction", "reaction", "#009e73", 2);
  flow.node("walls", "walls", "#8c564b", 2);
  flow.node("gas", "gas", "#56b4e9", 2);
  flow.node("surroundings", "surroundings", "#999999", 2);
  flow.link("beads", "granules", h.radiation, "radiation", "#d55e00");
  flow.link("beads", "granules", h.contact, "contacts", "#0072b2");
  flow.link("beads", "granules", h.gap, "gas gaps", "#56b4e9");
  flow.link("oxidation", "granules", -h.reaction, "re-oxidation", "#009e73");
  const double direct = std::min(h.beads - h.exchanged(), h.lost());
  const double from_beads = h.lost() > 0.0 ? direct / h.lost() : 0.0;
  const double stored = h.exchanged() - h.reaction - (1.0 - from_beads) * h.lost();
  if (stored < 0.0) flow.node("cooled", receivers + " gave off", hex(species_colour(cold)), 0);
  flow.link("cooled", "granules", -stored, "granules' own heat", "#0072b2");
  // In the order in which they leave and arrive, so that ribbons don't cross.
  flow.link("granules", "stored", stored, "stored", "#0072b2");
  flow.link("granules", "reaction", h.reaction, "reaction", "#009e73");
  link_losses(flow, "granules", 1.0 - from_beads, h);
  link_losses(flow, "beads", from_beads, h);
  return flow;
}

std::string energy_chart(const RunData& run, Charts& charts) {
  if (!run.summary.has("heat_paths")) return absent("No flow of energy: no heat transfer here.");
  if (!run.hottest())
    return absent("No flow of energy: all species began at the same temperature.");
  const Roles roles = roles_of(run);
  if (std::find(roles.givers.begin(), roles.givers.end(), *run.hottest()) == roles.givers.end())
    return absent("No flow of energy: the species that react began as the hottest.");
  const HeatPaths h = heat_paths(run);
  const double hardly = 1e-4 * std::abs(run.species[*run.hottest()].first_enthalpy);  // [J]
  if (!(h.exchanged() > hardly))
    return absent("No flow of energy: the two species exchanged next to nothing.");
  Flow flow = energy_flow(run, h);
  return charts.add(
      "energy", "Where the heat went", flow.spec("J"),
      "Paths, reaction and walls are integrals of their own fluxes; what the beads gave "
      "off is their change of enthalpy. Losses are shared out between the species by "
      "what the beads gave beyond their exchange with the granules.");
}

std::string book(const RunData& run, const std::string& key, const std::string& title,
                 Quantity quantity) {
  const auto& entries = run.summary.members("books/" + key);
  if (entries.empty()) return "";
  double largest = 0.0;
  for (const Member& m : entries) largest = std::max(largest, std::abs(m.value.as_number()));
  std::vector<std::vector<std::string>> rows;
  for (const Member& m : entries) {
    const double share = largest > 0.0 ? std::abs(m.value.as_number()) / largest : 0.0;
    rows.push_back({escape(m.key), with_unit(quantity, m.value.as_number()),
                    "<i class=\"meter\" style=\"width:" +
                        std::to_string(std::lround(100.0 * share)) + "%\"></i>"});
  }
  return element("div", element("h3", title) + table({}, rows, "class=\"numbers book\""));
}

std::string residual(const char* name, double value, double limit, const char* of) {
  if (!std::isfinite(value)) return "";
  const bool closes = std::abs(value) <= limit;
  return element(
      "p",
      std::string(closes ? "<b class=\"badge\">ok</b>" : "<b class=\"badge\">attention</b>") +
          name + " closes to <strong>" + with_unit(Quantity::residual, std::abs(value)) +
          "</strong> of " + of + " (limit " + with_unit(Quantity::residual, limit) + ").",
      closes ? "class=\"residual good\"" : "class=\"residual attention\"");
}

std::string residuals(const RunData& run) {
  std::string html = residual("Energy", run.summary.number("balances/energy_relative"),
                              energy_limit, "the heat and gas turned over") +
                     residual("Oxygen", run.summary.number("balances/oxygen_relative"),
                              oxygen_limit, "the oxygen turned over");
  const double lost = run.summary.number("mechanics/lost");
  if (lost == 0.0)
    html += element("p", "<b class=\"badge\">ok</b>Every particle is accounted for.",
                    "class=\"residual good\"");
  if (lost > 0.0)
    html += element("p",
                    "<b class=\"badge\">attention</b>" + with_unit(Quantity::count, lost) +
                        " particles left the domain; the log names each with its place.",
                    "class=\"residual attention\"");
  return html;
}

}  // namespace

Section books_section(const RunData& run, Charts& charts) {
  std::string html = residuals(run);
  if (!run.species.empty()) html += energy_chart(run, charts);
  const std::string tables = book(run, "energy", "Energy", Quantity::energy) +
                             book(run, "oxygen", "Oxygen (as O₂)", Quantity::amount) +
                             book(run, "particles", "Particles", Quantity::count);
  if (!tables.empty()) html += element("div", tables, "class=\"books\"");
  if (html.empty()) html = absent("No books: the summary of this run holds none.");
  return {"books", "Books", html};
}

}  // namespace pmr::report
