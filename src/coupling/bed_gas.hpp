// The gas in the pores of a bed at rest, in horizontal layers that are cut from the packing itself.
#pragma once
#include <cstdint>
#include <vector>

#include "coupling/nodes.hpp"
#include "coupling/thermal_state.hpp"

namespace pmr::coupling {

// A layer as its gas meets it.
struct PoreLayer {
  double area;          // [m2] of the bed's cross-section
  double height;        // [m]
  double volume;        // [m3] of pores
  double permeability;  // [m2] Carman and Kozeny
  double capillary;     // [m] radius of capillaries with that permeability
  double openness;      // [1] porosity over tortuosity, what diffusion is left
  double film;          // [W/K] from gas to all its particles, 2 pi d k each (Nusselt number 2)
};

struct PoreSpace {
  std::vector<PoreLayer> layers;        // from the bottom; empty: not resolved
  std::vector<std::uint32_t> layer_of;  // by particle node
  std::vector<double> share;            // [1] by particle node, of its layer's film

  bool is_resolved() const { return !layers.empty(); }
};

// Empty unless the case resolves the bed's gas and the bed lies.
PoreSpace cut_pores(const Case& c, const Nodes& nodes, const State& state);

// Fills the pores with air of the chamber's pressure and composition at the bed's temperature; the
// books take it in.
void fill_pores(const Case& c, const Nodes& nodes, const PoreSpace& pores, State& state);

// Gas in each layer, as the state has it.
std::vector<Atmosphere> pore_atmospheres(const State& state);

}  // namespace pmr::coupling
