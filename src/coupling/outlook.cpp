#include "coupling/outlook.hpp"

#include <cmath>

namespace pmr::coupling {

Outlook look_ahead(const Case& c, const State& state, double ahead) {
  const Particles& p = state.particles;
  Outlook outlook{p.temperature, state.walls, atmosphere(c, state)};
  const Trend& trend = state.trend;
  if (!(trend.length > 0.0)) return outlook;
  const double part = ahead / trend.length;  // [1]
  for (std::size_t i = 0; i < p.size(); ++i)
    outlook.temperature[i] += part * trend.warming[p.id[i]];
  for (std::size_t k = 0; k < outlook.walls.cell_energy.size(); ++k)
    outlook.walls.cell_energy[k] += part * trend.heating[k];
  outlook.gas.pressure *= std::exp(part * trend.ln_pressure);
  return outlook;
}

TrendWatch::TrendWatch(const Case& c, const State& before)
    : temperature_(before.particles.temperature),
      cell_energy_(before.walls.cell_energy),
      pressure_(atmosphere(c, before).pressure) {}

void TrendWatch::set(const Case& c, double length, State& after) const {
  const Particles& p = after.particles;
  Trend& trend = after.trend;
  trend.length = length;
  const double pressure = atmosphere(c, after).pressure;
  trend.ln_pressure = pressure > 0.0 && pressure_ > 0.0 ? std::log(pressure / pressure_) : 0.0;
  trend.warming.assign(after.opening.particles, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    trend.warming[p.id[i]] = p.temperature[i] - temperature_[i];
  trend.heating = after.walls.cell_energy;
  for (std::size_t k = 0; k < cell_energy_.size(); ++k) trend.heating[k] -= cell_energy_[k];
}

}  // namespace pmr::coupling
