// Heat from sphere to sphere, or to a plane of one temperature, resolved in the bodies: what the
// law of physics/gap.hpp is held against. In each sphere steady conduction from an isothermal
// equator to the cap within the lens' rim, the rest of its surface adiabatic: on rings of even flux
// about the axis, summed over odd Legendre polynomials (the flux at the other pole goes out again).
// Between the rings gas, k_f/(gap + jump), and none where they touch: one linear system for the
// rings' heat.
#pragma once
#include "physics/gap.hpp"

namespace pmr::verify {

// H [W/K] of spot and lens together. Within 0.5 % for lenses and spots wider than 0.002 R (other
// numbers of rings and polynomials).
double resolved_conductance(const physics::GapPair& pair, const physics::GapMedium& medium);

}  // namespace pmr::verify
