#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "instruments/bed.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::cli {
namespace {

constexpr double not_before = 2.0;  // [s] a run that is over by then needs no forecast

const char* name_of(Phase phase) {
  switch (phase) {
    case Phase::fill:
      return "fill";
    case Phase::mix:
      return "mix";
    case Phase::react:
      return "react";
    case Phase::done:
      break;
  }
  return "done";
}

double of_phase(const sim::Forecast& left, Phase phase) {  // [s]
  if (phase == Phase::fill) return left.fill.total();
  return phase == Phase::mix ? left.mix.total() : left.react.total();
}

std::string temperatures(const sim::Simulation& simulation) {
  std::string text;
  const auto& species = simulation.setup().species;
  for (std::size_t s = 0; s < species.size(); ++s) {
    const auto figures =
        instruments::species_figures(simulation.state().particles, static_cast<SpeciesIndex>(s));
    text +=
        fmt::format("  {} {:.1f} degC", species[s].name, figures.temperature.mean - zero_celsius);
  }
  return text;
}

std::string clock(double seconds) {
  const auto s = static_cast<long>(seconds);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

Progress::Progress() : is_terminal_(isatty(STDERR_FILENO) == 1) {}

// The phase that runs goes on as fast as it went, beside what was foreseen of it; those to come
// take what is foreseen.
std::string Progress::time_left(const sim::Simulation& simulation) const {
  const sim::Forecast left = sim::forecast_rest(simulation.setup(), costs_, simulation.state());
  const double now = of_phase(left, phase_), done = phase_work_ - now;
  const double speed = done > 0.05 * phase_work_ ? phase_clock_.seconds() / done : 1.0;
  return "  about " + clock(left.total() - now + speed * now) + " left";
}

std::string Progress::line(const sim::Simulation& simulation) const {
  return fmt::format("{:5} t = {:9.4f} s{}  elapsed {}{}", name_of(simulation.state().phase),
                     simulation.state().time, temperatures(simulation), clock(total_.seconds()),
                     time_left(simulation));
}

void Progress::begin_phase(const sim::Simulation& simulation) {
  phase_ = simulation.state().phase;
  phase_work_ =
      of_phase(sim::forecast_rest(simulation.setup(), costs_, simulation.state()), phase_);
  phase_clock_ = {};
}

void Progress::show(const sim::Simulation& simulation) {
  if (total_.seconds() < not_before) return;
  if (!shown_) costs_ = sim::measure_costs(simulation.setup());
  if (!shown_ || simulation.state().phase != phase_)
    begin_phase(simulation);
  else if (since_shown_.seconds() < (is_terminal_ ? 0.2 : 10.0))
    return;
  since_shown_ = {};
  shown_ = true;
  std::fprintf(stderr, is_terminal_ ? "\r%-110s" : "%s\n", line(simulation).c_str());
  std::fflush(stderr);
}

Progress::~Progress() {
  if (is_terminal_ && shown_) std::fputc('\n', stderr);
}

}  // namespace pmr::cli
