// Constants of nature, SI. CODATA 2018 exact values where the SI defines them.
#pragma once
#include <limits>
#include <numbers>

namespace pmr {
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();  // what is not there
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double pi = std::numbers::pi;                // [1]
inline constexpr double avogadro = 6.02214076e23;             // [1/mol], exact
inline constexpr double boltzmann = 1.380649e-23;             // [J/K], exact
inline constexpr double gas_constant = avogadro * boltzmann;  // [J/mol/K] = 8.314462618...
inline constexpr double planck = 6.62607015e-34;              // [J s], exact
inline constexpr double light_speed = 299792458.0;            // [m/s], exact
// Stefan-Boltzmann: 2 pi^5 k^4 / (15 h^3 c^2) = 5.670374419e-8 [W/m2/K4]
inline constexpr double stefan_boltzmann =
    2.0 * pi * pi * pi * pi * pi * boltzmann * boltzmann * boltzmann * boltzmann /
    (15.0 * planck * planck * planck * light_speed * light_speed);
inline constexpr double standard_gravity = 9.80665;      // [m/s2], exact (CGPM 1901)
inline constexpr double bar = 1.0e5;                     // [Pa]
inline constexpr double standard_atmosphere = 101325.0;  // [Pa], exact
inline constexpr double zero_celsius = 273.15;           // [K], exact
}  // namespace pmr
