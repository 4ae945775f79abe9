// What the instruments of bulk tests saw: the heap's flank, what was caught, forces on walls.
#include <cmath>

#include "instruments/heap.hpp"
#include "pmr/base/constants.hpp"
#include "report/colour_map.hpp"
#include "report/course.hpp"
#include "report/page.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

Value axis(const char* label, const char* unit, double factor) {
  Value made;
  made.set("label", label);
  made.set("unit", unit);
  if (factor != 1.0) made.set("factor", factor);
  return made;
}

Value line(const std::string& label, const std::string& colour, const char* dash,
           const std::vector<double>& x, const std::vector<double>& y) {
  Value made;
  made.set("label", label);
  made.set("colour", colour);
  if (*dash != 0) made.set("dash", dash);
  made.set("x", Value(x));
  made.set("y", Value(y));
  return made;
}

std::string heap_of(const RunData& run, Charts& charts) {
  if (run.snapshot_times.empty()) return absent("No heap: this run holds no snapshots.");
  const auto& tool = *run.setup->heap;
  const io::Snapshot last = run.snapshot(run.snapshot_times.size() - 1);
  const auto heap = instruments::measure_heap(last.particles, tool);
  if (!heap) return absent("No heap with a flank whose angle could be measured.");
  constexpr double degrees = 180.0 / pi, millimetres = 1e3;
  std::vector<double> radius, top, low, high;
  for (const instruments::HeapRing& ring : heap->rings) {
    radius.push_back(ring.radius * millimetres);
    top.push_back(ring.top * millimetres);
    low.push_back((ring.top - ring.deviation) * millimetres);
    high.push_back((ring.top + ring.deviation) * millimetres);
  }
  const double summit = heap->foot * std::tan(heap->angle);
  Value::Array lines;
  lines.push_back(line("tops, mean round the ring", hex(species_colour(0)), "", radius, top));
  lines.push_back(line("one standard deviation up", hex(species_colour(0)), "2 3", radius, high));
  lines.push_back(line("and down", hex(species_colour(0)), "2 3", radius, low));
  lines.push_back(line("fitted flank", "#d55e00", "6 4", {0.0, heap->foot * millimetres},
                       {summit * millimetres, 0.0}));
  Value spec;
  spec.set("kind", "curves");
  spec.set("x", axis("distance from the axis", "mm", 1.0));
  spec.set("y", axis("height over the base", "mm", 1.0));
  spec.set("lines", std::move(lines));
  std::string caption = "Angle of repose " + fixed(heap->angle * degrees, 2) + " \u00b1 " +
                        fixed(heap->scatter * degrees, 2) + " deg (standard error over " +
                        std::to_string(tool.sectors) + " sectors).";
  if (heap->is_edged) caption += " The heap reaches the rim of its base: it is no free heap.";
  return charts.add("heap", "The heap\u2019s flank", std::move(spec), caption);
}

// A chart over time of columns of the series.
std::string course(const RunData& run, Charts& charts, const std::string& id,
                   const std::string& title, const Value& y,
                   const std::vector<std::string>& columns) {
  Value::Array lines;
  std::size_t k = 0;
  const std::string time = charts.column("run1.time", thinned(run.series.values("time")));
  for (const std::string& name : columns) {
    Value made;
    made.set("label", name);
    made.set("colour", hex(species_colour(k++)));
    made.set("x", time);
    made.set("y", charts.column("run1." + name, thinned(run.series.values(name))));
    lines.push_back(std::move(made));
  }
  Value spec;
  spec.set("kind", "course");
  spec.set("y", y);
  spec.set("lines", std::move(lines));
  spec.set("events", Value(Value::Array()));
  return charts.add(id, title, std::move(spec));
}

std::string catches_of(const RunData& run, Charts& charts) {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  for (const Member& one : run.summary.members("catch")) {
    columns.push_back("catch." + one.key);
    const double time = one.value.number("time_to_threshold");
    const double threshold = one.value.number("threshold");
    rows.push_back({escape(one.key), with_unit(Quantity::mass, one.value.number("mass")),
                    std::isfinite(threshold) ? with_unit(Quantity::mass, threshold) : "\u2013",
                    std::isfinite(time)        ? with_unit(Quantity::time, time)
                    : std::isfinite(threshold) ? "not reached"
                                               : "\u2013"});
  }
  return course(run, charts, "catch", "Caught so far", axis("mass", "g", 1e3), columns) +
         table({"opening", "caught", "threshold", "reached at"}, rows, "class=\"numbers\"");
}

std::string forces_of(const RunData& run, Charts& charts) {
  std::vector<std::string> columns;
  for (const WallForce& wall : run.setup->wall_forces)
    for (const char* axis_name : {".x", ".y", ".z"})
      columns.push_back("wall_force." + wall.name + axis_name);
  return course(run, charts, "wall_force", "Forces on walls", axis("force", "N", 1.0), columns);
}

}  // namespace

bool has_bulk_tests(const RunData& run) {
  return run.setup && run.series.rows() > 1 &&
         (run.setup->heap || !run.setup->catches.empty() || !run.setup->wall_forces.empty());
}

Section bulk_tests_section(const RunData& run, Charts& charts) {
  std::string html;
  if (run.setup->heap) html += heap_of(run, charts);
  if (!run.setup->catches.empty()) html += catches_of(run, charts);
  if (!run.setup->wall_forces.empty()) html += forces_of(run, charts);
  return {"bulk-tests", "Bulk tests", element("div", html, "class=\"charts\"")};
}

}  // namespace pmr::report
