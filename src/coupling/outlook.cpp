#include "coupling/outlook.hpp"

#include <cmath>

namespace pmr::coupling {

Outlook look_ahead(const Case& c, const State& state, double ahead) {
  const Particles& p = state.particles;
  Outlook outlook{p.temperature, state.walls, atmosphere(c, state), pore_atmospheres(state)};
  const Trend& trend = state.trend;
  if (!(trend.length > 0.0)) return outlook;
  const double part = ahead / trend.length;  // [1]
  for (std::size_t i = 0; i < p.size(); ++i)
    outlook.temperature[i] += part * trend.warming[p.id[i]];
  for (std::size_t k = 0; k < outlook.walls.cell_energy.size(); ++k)
    outlook.walls.cell_energy[k] += part * trend.heating[k];
  outlook.gas.pressure *= std::exp(part * trend.ln_pressure);
  for (std::size_t k = 0; k < trend.ln_pore_pressure.size(); ++k)
    outlook.pores[k].pressure *= std::exp(part * trend.ln_pore_pressure[k]);
  return outlook;
}

TrendWatch::TrendWatch(const Case& c, const State& before)
    : temperature_(before.particles.temperature),
      cell_energy_(before.walls.cell_energy),
      pressure_(atmosphere(c, before).pressure),
      pores_(pore_atmospheres(before)) {}

void TrendWatch::set(const Case& c, double length, State& after) const {
  const Particles& p = after.particles;
  Trend& trend = after.trend;
  trend.length = length;
  const double pressure = atmosphere(c, after).pressure;
  trend.ln_pressure = pressure > 0.0 && pressure_ > 0.0 ? std::log(pressure / pressure_) : 0.0;
  trend.ln_pore_pressure.clear();
  const auto pores = pore_atmospheres(after);
  for (std::size_t k = 0; k < pores.size(); ++k)
    trend.ln_pore_pressure.push_back(std::log(pores[k].pressure / pores_[k].pressure));
  trend.warming.assign(after.opening.particles, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    trend.warming[p.id[i]] = p.temperature[i] - temperature_[i];
  trend.heating = after.walls.cell_energy;
  for (std::size_t k = 0; k < cell_energy_.size(); ++k) trend.heating[k] -= cell_energy_[k];
}

}  // namespace pmr::coupling
