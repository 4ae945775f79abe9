// Section 4: what happened when.
#include "report/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

using Runs = std::vector<const RunData*>;

// One line of a chart: a column of the series, with an optional band between two others.
struct Line {
  std::string column, label, colour;
  std::string low, high;  // columns of the band, may be empty
};
struct Axis {
  const char* label;
  const char* unit;
  bool is_logarithmic = false;
  double factor = 1.0, offset = 0.0;  // shown = factor * SI + offset
};

constexpr const char* dashes[] = {"", "6 4", "2 3", "9 3 2 3", "1 5"};

// Difference quotient [unit/s]; nothing known in the first row and where time stands.
std::vector<double> slope(const std::vector<double>& time, const std::vector<double>& sum) {
  std::vector<double> rate(time.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 1; k < time.size(); ++k)
    if (time[k] > time[k - 1]) rate[k] = (sum[k] - sum[k - 1]) / (time[k] - time[k - 1]);
  return rate;
}

class Course {
 public:
  Course(const Runs& runs, Charts& charts) : runs_(runs), charts_(charts) {}

  // A chart of those lines that are there; if none is, one line that says why.
  std::string chart(const std::string& id, const std::string& title, const Axis& axis,
                    const std::vector<Line>& lines, const std::string& reason) {
    Value::Array drawn;
    for (const Line& line : lines)
      for (std::size_t r = 0; r < runs_.size(); ++r)
        if (has(r, line.column)) drawn.push_back(line_spec(r, line, lines.size() == 1));
    if (drawn.empty()) return absent(title + ": " + reason);
    Value spec;
    spec.set("kind", "course");
    spec.set("y", axis_spec(axis));
    spec.set("lines", std::move(drawn));
    if (runs_.size() == 1) spec.set("events", events(*runs_.front()));
    return charts_.add(id, title, std::move(spec));
  }

 private:
  // Columns that are made here: "rate of X", and "excess of X", its pressure over the chamber's.
  static bool is_rate(const std::string& column) { return column.rfind("rate of ", 0) == 0; }
  static bool is_excess(const std::string& column) { return column.rfind("excess of ", 0) == 0; }
  static std::string source(const std::string& column) {
    return is_rate(column) ? column.substr(8) : is_excess(column) ? column.substr(10) : column;
  }
  bool has(std::size_t r, const std::string& column) const {
    return runs_[r]->series.has(source(column)) && runs_[r]->series.rows() > 1;
  }

  std::string column(std::size_t r, const std::string& name) {
    const io::Series& series = runs_[r]->series;
    std::vector<double> values = thinned(series.values(source(name)));
    if (is_rate(name)) values = slope(thinned(series.values("time")), values);
    if (is_excess(name)) {
      const std::vector<double> chamber = thinned(series.values("pressure"));
      for (std::size_t k = 0; k < values.size(); ++k) values[k] -= chamber[k];
    }
    return charts_.column("run" + std::to_string(r + 1) + "." + name, values);
  }

  // With one line a chart, several runs take the species' colours instead of dashes.
  Value line_spec(std::size_t r, const Line& line, bool is_alone) {
    const bool is_compared = runs_.size() > 1;
    Value spec;
    spec.set("label", is_compared ? (is_alone ? runs_[r]->name : line.label + ", " + runs_[r]->name)
                                  : line.label);
    spec.set("colour", is_compared && is_alone ? hex(species_colour(r)) : line.colour);
    if (is_compared) spec.set("dash", dashes[r % std::size(dashes)]);
    spec.set("x", column(r, "time"));
    spec.set("y", column(r, line.column));
    if (!is_compared && !line.low.empty() && has(r, line.low) && has(r, line.high)) {
      spec.set("low", column(r, line.low));
      spec.set("high", column(r, line.high));
    }
    return spec;
  }

  static Value axis_spec(const Axis& axis) {
    Value spec;
    spec.set("label", axis.label);
    spec.set("unit", axis.unit);
    if (axis.is_logarithmic) spec.set("scale", "log");
    if (axis.factor != 1.0) spec.set("factor", axis.factor);
    if (axis.offset != 0.0) spec.set("offset", axis.offset);
    return spec;
  }

  static void add_event(Value::Array& events, double time, const char* label) {
    if (!std::isfinite(time)) return;
    Value event;
    event.set("t", time);
    event.set("label", label);
    events.push_back(std::move(event));
  }

  static Value events(const RunData& run) {
    Value::Array events;
    add_event(events, run.settled_time(), "at rest");
    if (run.setup && run.setup->chamber && run.setup->chamber->pump)
      add_event(events, run.setup->chamber->pump->start, "pump on");
    add_event(events, set_point_time(run), "set-point");
    return Value(std::move(events));
  }

  // First row at the set-point [s], on the clock of the run, within 0.1 %.
  static double set_point_time(const RunData& run) {
    if (!run.setup || !run.setup->chamber || !run.setup->chamber->pump ||
        !run.series.has("pressure"))
      return std::nan("");
    const auto& pressure = run.series.values("pressure");
    const auto& time = run.series.values("time");
    for (std::size_t row = 0; row < pressure.size(); ++row)
      if (pressure[row] > 0.0 && pressure[row] <= 1.001 * run.setup->chamber->pump->set_point)
        return time[row];
    return std::nan("");
  }

  const Runs& runs_;
  Charts& charts_;
};

std::vector<std::string> all_species(const Runs& runs) {
  std::vector<std::string> names;
  for (const RunData* run : runs)
    for (const std::string& name : run->header.species)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::string temperatures(const Runs& runs, Course& course) {
  std::vector<Line> lines;
  const auto names = all_species(runs);
  for (std::size_t s = 0; s < names.size(); ++s)
    lines.push_back({"temperature_mean." + names[s], chemical(names[s]), hex(species_colour(s)),
                     "temperature_p10." + names[s], "temperature_p90." + names[s]});
  lines.push_back({"gas_temperature", "gas", "#777777", "", ""});
  lines.push_back({"wall_temperature_mean", "wall faces, mean", "#8c564b", "", ""});
  const char* title =
      runs.size() > 1 ? "Temperatures, mean" : "Temperatures: mean, and band of 10 to 90 %";
  return course.chart("temperatures", title, {"temperature", "°C", false, 1.0, -273.15}, lines,
                      "no heat transfer in this case.");
}

std::string thermocouples(const Runs& runs, Course& course) {
  std::vector<Line> lines;
  for (const RunData* run : runs)
    for (const io::Column& column : run->series.columns)
      if (column.name.rfind("thermocouple.", 0) == 0 &&
          std::none_of(lines.begin(), lines.end(),
                       [&](const Line& l) { return l.column == column.name; }))
        lines.push_back(
            {column.name, column.name.substr(13), hex(species_colour(lines.size())), "", ""});
  if (lines.empty()) return "";
  return course.chart("thermocouples", "Thermocouples", {"temperature", "°C", false, 1.0, -273.15},
                      lines, "");
}

std::vector<Line> heat_lines(const std::string& prefix) {
  return {{prefix + "heat_radiation", "radiation", "#d55e00", "", ""},
          {prefix + "heat_contact", "contacts", "#0072b2", "", ""},
          {prefix + "heat_gap", "gas gaps", "#56b4e9", "", ""},
          {prefix + "heat_to_walls", "particles to walls", "#8c564b", "", ""},
          {prefix + "heat_reaction", "reaction", "#009e73", "", ""},
          {prefix + "heat_to_surroundings", "out of the rig", "#777777", "", ""}};
}

// Species whose delta any of the runs has followed.
std::vector<std::string> reactive_species(const Runs& runs) {
  std::vector<std::string> names = all_species(runs);
  std::erase_if(names, [&](const std::string& name) {
    return std::none_of(runs.begin(), runs.end(),
                        [&](const RunData* run) { return run->series.has("delta_mean." + name); });
  });
  return names;
}

std::string oxygen(const Runs& runs, Course& course) {
  const std::string none = "no reaction in this case.";
  const auto names = reactive_species(runs);
  std::vector<Line> delta{{"delta_mean", "δ, mean", "#0072b2", "delta_p10", "delta_p90"}};
  std::vector<Line> released{{"oxygen_released", "released by the solids", "#d55e00", "", ""},
                             {"oxygen_pumped", "pumped", "#0072b2", "", ""}};
  if (names.size() > 1) delta.clear();
  const auto all = all_species(runs);
  for (std::size_t s = 0; s < all.size() && names.size() > 1; ++s) {
    const std::string& name = all[s];  // columns that are not there draw nothing
    delta.push_back({"delta_mean." + name, "δ of " + chemical(name), hex(species_colour(s)),
                     "delta_p10." + name, "delta_p90." + name});
    released.push_back({"oxygen_released." + name, "released by " + chemical(name),
                        hex(species_colour(s)), "", ""});
  }
  std::string html = course.chart("delta", "Oxygen non-stoichiometry δ", {"δ", "1"}, delta, none);
  html += course.chart("oxygen_rate", "Oxygen given off, rate", {"rate", "mmol/s", false, 1e3},
                       {{"oxygen_rate", "O₂ from the solids", "#d55e00", "", ""}}, none);
  return html + course.chart("oxygen_sum", "Oxygen given off and pumped, sum",
                             {"amount O₂", "mmol", false, 1e3}, released, none);
}

std::string gas_and_heat(Course& course) {
  std::string html =
      course.chart("pressure", "Pressure in the chamber and its species", {"pressure", "Pa", true},
                   {{"pressure", "total", "#222222", "", ""},
                    {"oxygen_pressure", "O₂", "#d55e00", "", ""},
                    {"nitrogen_pressure", "N₂", "#0072b2", "", ""}},
                   "no closed chamber in this case.");
  html += course.chart("bed_pressure", "Pressure in the bed's pores", {"pressure", "Pa", true},
                       {{"pressure_bed_bottom", "lowest layer", "#222222", "", ""},
                        {"pressure_bed_top", "uppermost layer", "#999999", "", ""},
                        {"oxygen_pressure_bed_bottom", "O₂, lowest", "#d55e00", "", ""},
                        {"oxygen_pressure_bed_top", "O₂, uppermost", "#e69f00", "", ""}},
                       "the bed's gas was not resolved in this case.");
  html += course.chart("bed_overpressure", "Pressure in the bed over the chamber's",
                       {"pressure difference", "Pa"},
                       {{"excess of pressure_bed_bottom", "lowest layer", "#222222", "", ""},
                        {"excess of pressure_bed_top", "uppermost layer", "#999999", "", ""}},
                       "the bed's gas was not resolved in this case.");
  html += course.chart("heat", "Heat moved since the start, by path", {"heat", "kJ", false, 1e-3},
                       heat_lines(""), "no heat transfer in this case.");
  return html + course.chart("heat_flow", "Heat flow by path", {"heat flow", "W", true},
                             heat_lines("rate of "), "no heat transfer in this case.");
}

const char* toggle =
    "<div class=\"toggle\" role=\"group\" aria-label=\"time axis\"><span>time axis</span>"
    "<button data-time=\"linear\">linear</button><button data-time=\"log\">logarithmic</button>"
    "</div>";

}  // namespace

std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = (values.size() + most_rows - 1) / most_rows;
  if (stride <= 1) return values;
  std::vector<double> kept;
  for (std::size_t row = 0; row < values.size(); row += stride) kept.push_back(values[row]);
  if ((values.size() - 1) % stride != 0) kept.push_back(values.back());
  return kept;
}

std::string course_charts(const Runs& runs, Charts& charts) {
  Course course(runs, charts);
  const std::string html = temperatures(runs, course) + oxygen(runs, course) +
                           gas_and_heat(course) + thermocouples(runs, course) +
                           course.chart("kinetic_energy", "Kinetic energy of the particles",
                                        {"kinetic energy", "J", true},
                                        {{"kinetic_energy", "all particles", "#222222", "", ""}},
                                        "nothing moved in this run.");
  return toggle + element("div", html, "class=\"charts\"");
}

Section course_section(const RunData& run, Charts& charts) {
  if (run.series.rows() < 2)
    return {"course", "Course", absent("No course: this run holds no rows over time.")};
  return {"course", "Course", course_charts({&run}, charts)};
}

}  // namespace pmr::report
