// The conductivity of a packed bed by correlation, to set the particle-resolved bed beside.
#pragma once

namespace pmr::physics {

struct PackedBed {
  double solid_fraction;      // [1]
  double diameter;            // [m] of its spheres
  double solid_conductivity;  // [W/m/K]
  double emissivity;          // [1]
  double temperature;         // [K]
  double gas_conductivity;    // [W/m/K]
  double jump;                // [m] sum of both surfaces' temperature jump lengths
};

// k [W/m/K] after Zehner, Bauer & Schluender (VDI Heat Atlas, 2nd ed. 2010, D6.3) for equal spheres
// with flattened contacts (0.0077 of the cross-section, ceramic spheres): unit cells of solid, gas
// and radiation side by side, gas rarefied by k_D = k_g/(1 + jump/d). A correlation, good to about
// 30 % by its authors; the spheres do not see further than their cell.
double zehner_bauer_schluender(const PackedBed& bed);

}  // namespace pmr::physics
