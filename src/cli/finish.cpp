#include "cli/finish.hpp"

#include <fmt/format.h>

#include "cli/console.hpp"
#include "cli/log.hpp"
#include "cli/machine.hpp"
#include "instruments/bed.hpp"
#include "instruments/course.hpp"
#include "io/run_file.hpp"
#include "io/series.hpp"
#include "pmr/base/constants.hpp"
#include "report/report.hpp"
#include "sim/ledger.hpp"
#include "sim/schedule.hpp"
#include "sim/summary.hpp"
#include "sim/verdict.hpp"

namespace pmr::cli {
namespace {

void summarise(const sim::Simulation& simulation, const RunRecord& record,
               const std::string& status, const io::Series& series) {
  auto provenance = record.provenance;
  provenance["state_hash"] = hexadecimal(io::state_hash(simulation.state()));
  sim::write_summary(record.folder,
                     {simulation.setup(), simulation.state(), simulation.nodes(),
                      simulation.timings(), series, simulation.time_step(), status, provenance});
}

// "SrFeO3   3475 particles, hottest on average 812.3 degC (+- 7.8 K) at 8.3 s; at the end ...".
std::string heat_line(const Case& c, const Particles& particles, SpeciesIndex s,
                      const io::Series& series) {
  const auto figures = instruments::species_figures(particles, s);
  const std::string& name = c.species[s].name;
  std::string text = fmt::format("{:8} {} particles", name, figures.count);
  if (!sim::has_heat(c)) return text;
  if (const auto peak = io::peak_of(series, "temperature_mean." + name))
    text += fmt::format(", hottest on average {:.1f} degC (+- {:.1f} K) at {:.4g} s",
                        peak->value - zero_celsius,
                        series.values("temperature_std." + name)[peak->row], peak->time);
  return text + fmt::format("; at the end {:.1f} degC (+- {:.1f} K)",
                            figures.temperature.mean - zero_celsius, figures.temperature.deviation);
}

void print_oxygen(const State& state, const io::Series& series) {
  std::string most;
  if (const auto peak = io::peak_of(series, "oxygen_released"); peak && peak->value > 0.0)
    most = fmt::format("at most {:.4g} mol off, at {:.4g} s; ", peak->value, peak->time);
  log_info(fmt::format("oxygen   {}{:.4g} mol at the end, {:.4g} kJ of reaction heat", most,
                       state.fluxes.oxygen_released, 1e-3 * state.fluxes.reaction));
}

// Species that give off oxygen come first: they are what a run is about.
void print_headline(const sim::Simulation& simulation, const sim::Balance& balance,
                    const io::Series& series) {
  const Case& c = simulation.setup();
  const State& state = simulation.state();
  for (const bool is_redox : {true, false})
    for (std::size_t s = 0; s < c.species.size(); ++s)
      if (c.materials.list[c.species[s].material].redox.has_value() == is_redox)
        log_info(heat_line(c, state.particles, static_cast<SpeciesIndex>(s), series));
  if (c.models.reaction) print_oxygen(state, series);
  if (sim::has_heat(c))
    log_info(fmt::format("books    energy {:.1e}, oxygen {:.1e}", balance.energy_relative,
                         balance.oxygen_relative));
  log_info(fmt::format("counts   {} particles, {} alive, {} lost, {} yet to come", balance.inserted,
                       balance.alive, balance.lost, balance.waiting));
  const auto& work = simulation.network_work();
  if (work.steps > 0)
    log_info(fmt::format("network  {} steps, {} Newton and {} Krylov iterations", work.steps,
                         work.newton, work.krylov));
  log_info("state    " + hexadecimal(io::state_hash(state)));
}

}  // namespace

int finish_run(const sim::Simulation& simulation, const RunRecord& record, sim::Ending ending) {
  const sim::Balance balance = sim::close_books(simulation.setup(), simulation.state());
  const bool completed = ending == sim::Ending::completed;
  const auto reasons = sim::reasons_to_fail(simulation.setup(), simulation.state());
  const io::Series series = io::read_series(record.folder);
  summarise(simulation, record,
            !reasons.empty() ? "failed"
            : completed      ? "completed"
                             : "stopped",
            series);
  instruments::write_instruments(record.folder, simulation.setup(), series, simulation.state());
  print_headline(simulation, balance, series);
  if (completed) {
    report::write_report({record.folder}, record.folder / "report.html");
    log_info("report   " + (record.folder / "report.html").string());
  }
  for (const std::string& reason : reasons) log_error(reason);
  if (!reasons.empty()) return failed;
  if (completed) return done;
  log_info("interrupted; go on with: pmr resume " + record.folder.string());
  return interrupted;
}

int finish_failed(const sim::Simulation& simulation, const RunRecord& record,
                  const std::string& why) {
  log_error(why);
  summarise(simulation, record, "failed", io::read_series(record.folder));
  log_info("the last interval before it is saved; see it again with: pmr resume " +
           record.folder.string());
  return failed;
}

int finish_unsaved(const std::filesystem::path& folder, const std::string& why) {
  log_error(why);
  log_error(
      io::has_checkpoint(folder)
          ? "what was saved before stands; once the disk can be written, go on with: pmr resume " +
                folder.string()
          : "nothing was saved that could be gone on from; begin again with: pmr run");
  return failed;
}

}  // namespace pmr::cli
