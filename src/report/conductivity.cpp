// The effective conductivity of the bed, where the run measured it.
#include <algorithm>
#include <cmath>

#include "report/colour_map.hpp"
#include "report/page.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

using Points = Value::Array;

std::vector<double> pressures_of(const Points& points) {
  std::vector<double> pressures;  // [Pa] in the case's order
  for (const Value& p : points)
    if (std::find(pressures.begin(), pressures.end(), p.number("pressure")) == pressures.end())
      pressures.push_back(p.number("pressure"));
  return pressures;
}

std::vector<double> column(const Points& points, double pressure, const char* key) {
  std::vector<double> values;
  for (const Value& p : points)
    if (p.number("pressure") == pressure) values.push_back(p.number(key));
  return values;
}

Value pressure_line(const Points& points, double pressure, const char* key,
                    const std::string& label, const std::string& colour, const char* dash) {
  Value line;
  line.set("label", label);
  line.set("colour", colour);
  if (*dash != 0) line.set("dash", dash);
  line.set("x", Value(column(points, pressure, "temperature")));
  line.set("y", Value(column(points, pressure, key)));
  return line;
}

Value spec_of(Value::Array lines) {
  Value x, y, spec;
  x.set("label", "temperature");
  x.set("unit", "K");
  y.set("label", "conductivity");
  y.set("unit", "W/m/K");
  spec.set("kind", "curves");
  spec.set("x", std::move(x));
  spec.set("y", std::move(y));
  spec.set("lines", std::move(lines));
  return spec;
}

std::string curves(const Points& points, double solid_fraction, Charts& charts) {
  Value::Array lines;
  std::size_t k = 0;
  for (const double pressure : pressures_of(points)) {
    const std::string colour = hex(species_colour(k++)),
                      at = with_unit(Quantity::pressure, pressure);
    lines.push_back(pressure_line(points, pressure, "conductivity", at, colour, ""));
    lines.push_back(pressure_line(points, pressure, "zehner_bauer_schluender",
                                  at + ", Zehner-Bauer-Schl\u00fcnder", colour, "5 4"));
  }
  return charts.add(
      "conductivity", "Effective conductivity of the bed", spec_of(std::move(lines)),
      "Hot plate above, cold plate below, all else insulated; heat flux and slope of "
      "the particles\u2019 temperatures in the bed\u2019s inside, of solid fraction " +
          fixed(solid_fraction, 3) + ".");
}

std::string paths(const Points& points, double pressure, std::size_t k, Charts& charts) {
  Value::Array lines;
  lines.push_back(pressure_line(points, pressure, "radiation", "radiation", "#d55e00", ""));
  lines.push_back(pressure_line(points, pressure, "gap", "gas gaps", "#56b4e9", ""));
  lines.push_back(pressure_line(points, pressure, "contact", "contacts", "#0072b2", ""));
  return charts.add("conductivity_paths_" + std::to_string(k),
                    "Its parts at " + with_unit(Quantity::pressure, pressure),
                    spec_of(std::move(lines)));
}

std::string ratios(const Points& points) {
  std::vector<std::vector<std::string>> rows;
  for (const Value& p : points)
    rows.push_back({with_unit(Quantity::pressure, p.number("pressure")),
                    with_unit(Quantity::temperature, p.number("temperature")),
                    fixed(p.number("conductivity"), 3), fixed(p.number("radiation"), 3),
                    fixed(p.number("gap"), 3), fixed(p.number("contact"), 4),
                    fixed(p.number("zehner_bauer_schluender"), 3),
                    fixed(p.number("conductivity") / p.number("zehner_bauer_schluender"), 2)});
  return table({"pressure", "temperature", "k [W/m/K]", "radiation", "gas gaps", "contacts",
                "Zehner-Bauer-Schl\u00fcnder", "ratio"},
               rows, "class=\"numbers\"");
}

}  // namespace

Section conductivity_section(const RunData& run, Charts& charts) {
  const Points& points = run.summary.items("effective_conductivity/points");
  std::string html = curves(points, run.summary.number("effective_conductivity/solid_fraction"),
                            charts),
              parts;
  std::size_t k = 0;
  for (const double pressure : pressures_of(points)) parts += paths(points, pressure, k++, charts);
  html += element("div", parts, "class=\"charts\"") + ratios(points);
  html += element(
      "p",
      "Why the ratio is not 1: the correlation lets heat by radiation pass through the solid of "
      "one "
      "unit cell only, with its emissivity in 2/\u03b5 \u2212 1, while rays in the bed fly past "
      "the "
      "nearest neighbours and are reflected; its contacts are flattened by a fixed share of the "
      "cross-section (0.77 %), ours by Hertz\u2019 law under the bed\u2019s own weight and the "
      "solid\u2019s "
      "true stiffness; and its spheres are not isothermal, ours are (Biot number), which raises "
      "k where radiation dominates.");
  return {"conductivity", "Effective conductivity", html};
}

}  // namespace pmr::report
