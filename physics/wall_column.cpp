#include "physics/wall_column.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "physics/conduction.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::physics {
namespace {

// Fewest cells whose sum, growing from `cell` [m] on, reaches the layer's thickness [m]. A first
// cell at the face is half a cell, since its node lies on its edge: borders halve all distances.
std::vector<double> graded_cells(double layer, double cell, double at_face) {
  std::vector<double> cells;
  if (at_face > 0.0) cells.push_back(at_face);
  double sum = at_face;
  for (; sum < layer * (1.0 - 1e-9); cell *= cell_growth) {
    cells.push_back(cell);
    sum += cell;
  }
  for (double& each : cells) each *= layer / sum;  // all shrink alike to fill the layer
  return cells;
}

std::vector<Fault> faults_of(const Lining& lining, const Materials& materials) {
  std::vector<Fault> faults;
  if (lining.layers.empty()) faults.push_back({"", "lining", "has no layer"});
  for (const LiningLayer& layer : lining.layers) {
    const Material& material = materials.list.at(layer.material);
    if (!(layer.thickness > 0.0))
      faults.push_back({"", material.name, "a lining layer's thickness must be positive"});
    if (!std::holds_alternative<ConstantHeat>(material.heat))
      faults.push_back({"", material.name, "a lining needs a constant heat capacity in J/kg/K"});
  }
  return faults;
}

}  // namespace

WallColumn make_column(const Lining& lining, const Materials& materials) {
  if (auto faults = faults_of(lining, materials); !faults.empty()) throw CaseError(faults);
  WallColumn column{{},
                    {},
                    {},
                    lining.initial_temperature,
                    lining.outside_film_coefficient,
                    lining.outside_temperature};
  double next = 2.0 * face_cell, at_face = face_cell;  // [m]
  for (const LiningLayer& layer : lining.layers) {
    const Material& material = materials.list[layer.material];
    const double heat = std::get<ConstantHeat>(material.heat).heat_capacity;
    for (const double cell : graded_cells(layer.thickness, next, at_face)) {
      column.thickness.push_back(cell);
      column.capacity.push_back(material.density * heat * cell);
      column.material.push_back(layer.material);
    }
    next = cell_growth * column.thickness.back();
    at_face = 0.0;
  }
  return column;
}

void initial_energies(const WallColumn& column, double area, std::span<double> energy) {
  const double rise = column.initial_temperature - wall_energy_zero;
  for (std::size_t j = 0; j < column.size(); ++j) energy[j] = area * column.capacity[j] * rise;
}

void column_temperatures(const WallColumn& column, double area, std::span<const double> energy,
                         std::span<double> temperature) {
  for (std::size_t j = 0; j < column.size(); ++j)
    temperature[j] = wall_energy_zero + energy[j] / (area * column.capacity[j]);
}

void column_conductances(const WallColumn& column, const Materials& materials, double pressure,
                         std::span<const double> temperature, std::span<double> conductance) {
  // Resistance [m2 K/W] from the node of the cell before to the border between the two.
  double inner = 0.0;
  for (std::size_t j = 0; j < column.size(); ++j) {
    const double k =
        conductivity(materials.list[column.material[j]].conductivity, temperature[j], pressure);
    const double half = 0.5 * column.thickness[j] / k;
    if (j > 0) conductance[j - 1] = 1.0 / (inner + half);
    inner = j == 0 ? 2.0 * half : half;  // the first node lies on the face
  }
  const double film = column.outside_film_coefficient;
  conductance[column.size() - 1] = film > 0.0 ? 1.0 / (inner + 1.0 / film) : 0.0;
}

double column_rates(const WallColumn& column, const ColumnBoundary& boundary,
                    std::span<const double> temperature, std::span<const double> conductance,
                    std::span<double> rate) {
  double arriving = boundary.face_heat;  // [W]
  for (std::size_t j = 0; j < column.size(); ++j) {
    const double next = j + 1 < column.size() ? temperature[j + 1] : column.outside_temperature;
    const double leaving = boundary.area * conductance[j] * (temperature[j] - next);
    rate[j] = arriving - leaving;
    arriving = leaving;
  }
  return arriving;
}

}  // namespace pmr::physics
