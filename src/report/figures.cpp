#include "report/figures.hpp"

#include <algorithm>
#include <cmath>

#include "io/series.hpp"
#include "report/mixture_data.hpp"

namespace pmr::report {
namespace {

// Collects figures; those the run does not know are left out.
class Collector {
 public:
  explicit Collector(const RunData& run) : run_(run) {}

  void add(KeyFigure figure) {
    if (std::isfinite(figure.value)) figures_.push_back(std::move(figure));
  }
  void add_even_if_absent(KeyFigure figure) { figures_.push_back(std::move(figure)); }
  double number(std::string_view path) const { return run_.summary.number(path); }
  double last(const std::string& column) const {
    if (!run_.series.has(column) || run_.series.rows() == 0) return std::nan("");
    return run_.series.values(column).back();
  }
  // The band from 10 to 90 % of the particles at the end.
  std::string band(const std::string& low, const std::string& high, Quantity quantity) const {
    const double a = last(low), b = last(high);
    if (!std::isfinite(a) || !std::isfinite(b)) return "";
    return "10–90 %: " + show(quantity, a).number + " to " + with_unit(quantity, b);
  }
  const RunData& run() const { return run_; }
  std::vector<KeyFigure> take() { return std::move(figures_); }

 private:
  const RunData& run_;
  std::vector<KeyFigure> figures_;
};

Verdict below(double value, double limit) {
  return value <= limit ? Verdict::good : Verdict::attention;
}

// What users ask for first: how hot the granules became, when, how alike, and the oxygen's peak.
void add_peaks(Collector& c) {
  const RunData& run = c.run();
  if (run.species.empty()) return;
  if (const auto hottest = granules_hottest(run))
    c.add({"granule_highest",
           "Highest mean " + chemical(run.species[run.granules()].name) + " temperature",
           Quantity::temperature, hottest->mean,
           "after " + with_unit(Quantity::time, hottest->time) + ", ±" +
               with_unit(Quantity::temperature_difference, hottest->spread) + " among them"});
  const auto peak = io::peak_of(run.series, "oxygen_released");
  if (!run.reactive().empty() && peak && peak->value > 0.0)
    c.add({"peak", "Most oxygen that was off at a time", Quantity::specific_amount,
           c.number("yield/peak_per_kg"),
           "after " + with_unit(Quantity::time, peak->time) + "; nine tenths of it after " +
               with_unit(Quantity::time, c.number("yield/time_to_90"))});
}

void add_end_temperature(Collector& c) {
  const RunData& run = c.run();
  if (run.species.empty()) return;
  const std::string& name = run.species[run.granules()].name;
  c.add({"granule_temperature", "Mean " + chemical(name) + " temperature at the end",
         Quantity::temperature, c.number("thermal/temperature_mean/" + name),
         c.band("temperature_p10." + name, "temperature_p90." + name, Quantity::temperature)});
}

void add_end_oxygen(Collector& c) {
  const RunData& run = c.run();
  const auto reactive = run.reactive();
  if (reactive.empty()) return;
  const double released = c.number("chemistry/oxygen_released");  // [mol]
  c.add({"oxygen", "Oxygen off at the end", Quantity::specific_amount,
         released / run.reactive_mass(),
         with_unit(Quantity::amount, released) + " O₂; per kg " + names_of(run, reactive)});
}

void add_end_details(Collector& c) {
  const RunData& run = c.run();
  if (run.species.empty()) return;
  const std::string& name = run.species[run.granules()].name;
  c.add({"granule_spread", "Spread of it at the end (standard deviation)",
         Quantity::temperature_difference, c.number("thermal/temperature_std/" + name),
         "over all " + chemical(name) + " particles"});
  const auto reactive = run.reactive();
  if (reactive.empty()) return;
  const double from = c.number("chemistry/delta_initial");
  c.add({"delta", "Mean δ at the end", Quantity::delta, c.number("chemistry/delta_final"),
         std::isfinite(from) ? "from " + with_unit(Quantity::delta, from) : ""});
  if (reactive.size() < 2) return;
  for (const std::size_t s : reactive) {
    const std::string& one = run.species[s].name;
    const std::string path = "chemistry/species/" + one + "/";
    c.add({"delta." + one, "Mean δ of " + chemical(one) + " at the end", Quantity::delta,
           c.number(path + "delta_final"),
           "from " + with_unit(Quantity::delta, c.number(path + "delta_initial"))});
    c.add({"oxygen." + one, "Oxygen released by " + chemical(one), Quantity::specific_amount,
           c.number(path + "oxygen_per_kilogram"),
           with_unit(Quantity::amount, c.number(path + "oxygen_released")) + " O₂"});
  }
}

void add_set_point(Collector& c) {
  const RunData& run = c.run();
  if (!run.setup || !run.setup->chamber || !run.setup->chamber->pump) return;
  const auto& pump = *run.setup->chamber->pump;
  const double time = c.number("chamber/time_to_setpoint");
  const bool is_reached = std::isfinite(time);
  std::string note = "to " + with_unit(Quantity::pressure, pump.set_point);
  if (!is_reached) note += ", not reached in this run";
  note += "; pump starts at " + with_unit(Quantity::time, pump.start);
  c.add_even_if_absent({"set_point", "Time to set-point", Quantity::time, time, note,
                        is_reached ? Verdict::plain : Verdict::attention});
}

void add_books(Collector& c) {
  const double energy = c.number("balances/energy_relative");
  const double oxygen = c.number("balances/oxygen_relative");
  const bool has_oxygen = std::isfinite(oxygen);
  const bool closes =
      std::abs(energy) <= energy_limit && (!has_oxygen || std::abs(oxygen) <= oxygen_limit);
  std::string note = "limit 10⁻⁶";
  if (has_oxygen)
    note += "; oxygen " + with_unit(Quantity::residual, std::abs(oxygen)) + ", limit 10⁻⁷";
  c.add({"energy_books", "Books: energy residual", Quantity::residual, std::abs(energy), note,
         closes ? Verdict::good : Verdict::attention});
}

void add_mixture(Collector& c) {
  const MixtureData mixture = mixture_of(c.run());
  if (!mixture.layers.empty())
    c.add({"top_ratio", "Mass ratio w, top layer", Quantity::ratio, mixture.layers.front().whole,
           "bottom layer " + with_unit(Quantity::ratio, mixture.layers.back().whole)});
  c.add({"lacey", "Lacey mixing index", Quantity::ratio, c.number("homogeneity/lacey_index"),
         "0 apart, 1 at random"});
  c.add({"asymmetry", "Left–right asymmetry of the mixture", Quantity::share,
         mixture.asymmetry.mean, "mean over opposite sections, of their mean w"});
  if (mixture.deviation)
    c.add({"deviation", "Mean deviation from " + mixture.reference->name, Quantity::share,
           mixture.deviation->mean, "mean |1 − w/w_ref| over layers"});
}

void add_mechanics(Collector& c) {
  c.add({"lost", "Particles lost", Quantity::count, c.number("mechanics/lost"),
         "of " + with_unit(Quantity::count, c.number("mechanics/particles/total")),
         below(c.number("mechanics/lost"), 0.0)});
  c.add({"delay", "Delay between the valves", Quantity::time, release_delay(c.run()), ""});
  c.add({"settled", "Bed at rest", Quantity::time, c.run().settled_time(),
         "after the first valve's release"});
  c.add({"bed_height", "Bed height", Quantity::length, c.number("mechanics/bed_height"), ""});
  c.add({"solid_fraction", "Solid fraction", Quantity::ratio, c.number("mechanics/solid_fraction"),
         ""});
  c.add({"coordination", "Coordination number", Quantity::ratio,
         c.number("mechanics/coordination_number"), "contacts per particle"});
  const double overlap = c.number("mechanics/max_overlap_ratio");
  c.add({"overlap", "Largest overlap", Quantity::share, overlap,
         "of the smaller radius; limit " + with_unit(Quantity::share, overlap_limit),
         below(overlap, overlap_limit)});
  c.add({"rate", "Particle-steps per second", Quantity::count,
         c.number("mechanics/particle_steps_per_second"), ""});
}

void add_heat(Collector& c) {
  for (const Member& m : c.run().summary.members("thermal/temperature_mean"))
    c.add({"temperature." + m.key, "Mean " + chemical(m.key) + " temperature at the end",
           Quantity::temperature, m.value.as_number(), ""});
  c.add({"to_walls", "Heat to the walls", Quantity::energy, c.number("thermal/heat_to_walls"), ""});
  for (const Member& m : c.run().summary.members("thermal/biot_max"))
    c.add({"biot." + m.key, "Largest Biot number, " + chemical(m.key), Quantity::ratio,
           m.value.as_number(), "above 0.1 a sphere is not isothermal",
           below(m.value.as_number(), biot_limit)});
}

void add_reaction(Collector& c) {
  c.add({"delta_std", "Spread of δ (standard deviation)", Quantity::delta,
         c.number("chemistry/delta_std"), ""});
  c.add({"extent", "Extent of reaction", Quantity::share, c.number("chemistry/extent"), ""});
  c.add({"reaction_heat", "Heat taken up by the reaction", Quantity::energy,
         c.number("chemistry/reaction_heat"), ""});
  c.add({"pressure", "Pressure at the end", Quantity::pressure, c.number("chamber/pressure_final"),
         ""});
}

void add_yield(Collector& c) {
  c.add({"part_of_ideal", "The oxygen's peak over an ideal reactor's", Quantity::share,
         c.number("yield/part_of_ideal"),
         "the charge in one adiabatic piece at the set-point: " +
             with_unit(Quantity::specific_amount, c.number("yield/ideal_per_kg")) + " at " +
             with_unit(Quantity::temperature, c.number("yield/ideal_temperature"))});
  c.add({"reaction_over_heat", "Reaction heat over heat given by the inert charge", Quantity::share,
         c.number("yield/reaction_over_heat"), ""});
  c.add({"mean_pressure", "Mean pressure from the pump's start", Quantity::pressure,
         c.number("yield/mean_pressure"), ""});
  c.add({"pump_work", "Pump work", Quantity::energy, c.number("yield/pump_work"),
         "isothermal compression over the pump's efficiency"});
}

void drop_repeated_temperature(std::vector<KeyFigure>& figures, const std::string& granules) {
  std::erase_if(figures, [&](const KeyFigure& f) { return f.id == "temperature." + granules; });
}

}  // namespace

std::optional<HottestMoment> granules_hottest(const RunData& run) {
  constexpr double noticed = 0.05;  // [K] what is shown
  if (run.species.empty() || !run.summary.has("thermal")) return std::nullopt;
  const std::string& name = run.species[run.granules()].name;
  const auto peak = io::peak_of(run.series, "temperature_mean." + name);
  if (!peak) return std::nullopt;
  const std::string deviation = "temperature_std." + name;
  const double spread =
      run.series.has(deviation) ? run.series.values(deviation)[peak->row] : std::nan("");
  const double first = run.series.values("temperature_mean." + name).front();
  return HottestMoment{peak->time, peak->value, spread, peak->value > first + noticed};
}

std::vector<KeyFigure> key_figures(const RunData& run) {
  Collector c(run);
  add_peaks(c);
  add_end_temperature(c);
  add_end_oxygen(c);
  add_set_point(c);
  add_books(c);
  add_end_details(c);
  add_mixture(c);
  add_mechanics(c);
  add_heat(c);
  add_reaction(c);
  add_yield(c);
  std::vector<KeyFigure> figures = c.take();
  if (!run.species.empty()) drop_repeated_temperature(figures, run.species[run.granules()].name);
  return figures;
}

bool is_worth_listing(const KeyFigure& figure, const RunData& run) {
  const bool is_limit = figure.id == "overlap" || figure.id.rfind("biot.", 0) == 0;
  return figure.verdict == Verdict::attention && !(is_limit && run.summary.has("warnings"));
}

std::string names_of(const RunData& run, const std::vector<std::size_t>& species) {
  std::vector<std::string> names;
  for (const std::size_t s : species) names.push_back(chemical(run.species[s].name));
  return join(names, " and ");
}

std::string chemical(std::string_view name) {
  static constexpr const char* lowered[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool is_digit = name[i] >= '0' && name[i] <= '9';
    const bool follows_letter = i > 0 && ((name[i - 1] >= 'a' && name[i - 1] <= 'z') ||
                                          (name[i - 1] >= 'A' && name[i - 1] <= 'Z'));
    text += is_digit && follows_letter ? lowered[name[i] - '0'] : std::string(1, name[i]);
  }
  return text;
}

}  // namespace pmr::report
