// pmr check: what a case comes to, before it is run.
#include <fmt/format.h>

#include <algorithm>

#include "case/extents.hpp"
#include "cli/console.hpp"
#include "cli/start.hpp"
#include "cli/verbs.hpp"
#include "coupling/nodes.hpp"
#include "coupling/thermal_state.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"
#include "sim/forecast.hpp"

namespace pmr::cli {
namespace {

std::string grouped(std::size_t value) {
  std::string text = std::to_string(value);
  for (auto k = static_cast<std::ptrdiff_t>(text.size()) - 3; k > 0; k -= 3)
    text.insert(static_cast<std::size_t>(k), ",");
  return text;
}

// "2.99 mm", or "2.1 to 3.9 mm (Sauter 2.99 mm)".
std::string sizes_of(const Species& species) {
  const double smallest = smallest_diameter(species), largest = largest_diameter(species);
  if (smallest == largest) return fmt::format("{:.4g} mm", 1e3 * smallest);
  return fmt::format("{:.4g} to {:.4g} mm (Sauter {:.4g} mm)", 1e3 * smallest, 1e3 * largest,
                     1e3 * species.diameter);
}

std::size_t print_species(const Case& c) {
  std::size_t total = 0;
  for (const Species& species : c.species) {
    const Material& material = c.materials.list[species.material];
    fmt::print("{:12} {:>9} particles of {}, {:.6g} kg in all, {:.1f} degC", species.name,
               grouped(species.count), sizes_of(species), material.density * solid_volume(species),
               species.initial_temperature - zero_celsius);
    if (material.redox) fmt::print(", delta {:.4f}", coupling::initial_delta(c, species));
    fmt::print("\n");
    total += species.count;
  }
  fmt::print("{:12} {:>9} particles\n", "total", grouped(total));
  return total;
}

std::string minutes(double seconds) { return fmt::format("{:.2g} min", seconds / 60.0); }

void print_forecast(const Case& c) {
  const sim::Forecast f = sim::forecast(c, sim::measure_costs(c));
  const auto sum = [&](double sim::StageTimes::*stage) {
    return minutes(f.fill.*stage + f.mix.*stage + f.react.*stage);
  };
  fmt::print("forecast     about {} steps, {} of output; {} on this machine's {} cores\n",
             grouped(static_cast<std::size_t>(f.steps)), fmt::format("{:.2g} MB", 1e-6 * f.bytes),
             minutes(f.total()), ThreadLimit::current());
  fmt::print("             mechanics {}, tracing {}, conductances {}, network {}, output {}\n",
             sum(&sim::StageTimes::mechanics), sum(&sim::StageTimes::tracing),
             sum(&sim::StageTimes::links), sum(&sim::StageTimes::network),
             sum(&sim::StageTimes::output));
}

}  // namespace

int check(const std::filesystem::path& case_file, const std::vector<std::string>& sets) {
  const Start start = read_start(case_file, sets);
  const Case& c = start.setup;
  fmt::print("{}\n", c.title);
  for (const std::string& warning : c.warnings) fmt::print("warning      {}\n", warning);
  if (start.bed) fmt::print("bed          {}\n", start.bed->description);
  const std::size_t particles = print_species(c);
  const auto step = physics::time_step(c);
  fmt::print("time step    {:.4g} us = {:.1f} % of Rayleigh (smallest {:.4g} us, {})\n",
             1e6 * step.step, 100.0 * step.fraction, 1e6 * step.smallest_rayleigh, step.species);
  fmt::print("contact      {:.0f} steps in a Hertz contact at 1 m/s\n",
             step.hertz_contact_time / step.step);
  const auto nodes = coupling::number_nodes(c, particles);
  fmt::print("walls        {} bodies, {} surfaces, {} heat patches, {} wall cells\n",
             c.walls.bodies.size(), c.walls.surfaces.size(), nodes.patches.size(), nodes.cells);
  for (std::size_t body = 0; body < c.walls.bodies.size(); ++body)
    fmt::print("  {:10} {}\n", c.walls.bodies[body].name,
               casefile::to_text(casefile::extent_of(c.walls, body)));
  if (!c.walls.grains.empty())
    fmt::print("adhered      {} grains on walls\n", grouped(c.walls.grains.size()));
  const auto assumed = std::count_if(c.provenance.begin(), c.provenance.end(),
                                     [](const Provenance& p) { return p.mark == 'A'; });
  fmt::print("sources      {} figures of the case, {} of them assumed\n", c.provenance.size(),
             assumed);
  print_forecast(c);
  return done;
}

}  // namespace pmr::cli
