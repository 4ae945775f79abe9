// The heat network at rest: the temperatures at which every free node gives as much as it receives.
#pragma once
#include <span>
#include <vector>

#include "coupling/heat_links.hpp"
#include "pmr/base/csr.hpp"

namespace pmr::coupling {

// Temperatures [K] of all nodes: those held stay as given, the others satisfy
//   sum_j w_ij (T_j - T_i) + sum_j G_ij sigma (T_j^4 - T_i^4) = 0
// to 1e-9 of the spread of the held ones. `temperature` is also where the search starts. Radiation
// is written as a conductance G sigma (T_i^2 + T_j^2)(T_i + T_j) and renewed until nothing changes;
// each symmetric system goes to Eigen's conjugate gradients. Nodes without any link keep what they
// were given. NumericsError if it does not converge.
std::vector<double> steady_temperatures(std::span<const HeatLink> links, const Csr* exchange,
                                        const std::vector<char>& is_held,
                                        std::vector<double> temperature);

}  // namespace pmr::coupling
