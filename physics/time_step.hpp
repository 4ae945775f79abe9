// How long a step of the mechanics may be.
#pragma once
#include <string>

#include "pmr/state/case.hpp"

namespace pmr::physics {

// Critical step by Rayleigh waves, dt_c = pi R sqrt(rho/G) / (0.1631 nu + 0.8766) [s]; radius [m],
// density [kg/m3], shear modulus [Pa], Poisson's ratio [1] (Thornton 1997; Ning & Ghadiri 2006).
double rayleigh_step(double radius, double density, double shear_modulus, double poisson);

// Duration of an elastic Hertz contact at approach speed v [s]: c d_max / v with
// d_max = (15 m* v^2 / (16 Y* sqrt(R*)))^(2/5), c = 4/5 sqrt(pi) Gamma(2/5)/Gamma(9/10) = 2.943.
struct HertzPair {
  double reduced_mass;     // m* [kg]
  double reduced_radius;   // R* [m]
  double effective_young;  // Y* [Pa]
};
double hertz_contact_time(const HertzPair& pair, double speed);
double hertz_peak_overlap(const HertzPair& pair, double speed);  // d_max [m]
double hertz_peak_force(const HertzPair& pair, double speed);    // [N] 4/3 Y* sqrt(R*) d_max^(3/2)

// Steps that a Hertz contact at the case's impact speed is resolved with at least [1] (assumed; 20
// steps keep the restitution of Hertz contacts within 1 %, see verify's mechanics checks).
inline constexpr double steps_of_a_contact = 20.0;
// Largest part of the Rayleigh step that is taken without being asked for [1]; 0.2 to 0.4 is the
// usual advice (Ning & Ghadiri 2006; Burns, Piiroinen & Hanley 2019).
inline constexpr double largest_fraction = 0.40;

struct TimeStepReport {
  double step;  // [s] explicit; or the case's fraction of the smallest critical step, and at most a
                // twentieth of a Hertz contact at its impact speed
  double smallest_rayleigh;   // [s] smallest critical step over all particles
  double fraction;            // [1] step / smallest_rayleigh
  std::string species;        // whose critical step is the smallest
  double hertz_contact_time;  // [s] shortest contact of like particles at 1 m/s
};
TimeStepReport time_step(const Case& c);

// What is wrong with the case's time step: above 40 % of Rayleigh and not asked for; or "".
std::string time_step_fault(const Case& c);

}  // namespace pmr::physics
