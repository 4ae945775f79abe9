// Transient 1-D heat profile through the layers of a wall: finite volumes graded from the face
// that looks at the bed, to a convective outside. The unknown is each cell's energy [J], counted
// from 298.15 K; temperatures follow. The first cell's node lies on the face itself, all others at
// their cells' middle. Pure functions, so that an implicit integrator can own the unknowns.
// Walls' heat capacity is a ConstantHeat; other laws are refused (this layer knows no chemistry).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pmr/state/materials.hpp"
#include "pmr/state/walls.hpp"

namespace pmr::physics {

inline constexpr double face_cell = 2.5e-5;  // [m] at most. After 0.05 s in fibre board the face is
// right to 0.1 % under a given flux and the flux to 1 % under a given face temperature.
inline constexpr double cell_growth = 1.2;          // [1] from cell to cell, at most (first: 2)
inline constexpr double wall_energy_zero = 298.15;  // [K]

struct WallColumn {
  std::vector<double> thickness;        // [m] of each cell, face first
  std::vector<double> capacity;         // [J/m2/K] of each cell
  std::vector<std::uint32_t> material;  // index into Materials
  double initial_temperature;           // [K]
  double outside_film_coefficient;      // [W/m2/K]
  double outside_temperature;           // [K]

  std::size_t size() const { return thickness.size(); }
};

// CaseError when a layer has no positive thickness or its material no ConstantHeat.
WallColumn make_column(const Lining& lining, const Materials& materials);

// All spans below have one entry per cell. Areas [m2].
void initial_energies(const WallColumn& column, double area, std::span<double> energy);  // [J]
void column_temperatures(const WallColumn& column, double area, std::span<const double> energy,
                         std::span<double> temperature);  // [J] -> [K]

// Conductance per area [W/m2/K]: entry j from node j to node j + 1, the last to the outside, with
// each cell's k(T, pressure) in series (harmonic mean).
void column_conductances(const WallColumn& column, const Materials& materials, double pressure,
                         std::span<const double> temperature, std::span<double> conductance);

// What a column exchanges with the world.
struct ColumnBoundary {
  double area;       // [m2]
  double face_heat;  // [W] into the face
};
// Fills rate = dE/dt [W] of each cell and returns the heat that leaves to the outside [W]; the sum
// of the rates is face_heat less that, to rounding.
double column_rates(const WallColumn& column, const ColumnBoundary& boundary,
                    std::span<const double> temperature, std::span<const double> conductance,
                    std::span<double> rate);

}  // namespace pmr::physics
