// Conduction as heat links: Q = w (T_b - T_a) through solid contacts and through gas gaps.
#pragma once
#include <vector>

#include "coupling/gaps.hpp"
#include "coupling/nodes.hpp"
#include "coupling/outlook.hpp"
#include "pmr/base/csr.hpp"

namespace pmr::coupling {

struct HeatLink {
  Node a, b;       // a < b
  double contact;  // [W/K] through the solid contact
  double gap;      // [W/K] through the gas lens, or a film of gas
};

// By (a, b).
inline bool comes_before(const HeatLink& one, const HeatLink& two) {
  return one.a != two.a ? one.a < two.a : one.b < two.b;
}

// Both halves of the matrix of links that stand in order, contact and gap together [W/K].
Csr symmetric_rows(const std::vector<HeatLink>& links, std::size_t nodes);

// Links of the bed as it lies, in order: across its gaps, from shell to shell, bed top and walls to
// the gas. Properties at the outlook's temperatures; gas at the mean temperature of each pair, and
// as it is in the layer of pores around the first of them.
std::vector<HeatLink> conduct(const Case& c, const Nodes& nodes, const State& state,
                              const Gaps& gaps, const Outlook& outlook,
                              const PoreSpace& pores = {});
inline std::vector<HeatLink> conduct(const Case& c, const Nodes& nodes, const State& state) {
  return conduct(c, nodes, state, find_gaps(c, nodes, state), look_ahead(c, state, 0.0));
}

}  // namespace pmr::coupling
