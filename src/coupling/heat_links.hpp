// Conduction as heat links: Q = w (T_b - T_a) through solid contacts and through gas gaps.
#pragma once
#include <vector>

#include "coupling/nodes.hpp"

namespace pmr::coupling {

struct HeatLink {
  Node a, b;       // a < b
  double contact;  // [W/K] through the solid contact
  double gap;      // [W/K] through the gas lens, or a film of gas
};

// Links of the bed as it lies: particle to particle, particle to wall patch, bed top and walls to
// the gas. Gas properties at the mean temperature of each pair and the pressure of the moment.
std::vector<HeatLink> conduct(const Case& c, const Nodes& nodes, const State& state);

}  // namespace pmr::coupling
