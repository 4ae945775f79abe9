// Heat through solids and their contacts: conductivity laws, true contact radius, conductance.
#pragma once
#include "pmr/state/materials.hpp"

namespace pmr::physics {

// k [W/m/K] at T [K] with gas of `pressure` [Pa] in the pores.
double conductivity(const Conductivity& law, double T, double pressure);

// Y* [Pa]: 1/Y* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
double soft_contact_modulus(const Material& one, const Material& two);
double real_contact_modulus(const Material& one, const Material& two);

// True over soft contact radius at equal force [1]: (Y*_soft/Y*_real)^(1/3), Hertz. The softened
// contact of the mechanics is too wide by far; settled beds press with equal force.
double contact_softening(const Material& one, const Material& two);

double reduced_radius(double radius_1, double radius_2);  // R* [m]; radius_2 infinite for a wall
// True contact radius a [m] = sqrt(R* overlap) softening; 0 for overlap <= 0.
double contact_radius(double reduced_radius, double overlap, double softening);

// H [W/K] = 4 a k1 k2/(k1 + k2), that is 2 k a for equal solids (Batchelor & O'Brien, Proc. R. Soc.
// Lond. A 355 (1977) 313). Sphere on wall alike.
double contact_conductance(double conductivity_1, double conductivity_2, double contact_radius);

// LIGGGHTS' heat/gran/conduction, 4 k1 k2/(k1 + k2) sqrt(A) with A the circle in which the spheres
// cut each other, pi 2 R* overlap: so many times the law above with Hertz' radius [1]. For
// comparison only.
inline constexpr double liggghts_contact_factor = 2.5066282746310002;  // sqrt(2 pi)

}  // namespace pmr::physics
