// Which variable, alone or together with another, a response varies with.
#pragma once
#include <functional>
#include <span>
#include <vector>

namespace pmr::statistics {

// Sobol' indices: shares [1] of the variance of a response over evenly spread variables.
struct Effects {
  std::vector<double> first;  // of one variable alone
  std::vector<double> total;  // of one variable with all it interacts with
  std::vector<std::vector<double>>
      pair;  // of two together beyond each alone, symmetric, diagonal 0
};

// A response of fractions [1] of the variables' spans; may be called from several threads.
using UnitFunction = std::function<double(std::span<const double>)>;

// Indices of a function over the unit cube from quasi-random points a, b in pairs, as good as
// +-0.01 for smooth functions and 4096 of them; all NaN when the function does not vary. It is
// called count * (2 + d + d (d - 1) / 2) times. With a_u = a with the variables u of b:
//   closed index of u   mean f(b) (f(a_u) - f(a)) / V   (Saltelli et al., Comput. Phys. Commun. 181
//                       (2010) 259); first: u = {i}; pair: u = {i, j}, less both first ones
//   total index of i    mean (f(a) - f(a_i))^2 / 2V     (Jansen, Comput. Phys. Commun. 117 (1999)
//   35)
Effects sobol_indices(const UnitFunction& response, std::size_t dimension,
                      std::size_t count = 4096);

}  // namespace pmr::statistics
