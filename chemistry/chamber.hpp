// The closed chamber: ideal gas in the free volume, a pump with set-point control, a leak.
#pragma once
#include "chemistry/gas.hpp"
#include "pmr/state/case.hpp"

namespace pmr::chemistry {

inline constexpr double control_band = 0.005;  // [1] of the set-point, to either side of it

double gas_pressure(double amount, double T, double volume);  // [Pa] n R T / V
// Air of the chamber's pressure, temperature and composition in `volume` [m3].
GasAmount air_in(const ChamberCase& chamber, double volume);

// Gas drawn by the pump [mol/s], of the chamber's composition: u S (1 - p_ult/p) p/(R T), with the
// control's opening u rising smoothly (C2) from 0 to 1 as p goes from 0.995 to 1.005 of the
// set-point, so p is held within 0.5 % where the pump can. Never negative; rounded off within 1 %
// above p_ult. Zero before pump.start: an interval has to begin there.
double pump_outflow(const Pump& pump, double pressure, double T, double time);
// d(outflow)/d(pressure) [mol/s/Pa] at fixed T.
double pump_outflow_slope(const Pump& pump, double pressure, double T, double time);

// Outside air that leaks in [mol/s]: leak (p_air - p), never negative.
double leak_inflow(const ChamberCase& chamber, double pressure);

}  // namespace pmr::chemistry
