// Pump, control and leak.
#include <catch2/catch.hpp>
#include <cmath>

#include "chemistry/chamber.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::chemistry;

namespace {
constexpr double T = 300.0, volume = 5e-3;

// Start 10 s, speed 4 l/s, ultimate 5 Pa.
ChamberCase pumped(double set_point = 1000.0) {
  ChamberCase chamber{};
  chamber.pressure = 1e5;
  chamber.oxygen_fraction = 0.21;
  chamber.gas_temperature = T;
  chamber.pump = Pump{10.0, constant(4e-3), 5.0, set_point, 0.5};
  return chamber;
}

// Pressure after `duration` from `pressure`, constant T, `inflow` [mol/s]; Runge-Kutta of order 4.
double evacuate(const ChamberCase& chamber, double pressure, double duration, double inflow) {
  const auto rate = [&](double now) {
    return gas_pressure(inflow - pump_outflow(chamber, now, T, 10.0), T, volume);
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

constexpr double unthrottled = 1e-9;  // [Pa] a set-point below the ultimate pressure
}  // namespace

TEST_CASE("the pump never blows, is still before its start and stops at its ultimate pressure") {
  const ChamberCase free = pumped(unthrottled);
  for (const ChamberCase& chamber : {pumped(), free})
    for (double pressure = -10.0; pressure < 2e5; pressure += 0.37 + 0.01 * std::abs(pressure)) {
      CHECK(pump_outflow(chamber, pressure, T, 10.0) >= 0.0);
      CHECK(pump_outflow(chamber, pressure, T, 9.999) == 0.0);
    }
  CHECK(pump_outflow(free, 5.0, T, 20.0) == 0.0);
  CHECK(pump_outflow(free, 4.0, T, 20.0) == 0.0);
  CHECK(pump_outflow(free, 6.0, T, 20.0) == Approx(4e-3 * 1.0 / (gas_constant * T)).epsilon(1e-14));
}

TEST_CASE("the outflow has no corner") {
  const ChamberCase chamber = pumped();
  const auto slope = [&](double pressure, double h) {
    return (pump_outflow(chamber, pressure + h, T, 20.0) -
            pump_outflow(chamber, pressure, T, 20.0)) /
           h;
  };
  for (const double corner : {5.0, 5.05, 995.0, 1005.0})
    CHECK(slope(corner, 1e-6) == Approx(slope(corner, -1e-6)).epsilon(1e-3).margin(1e-9));
}

TEST_CASE("a pump follows its curve") {
  ChamberCase chamber = pumped(unthrottled);
  chamber.pump->speed = {{10.0, 1000.0}, {1e-3, 5e-3}};
  const auto speed = [&](double p) {
    return pump_outflow(chamber, p, T, 20.0) * gas_constant * T / (p - 5.0);
  };
  CHECK(speed(505.0) == Approx(3e-3));
  CHECK(speed(1e4) == Approx(5e-3));
}

TEST_CASE("isothermal compression takes its work, over the efficiency") {
  CHECK(pump_power(pumped(), 1e-3, 1e3) ==
        Approx(1e-3 * gas_constant * T * std::log(100.0) / 0.5).epsilon(1e-14));
  CHECK(pump_power(pumped(), 1e-3, 1e5) == 0.0);
}

TEST_CASE("an empty chamber is evacuated along its exponential") {
  const ChamberCase free = pumped(unthrottled);
  // p = p_ult + (p0 - p_ult) exp(-S t/V); Runge-Kutta's error is below 1e-12 at these steps.
  const double expected = 5.0 + (1e5 - 5.0) * std::exp(-4e-3 * 5.0 / volume);
  CHECK(evacuate(free, 1e5, 5.0, 0.0) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("the control holds the set-point within its band while gas comes in") {
  for (const double inflow : {0.0, 1e-6, 1e-4, 1e-3})
    CHECK(evacuate(pumped(), 1e5, 60.0, inflow) == Approx(1000.0).epsilon(control_band));
}

TEST_CASE("air leaks in until the pressures are equal, and never out") {
  ChamberCase chamber = pumped();
  chamber.leak = 1e-9;
  CHECK(air_inflow(chamber, 0.0, 20.0) == Approx(1e-4).epsilon(1e-15));
  CHECK(air_inflow(chamber, 1e5, 20.0) == 0.0);
  CHECK(air_inflow(chamber, 2e5, 20.0) == 0.0);
  const GasAmount air = air_in(chamber, volume);
  CHECK(gas_pressure(total(air), T, volume) == Approx(1e5).epsilon(1e-14));
  CHECK(oxygen_fraction(air) == Approx(0.21).epsilon(1e-14));
}

TEST_CASE("a vent lets air in, lets gas out, and stops the pump") {
  ChamberCase chamber = pumped();
  chamber.vent = Vent{100.0, 1e-6};
  CHECK(air_inflow(chamber, 0.0, 99.0) == 0.0);
  CHECK(air_inflow(chamber, 0.0, 100.0) == Approx(0.1).epsilon(1e-14));
  CHECK(air_inflow(chamber, 2e5, 100.0) == Approx(-0.1).epsilon(1e-14));
  CHECK(pump_outflow(chamber, 5e4, T, 99.0) > 0.0);
  CHECK(pump_outflow(chamber, 5e4, T, 100.0) == 0.0);
}
