#include "chemistry/chamber.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::chemistry {
namespace {

// 0 below x = 0, 1 above x = 1, with two continuous derivatives: 10 x^3 - 15 x^4 + 6 x^5.
double smooth_step(double x) {
  if (x <= 0.0) return 0.0;
  return x >= 1.0 ? 1.0 : x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

// max(x, 0) with the corner between 0 and w rounded: 2 x^2/w - x^3/w^2.
double smooth_positive(double x, double w) {
  if (x <= 0.0 || x >= w) return std::max(x, 0.0);
  return x * x / w * (2.0 - x / w);
}

// Opening of the control times p (1 - p_ult/p) [Pa].
double throttled(const Pump& pump, double pressure) {
  const double low = pump.set_point * (1.0 - control_band);
  const double width = 2.0 * control_band * pump.set_point;
  return smooth_step((pressure - low) / width) *
         smooth_positive(pressure - pump.ultimate, 0.01 * pump.ultimate);
}

}  // namespace

double gas_pressure(double amount, double T, double volume) {
  return amount * gas_constant * T / volume;
}

GasAmount air_in(const ChamberCase& chamber, double volume) {
  const double amount = chamber.pressure * volume / (gas_constant * chamber.gas_temperature);
  return {chamber.oxygen_fraction * amount, (1.0 - chamber.oxygen_fraction) * amount};
}

double pump_outflow(const ChamberCase& chamber, double pressure, double T, double time) {
  if (!chamber.pump || time < chamber.pump->start) return 0.0;
  if (chamber.vent && time >= chamber.vent->start) return 0.0;
  return chamber.pump->speed(pressure) * throttled(*chamber.pump, pressure) / (gas_constant * T);
}

double air_inflow(const ChamberCase& chamber, double pressure, double time) {
  const double fall = chamber.pressure - pressure;
  const bool is_vented = chamber.vent && time >= chamber.vent->start;
  return chamber.leak * std::max(0.0, fall) + (is_vented ? chamber.vent->conductance * fall : 0.0);
}

double pump_power(const ChamberCase& chamber, double outflow, double pressure) {
  if (!chamber.pump || pressure >= chamber.pressure) return 0.0;
  return outflow * gas_constant * chamber.gas_temperature * std::log(chamber.pressure / pressure) /
         chamber.pump->efficiency;
}

}  // namespace pmr::chemistry
