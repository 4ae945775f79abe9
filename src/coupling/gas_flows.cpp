// What the gas does by itself: flow and diffusion through the bed's pores, pump, leak and vent.
#include <array>
#include <cmath>

#include "chemistry/chamber.hpp"
#include "coupling/system.hpp"
#include "physics/porous_bed.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::coupling {
namespace {

// A gas zone at one moment.
struct Zone {
  double temperature;      // [K]
  double pressure;         // [Pa]
  double oxygen_fraction;  // [1]
};

// Moles and enthalpy on their way.
struct Flow {
  double oxygen = 0.0, nitrogen = 0.0;  // [mol/s]
  double enthalpy = 0.0;                // [W]
};

Zone zone_at(std::span<const double> y, double volume, double guess) {
  const chemistry::GasAmount gas{y[0], y[1]};
  const double T = chemistry::gas_temperature(gas, y[2], guess);
  return {T, chemistry::gas_pressure(chemistry::total(gas), T, volume),
          chemistry::oxygen_fraction(gas)};
}

double in_series(double a, double b) { return a * b / (a + b); }

// Half of a layer on the way of the gas: what it lets through.
struct Half {
  double flow;       // [m3/s/Pa] A K (1 + slip)/(mu h/2)
  double diffusion;  // [m3/s] A D/(h/2)
};

// At 1 atm half a layer takes at least this long to empty, and less in proportion to the pressure:
// without such a resistance in series pressures would differ by less than the solver can tell, a
// 1e-8 of themselves, and the flow they drive would be noise. In the demonstrator it doubles the
// bed's overpressure of 0.1 kPa at 1 atm, and is a ten-thousandth of its resistance at 1 kPa.
constexpr double emptying = 2e-6;  // [s]

Half half_of(const PoreLayer& layer, const Zone& gas) {
  const double x = gas.oxygen_fraction, T = gas.temperature;
  const double path = chemistry::mean_free_path(x, T, gas.pressure);
  const double spread = layer.area / (0.5 * layer.height);  // [m]
  const double molar =
      x * chemistry::oxygen_molar_mass + (1.0 - x) * chemistry::nitrogen_molar_mass;
  const double knudsen =
      2.0 / 3.0 * layer.capillary * std::sqrt(8.0 * gas_constant * T / (pi * molar));
  const double free = chemistry::binary_diffusivity(T, gas.pressure);
  const double viscous = spread * layer.permeability * physics::slip_factor(path, layer.capillary) /
                         chemistry::viscosity(x, T);
  return {in_series(viscous,
                    layer.volume * standard_atmosphere / (emptying * gas.pressure * gas.pressure)),
          spread * layer.openness / (1.0 / free + 1.0 / knudsen)};
}

// Share [1] of the donor-side value in what a flow carries past a face between a and b, besides
// diffusion: the exact profile of convection with diffusion (Scharfetter and Gummel 1969), at the
// Peclet number of the way; 1/2 at rest, 1 when all comes from a.
double share_of_a(double peclet) {
  if (std::abs(peclet) < 1e-3) return 0.5 + peclet / 12.0;
  return 1.0 / -std::expm1(-peclet) - 1.0 / peclet;
}

double mixed(double share, double a, double b) { return b + share * (a - b); }

// From a to b: viscous flow with slip, c K/mu dp, and diffusion of the species into each other,
// c D dx. Enthalpies are carried alike; what they would diffuse is in the gaps' conduction.
Flow between(const Zone& a, const Zone& b, const Half& way, double concentration) {
  const double whole = concentration * way.flow * (a.pressure - b.pressure);
  const double share = share_of_a(whole / (concentration * way.diffusion));
  const double x = mixed(share, a.oxygen_fraction, b.oxygen_fraction);
  const double mixing = concentration * way.diffusion * (a.oxygen_fraction - b.oxygen_fraction);
  const double oxygen = whole * x + mixing, nitrogen = whole * (1.0 - x) - mixing;
  const auto carried = [&](auto heat) {
    return mixed(share, heat(a.temperature).enthalpy, heat(b.temperature).enthalpy);
  };
  return {oxygen, nitrogen,
          oxygen * carried(chemistry::oxygen_heat) + nitrogen * carried(chemistry::nitrogen_heat)};
}

double concentration(const Zone& gas) { return gas.pressure / (gas_constant * gas.temperature); }

void add_flow(std::span<double> rate, const Flow& flow, double sign) {
  rate[0] += sign * flow.oxygen;
  rate[1] += sign * flow.nitrogen;
  rate[2] += sign * flow.enthalpy;
}

// Up through the layers, and out of the uppermost into `above`; what goes there is returned.
Flow rise(const System& system, const std::vector<Zone>& layers, const Zone& above,
          std::span<double> rate) {
  std::vector<Half> half;
  for (std::size_t k = 0; k < layers.size(); ++k)
    half.push_back(half_of(system.pores.layers[k], layers[k]));
  for (std::size_t k = 0; k + 1 < layers.size(); ++k) {
    const Half way{in_series(half[k].flow, half[k + 1].flow),
                   in_series(half[k].diffusion, half[k + 1].diffusion)};
    const double mean = 0.5 * (concentration(layers[k]) + concentration(layers[k + 1]));
    const Flow flow = between(layers[k], layers[k + 1], way, mean);
    add_flow(rate.subspan(3 * k, 3), flow, -1.0);
    add_flow(rate.subspan(3 * k + 3, 3), flow, 1.0);
  }
  // The bed's temperature holds up to its top.
  const Zone& top = layers.back();
  const double mean = 0.5 * (top.pressure + above.pressure) / (gas_constant * top.temperature);
  const Flow flow = between(top, above, half.back(), mean);
  add_flow(rate.subspan(3 * (layers.size() - 1), 3), flow, -1.0);
  return flow;
}

void pump_and_leak(const ChamberCase& chamber, double t, const Zone& gas, GasRates& r) {
  const double x = gas.oxygen_fraction, T = gas.temperature;
  const double out = chemistry::pump_outflow(chamber, gas.pressure, T, t);
  const double in = chemistry::air_inflow(chamber, gas.pressure, t);
  r.pump_power = chemistry::pump_power(chamber, out, gas.pressure);
  r.oxygen_pumped = x * out;
  r.nitrogen_pumped = (1.0 - x) * out;
  r.energy_out = chemistry::enthalpy({r.oxygen_pumped, r.nitrogen_pumped}, T);
  if (in >= 0.0) {
    r.oxygen_leaked = chamber.oxygen_fraction * in;
    r.nitrogen_leaked = (1.0 - chamber.oxygen_fraction) * in;
    r.energy_in =
        chemistry::enthalpy({r.oxygen_leaked, r.nitrogen_leaked}, chamber.gas_temperature);
    return;
  }
  r.oxygen_to_air = -x * in;
  r.nitrogen_to_air = -(1.0 - x) * in;
  r.energy_out += chemistry::enthalpy({r.oxygen_to_air, r.nitrogen_to_air}, T);
}

void leave_to_air(const Flow& flow, GasRates& r) {
  r.oxygen_to_air += flow.oxygen;
  r.nitrogen_to_air += flow.nitrogen;
  r.energy_out += flow.enthalpy;
}

}  // namespace

GasRates gas_rates(const System& system, double t, std::span<const double> y) {
  const ChamberCase& chamber = *system.setup->chamber;
  GasRates r{};
  r.rate.assign(y.size(), 0.0);
  const std::size_t layers = system.pores.layers.size();
  Zone above{chamber.gas_temperature, chamber.pressure, chamber.oxygen_fraction};
  if (system.closed)
    above = zone_at(y.subspan(3 * layers, 3), system.free_volume, chamber.gas_temperature);
  r.temperature = above.temperature;
  r.pressure = above.pressure;
  r.oxygen_pressure = above.oxygen_fraction * above.pressure;
  Flow risen;
  if (layers > 0) {
    std::vector<Zone> zones;
    for (std::size_t k = 0; k < layers; ++k) {
      zones.push_back(zone_at(y.subspan(3 * k, 3), system.pores.layers[k].volume, 1e3));
      r.zone_temperature.push_back(zones[k].temperature);
      r.zone_oxygen_pressure.push_back(zones[k].oxygen_fraction * zones[k].pressure);
    }
    risen = rise(system, zones, above, r.rate);
  }
  if (!system.closed) {
    leave_to_air(risen, r);
    return r;
  }
  r.zone_temperature.push_back(r.temperature);
  r.zone_oxygen_pressure.push_back(r.oxygen_pressure);
  pump_and_leak(chamber, t, above, r);
  add_flow({r.rate.data() + 3 * layers, 3}, risen, 1.0);
  add_flow({r.rate.data() + 3 * layers, 3},
           {r.oxygen_leaked - r.oxygen_pumped - r.oxygen_to_air,
            r.nitrogen_leaked - r.nitrogen_pumped - r.nitrogen_to_air, r.energy_in - r.energy_out},
           1.0);
  return r;
}

}  // namespace pmr::coupling
