#include "chemistry/chamber.hpp"

#include <algorithm>

#include "pmr/base/constants.hpp"

namespace pmr::chemistry {
namespace {

struct Smooth {
  double value;  // [1]
  double slope;  // [1]
};

// 0 below x = 0, 1 above x = 1, with two continuous derivatives: 10 x^3 - 15 x^4 + 6 x^5.
Smooth smooth_step(double x) {
  if (x <= 0.0) return {0.0, 0.0};
  if (x >= 1.0) return {1.0, 0.0};
  return {x * x * x * (10.0 + x * (6.0 * x - 15.0)), 30.0 * x * x * (1.0 - x) * (1.0 - x)};
}

// max(x, 0) with the corner between 0 and w rounded: 2 x^2/w - x^3/w^2.
Smooth smooth_positive(double x, double w) {
  if (x <= 0.0) return {0.0, 0.0};
  if (x >= w) return {x, 1.0};
  const double y = x / w;
  return {x * y * (2.0 - y), y * (4.0 - 3.0 * y)};
}

// Opening of the control times p (1 - p_ult/p) [Pa], and its slope [1].
Smooth throttled(const Pump& pump, double pressure) {
  const double low = pump.set_point * (1.0 - control_band);
  const double width = 2.0 * control_band * pump.set_point;
  const Smooth opening = width > 0.0 ? smooth_step((pressure - low) / width) : Smooth{1.0, 0.0};
  const Smooth drive = smooth_positive(pressure - pump.ultimate, 0.01 * pump.ultimate);
  const double opening_slope = width > 0.0 ? opening.slope / width : 0.0;
  return {opening.value * drive.value, opening_slope * drive.value + opening.value * drive.slope};
}

}  // namespace

double gas_pressure(double amount, double T, double volume) {
  return amount * gas_constant * T / volume;
}

GasAmount air_in(const ChamberCase& chamber, double volume) {
  const double amount = chamber.pressure * volume / (gas_constant * chamber.gas_temperature);
  return {chamber.oxygen_fraction * amount, (1.0 - chamber.oxygen_fraction) * amount};
}

double pump_outflow(const Pump& pump, double pressure, double T, double time) {
  if (time < pump.start) return 0.0;
  return pump.speed * throttled(pump, pressure).value / (gas_constant * T);
}

double pump_outflow_slope(const Pump& pump, double pressure, double T, double time) {
  if (time < pump.start) return 0.0;
  return pump.speed * throttled(pump, pressure).slope / (gas_constant * T);
}

double leak_inflow(const ChamberCase& chamber, double pressure) {
  return chamber.leak * std::max(0.0, chamber.pressure - pressure);
}

}  // namespace pmr::chemistry
