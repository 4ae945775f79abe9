// The closed chamber: ideal gas in the free volume, a pump with set-point control, a leak.
#pragma once
#include "chemistry/gas.hpp"
#include "pmr/state/case.hpp"

namespace pmr::chemistry {

inline constexpr double control_band = 0.005;  // [1] of the set-point, to either side of it

double gas_pressure(double amount, double T, double volume);  // [Pa] n R T / V
// Air of the chamber's pressure, temperature and composition in `volume` [m3].
GasAmount air_in(const ChamberCase& chamber, double volume);

// Gas drawn by the pump [mol/s], of the chamber's composition: u S (1 - p_ult/p) p/(R T), S its
// speed at p, with the control's opening u rising smoothly (C2) from 0 to 1 as p goes from 0.995 to
// 1.005 of the set-point, so p is held within 0.5 % where the pump can. Never negative; rounded off
// within 1 % above p_ult. Zero before pump.start and from the venting on: intervals begin there.
double pump_outflow(const ChamberCase& chamber, double pressure, double T, double time);

// Outside air that comes in [mol/s]: (leak + vent) (p_air - p), the vent from its start on.
// Negative where the vent lets gas out; a leak alone is never negative.
double air_inflow(const ChamberCase& chamber, double pressure, double time);

// Work of a pump that compresses isothermally to the air's pressure [W] at an outflow [mol/s]:
// n R T_pump ln(p_air/p)/efficiency; 0 above the air's pressure.
double pump_power(const ChamberCase& chamber, double outflow, double pressure);

}  // namespace pmr::chemistry
