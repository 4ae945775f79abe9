// What the instruments of bulk tests tell: caught masses, the heap, forces on walls.
#include <algorithm>
#include <cmath>

#include "instruments/catching.hpp"
#include "instruments/heap.hpp"
#include "pmr/base/constants.hpp"
#include "sim/summary_parts.hpp"

namespace pmr::sim {
namespace {

constexpr double degrees = 180.0 / pi;

Json catches_of(const SummaryInput& in) {
  Json all = Json::object();
  for (const instruments::Caught& one : instruments::caught_so_far(in.setup, in.state)) {
    Json masses = Json::object();
    for (std::size_t s = 0; s < in.setup.species.size(); ++s)
      masses[in.setup.species[s].name] = one.by_species[s];
    all[one.name] = {{"mass", one.mass}, {"masses", masses}};
    if (!one.threshold) continue;
    all[one.name]["threshold"] = *one.threshold;
    all[one.name]["time_to_threshold"] =
        one.time_to_threshold ? Json(*one.time_to_threshold) : Json();
  }
  return all;
}

Json heap_of(const SummaryInput& in) {
  const auto heap = instruments::measure_heap(in.state.particles, *in.setup.heap);
  if (!heap) return {{"angle", nullptr}, {"angle_scatter", nullptr}};
  return {{"angle", heap->angle * degrees},
          {"angle_scatter", number(heap->scatter * degrees)},
          {"sector_deviation", number(heap->sector_deviation * degrees)},
          {"height", heap->height},
          {"foot", heap->foot},
          {"reach", heap->reach},
          {"is_edged", heap->is_edged}};
}

// Over the rows in which the wall was felt, of equal weight.
Json force_of(const io::Series& series, const std::string& wall) {
  Json all = Json::object();
  for (const char* what : {"force", "torque"}) {
    double largest = std::nan("");
    std::vector<double> squares(series.rows(), 0.0);
    for (const char* axis : {"x", "y", "z"}) {
      const auto& values = series.values(std::string("wall_") + what + "." + wall + "." + axis);
      double sum = 0.0, count = 0.0;
      for (std::size_t k = 0; k < values.size(); ++k) {
        squares[k] += values[k] * values[k];
        if (!std::isfinite(values[k])) continue;
        sum += values[k];
        count += 1.0;
      }
      all[std::string(what) + "_" + axis] = number(sum / count);
    }
    for (const double square : squares)
      if (std::isfinite(square)) largest = std::fmax(largest, std::sqrt(square));
    all[std::string("largest_") + what] = number(largest);
  }
  return all;
}

}  // namespace

void add_bulk_tests(const SummaryInput& in, Json& summary) {
  if (!in.setup.catches.empty()) summary["catch"] = catches_of(in);
  if (in.setup.heap) summary["heap"] = heap_of(in);
  for (const WallForce& wall : in.setup.wall_forces)
    if (in.series.rows() > 0) summary["wall_force"][wall.name] = force_of(in.series, wall.name);
}

}  // namespace pmr::sim
