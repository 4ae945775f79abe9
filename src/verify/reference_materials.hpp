// Materials of the closed-form checks, spelled out in code: the checks must not move when a
// shipped material file is edited.
#pragma once
#include "pmr/state/materials.hpp"

namespace pmr::verify {

Material reference_alumina();           // Al2O3 of 92 %
Material reference_ferrite();           // SrFeO(3-d) granule, with the law of two plateaus
RedoxEquilibrium smooth_equilibrium();  // of SrFeO(3-d), fitted to a thermobalance
Material reference_fibre_board();       // lining, k as tabulated at 1 atm, no gas share
// One material of constant properties [kg/m3], [J/kg/K], [W/m/K].
Material constant_solid(double density, double heat_capacity, double conductivity);

}  // namespace pmr::verify
