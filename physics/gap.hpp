// Heat from sphere to sphere, or to a wall, through the spot where they touch, the gas lens round
// it and both solids, in which it spreads. Of all fluxes q through the lens the true one has the
// least
//   k_f/H = [ int q^2 h dA + k_f sum_i S_i/k_i ] / (int q dA)^2,
// h [m] the gap with the temperature jump g = g1 + g2, S_i = int int q q' G dA dA' of a sphere with
// an isothermal equator. H minds q little, so one family does, q = 1/(h + s), s [m] the gap whose
// resistance the solids have. Beside a contact spot of radius a: the same for two fluxes at once,
// that of the spot (4 a k1 k2/(k1 + k2), Batchelor & O'Brien, Proc. R. Soc. Lond. A 355 (1977) 313,
// and the spheres' part) and that of the lens, which heat the same solids; nothing counts twice.
// Within 1.3 % of the resolved solution (verify/resolved_lens.hpp) for k_s/k_f of 5-2000, g of 5e-5
// to 10 R, unlike radii, walls, gaps to 3 R; 3.3 % with a to 0.03 R.
// The rim of the lens is that of the bed's cell, r_sf = R1 r_ij/sqrt(r_ij^2 + D1^2), 1 the smaller
// sphere, D1 its distance to the radical plane, r_ij = 0.560 R1 phi^(-1/3): Cheng, Yu & Zulli,
// Chem. Eng. Sci. 54 (1999) 4199; Zhou, Yu & Zulli, AIChE J. 55 (2009) 868. Plane wall: D1 = d, and
// the wall's face is one temperature, so it has no term of its own (the wall's 1-D profile follows
// behind it): an upper bound for walls that conduct badly. Quadrature: 8 Gauss-Legendre points in a
// variable that crowds them where the lens is thin.
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
  double conductivity_1, conductivity_2;  // [W/m/K] of the solids; a wall's is for the spot alone
  double conductivity_gas;                // [W/m/K]
  double jump;                            // [m] g1 + g2
};
struct PairConductance {
  double contact, gas;  // [W/K] through the spot, and through the gas round it
};

// The softened contact lets spheres overlap far more than real ones: spheres that touch count as
// just touching, R1 + R2 (to a wall: R1), the true overlap being below 1e-3 of that of the model.
double true_distance(double radius_1, double radius_2, double soft_distance);  // [m]

// Share [1] of the conductance that is left across a gap: all up to `begin`, none from `end` on,
// and smooth between. The law knows nothing of the neighbours that a farther one is seen past; so
// it ends where a bed's nearest neighbours do: between these parts [1] of the case's `gap_reach`,
// and to walls [of the radius] where the law has come down to 0.07 and 0.028 k_f R.
double gap_fade(double gap, double begin, double end);
inline constexpr double pair_fade_begin = 0.5, pair_fade_end = 1.5;
inline constexpr double wall_fade_begin = 2.0, wall_fade_end = 3.0;

// r_sf [m] of a sphere whose centre is `distance` [m] from a wall.
double wall_lens_radius(double radius, double distance, double solid_fraction);

PairConductance pair_conductance(const GapPair& pair, const GapMedium& medium);
// The lens alone, its spot taking nothing; the spot alone, in vacuum [W/K].
double gap_conductance(const GapPair& pair, const GapMedium& medium);
double spot_conductance(const GapPair& pair, const GapMedium& medium);

}  // namespace pmr::physics
