#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "instruments/bed.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::cli {
namespace {

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

// Part of the phase's longest course that is done [1]. Intervals of the react phase grow in
// proportion to its age, so that its work goes with the logarithm.
double part_done(const sim::Simulation& simulation) {
  const Case& c = simulation.setup();
  const State& state = simulation.state();
  if (state.phase == Phase::fill) return 1.0 + state.time / c.fill->duration;
  if (state.phase == Phase::mix) return state.time / c.mix->duration;
  if (state.phase == Phase::done) return 1.0;
  const double scale = c.react->first_interval / c.react->growth;
  const double done = state.time - state.settled_at, all = c.react->end - state.settled_at;
  return std::log1p(done / scale) / std::log1p(all / scale);
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

std::string Progress::line(const sim::Simulation& simulation) const {
  const double part = part_done(simulation);
  const double gained = part - phase_start_;
  const std::string eta = gained > 0.02 ? "  phase ends in at most " +
                                              clock(phase_clock_.seconds() * (1.0 - part) / gained)
                                        : "";
  return fmt::format("{:5} t = {:9.4f} s{}  elapsed {}{}", name_of(simulation.state().phase),
                     simulation.state().time, temperatures(simulation), clock(total_.seconds()),
                     eta);
}

void Progress::show(const sim::Simulation& simulation) {
  if (simulation.state().phase != phase_) {
    phase_ = simulation.state().phase;
    phase_start_ = part_done(simulation);
    phase_clock_ = {};
  } else if (shown_ && since_shown_.seconds() < (is_terminal_ ? 0.2 : 10.0)) {
    return;
  }
  since_shown_ = {};
  shown_ = true;
  std::fprintf(stderr, is_terminal_ ? "\r%-110s" : "%s\n", line(simulation).c_str());
  std::fflush(stderr);
}

Progress::~Progress() {
  if (is_terminal_ && shown_) std::fputc('\n', stderr);
}

}  // namespace pmr::cli
