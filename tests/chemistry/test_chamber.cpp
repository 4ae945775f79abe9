// Pump, control and leak.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/chamber.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::chemistry;

namespace {
const Pump pump{10.0, 4e-3, 5.0, 1000.0};  // start, speed, ultimate, set-point
constexpr double T = 300.0, volume = 5e-3;

// Pressure after `duration` from `pressure`, constant T, `inflow` [mol/s]; Runge-Kutta of order 4.
double evacuate(const Pump& p, double pressure, double duration, double inflow) {
  const auto rate = [&](double now) {
    return gas_pressure(inflow - pump_outflow(p, now, T, p.start), T, volume);
  };
  constexpr int steps = 40000;
  const double h = duration / steps;
  for (int k = 0; k < steps; ++k) {
    const double k1 = rate(pressure), k2 = rate(pressure + 0.5 * h * k1);
    const double k3 = rate(pressure + 0.5 * h * k2), k4 = rate(pressure + h * k3);
    pressure += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return pressure;
}
}  // namespace

TEST_CASE("the pump never blows, is still before its start and stops at its ultimate pressure") {
  Pump free = pump;
  free.set_point = 0.0;
  for (const Pump& p : {pump, free})
    for (double pressure = -10.0; pressure < 2e5; pressure += 0.37 + 0.01 * std::abs(pressure)) {
      CHECK(pump_outflow(p, pressure, T, 10.0) >= 0.0);
      CHECK(pump_outflow(p, pressure, T, 9.999) == 0.0);
    }
  CHECK(pump_outflow(free, 5.0, T, 20.0) == 0.0);
  CHECK(pump_outflow(free, 4.0, T, 20.0) == 0.0);
  CHECK(pump_outflow(free, 6.0, T, 20.0) == Approx(4e-3 * 1.0 / (gas_constant * T)).epsilon(1e-14));
}

TEST_CASE("the outflow's slope is that of its differences, and it has no corner") {
  for (const double pressure : {5.01, 5.049, 996.0, 1000.0, 1004.0, 5e4}) {
    const double h = 1e-5;
    const double slope =
        (pump_outflow(pump, pressure + h, T, 20.0) - pump_outflow(pump, pressure - h, T, 20.0)) /
        (2.0 * h);
    CHECK(pump_outflow_slope(pump, pressure, T, 20.0) == Approx(slope).epsilon(1e-5));
  }
  for (const double corner : {5.0, 5.05, 995.0, 1005.0}) {
    const double before = pump_outflow_slope(pump, corner - 1e-9, T, 20.0);
    const double after = pump_outflow_slope(pump, corner + 1e-9, T, 20.0);
    CHECK(after == Approx(before).epsilon(1e-6).margin(1e-9));
  }
}

TEST_CASE("an empty chamber is evacuated along its exponential") {
  Pump free = pump;
  free.set_point = 0.0;
  // p = p_ult + (p0 - p_ult) exp(-S t/V); Runge-Kutta's error is below 1e-12 at these steps.
  const double expected = 5.0 + (1e5 - 5.0) * std::exp(-4e-3 * 5.0 / volume);
  CHECK(evacuate(free, 1e5, 5.0, 0.0) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("the control holds the set-point within its band while gas comes in") {
  for (const double inflow : {0.0, 1e-6, 1e-4, 1e-3})
    CHECK(evacuate(pump, 1e5, 60.0, inflow) == Approx(1000.0).epsilon(control_band));
}

TEST_CASE("air leaks in until the pressures are equal, and never out") {
  ChamberCase chamber{};
  chamber.pressure = 1e5;
  chamber.oxygen_fraction = 0.21;
  chamber.gas_temperature = T;
  chamber.leak = 1e-9;
  CHECK(leak_inflow(chamber, 0.0) == Approx(1e-4).epsilon(1e-15));
  CHECK(leak_inflow(chamber, 1e5) == 0.0);
  CHECK(leak_inflow(chamber, 2e5) == 0.0);
  const GasAmount air = air_in(chamber, volume);
  CHECK(gas_pressure(total(air), T, volume) == Approx(1e5).epsilon(1e-14));
  CHECK(oxygen_fraction(air) == Approx(0.21).epsilon(1e-14));
}
