#include "physics/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact_law.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::physics {
namespace {

void narrow(TimeStepReport& report, const Case& c, const Species& species, double radius) {
  const Material& m = c.materials.list[species.material];
  const double shear = m.young_soft / (2.0 * (1.0 + m.poisson_soft));
  const double critical = rayleigh_step(radius, m.density, shear, m.poisson_soft);
  if (critical < report.smallest_rayleigh) {
    report.smallest_rayleigh = critical;
    report.species = species.name;
  }
  const double mass = m.density * 4.0 / 3.0 * pi * radius * radius * radius;
  const HertzPair like{0.5 * mass, 0.5 * radius, effective_young(m, m)};
  report.hertz_contact_time = std::min(report.hertz_contact_time, hertz_contact_time(like, 1.0));
}

}  // namespace

double rayleigh_step(double radius, double density, double shear_modulus, double poisson) {
  return pi * radius * std::sqrt(density / shear_modulus) / (0.1631 * poisson + 0.8766);
}

double hertz_peak_overlap(const HertzPair& p, double speed) {
  return std::pow(15.0 * p.reduced_mass * speed * speed /
                      (16.0 * p.effective_young * std::sqrt(p.reduced_radius)),
                  0.4);
}

double hertz_peak_force(const HertzPair& p, double speed) {
  return 4.0 / 3.0 * p.effective_young * std::sqrt(p.reduced_radius) *
         std::pow(hertz_peak_overlap(p, speed), 1.5);
}

double hertz_contact_time(const HertzPair& p, double speed) {
  const double c = 0.8 * std::sqrt(pi) * std::tgamma(0.4) / std::tgamma(0.9);
  return c * hertz_peak_overlap(p, speed) / speed;
}

TimeStepReport time_step(const Case& c) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TimeStepReport report{0.0, infinity, 0.0, "", infinity};
  for (const Species& species : c.species)
    if (const double d = smallest_diameter(species); d > 0.0) narrow(report, c, species, 0.5 * d);
  for (const ExplicitParticle& p : c.particles)
    if (p.radius) narrow(report, c, c.species[p.species], *p.radius);
  const MechanicsModel& model = c.models.mechanics;
  double automatic = model.fraction_of_rayleigh * report.smallest_rayleigh;
  if (model.impact_speed)  // the duration goes with the speed to the power of -1/5
    automatic = std::min(automatic, report.hertz_contact_time *
                                        std::pow(*model.impact_speed, -0.2) / steps_of_a_contact);
  report.step = model.time_step.value_or(automatic);
  report.fraction = report.step / report.smallest_rayleigh;
  return report;
}

std::string time_step_fault(const Case& c) {
  const TimeStepReport report = time_step(c);
  if (c.models.mechanics.allows_long_step || !(report.fraction > largest_fraction)) return "";
  return fmt::format(
      "{:.4g} us are {:.0f} % of the Rayleigh step of {}; wanted at most {:.0f} %, {:.4g} us, or "
      "allow_long_time_step = true",
      1e6 * report.step, 100.0 * report.fraction, report.species, 100.0 * largest_fraction,
      1e6 * largest_fraction * report.smallest_rayleigh);
}

}  // namespace pmr::physics
