// Heat from sphere to sphere, or to a wall, through both solids and the gas lens between them:
//   H = int_{r_c}^{r_sf} 2 pi r dr / [ (beta1 - D1 r/r_ij)/k1 + (beta2 - D2 r/r_ij')/k2
//                                      + (d - beta1 - beta2 + g)/k_f ],  beta_k = sqrt(R_k^2 - r^2)
// D1, D2: distances of the centres to the radical plane; r_ij = 0.560 R1 phi^(-1/3), 1 the smaller
// sphere; r_sf = R1 r_ij/sqrt(r_ij^2 + D1^2); r_ij' = D2 r_sf/sqrt(R2^2 - r_sf^2).
// Cheng, Yu & Zulli, Chem. Eng. Sci. 54 (1999) 4199; Zhou, Yu & Zulli, AIChE J. 55 (2009) 868;
// unlike radii and the temperature jump g = g1 + g2 by the same reasoning.
// Plane wall: D1 = d, and the wall's face is one temperature, so it has no term of its own (the
// wall's 1-D profile follows behind it): an upper bound for walls that conduct badly.
// Quadrature: 8 Gauss-Legendre points in a variable that crowds them where the lens is thin; its
// error stays below 1e-5 for k_s/k_f of 5-1600, g of 1e-5-10 R, gaps to R between spheres and to 3
// R at walls (conduction tests). 100 ns a call: no table is needed.
#pragma once
#include <limits>

namespace pmr::physics {

inline constexpr double plane_wall = std::numeric_limits<double>::infinity();  // [m] as a radius

struct GapPair {
  double radius_1, radius_2;  // [m] in any order; radius_2 = plane_wall: a wall
  double distance;            // [m] of the centres, or centre to wall; from true_distance()
  double contact_radius;      // [m] true one, of conduction.hpp; 0 when not touching
  double solid_fraction;      // [1] phi of the bed
};
struct GapMedium {
  double conductivity_1, conductivity_2;  // [W/m/K] of the solids; the second unused for walls
  double conductivity_gas;                // [W/m/K]
  double jump;                            // [m] g1 + g2
};

// The softened contact lets spheres overlap far more than real ones: spheres that touch count as
// just touching, R1 + R2 (to a wall: R1), the true overlap being below 1e-3 of that of the model.
double true_distance(double radius_1, double radius_2, double soft_distance);  // [m]

// Gaps to walls conduct up to this width [1] of the sphere's radius: there H is 0.028 k_f R or
// less, about a thousandth of what it is at touch.
inline constexpr double wall_gap_reach = 3.0;

// r_sf [m] of a sphere whose centre is `distance` [m] from a wall.
double wall_lens_radius(double radius, double distance, double solid_fraction);

double gap_conductance(const GapPair& pair, const GapMedium& medium);  // H [W/K]

}  // namespace pmr::physics
