// Stiff integration of the network by CVODES (SUNDIALS): BDF of variable order, Newton, SPGMR with
// the product and the preconditioner of its Jacobian, quadratures by the same BDF formula. SUNDIALS
// stays in cvode.cpp; no exception crosses its C frames.
#pragma once
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "coupling/linearisation.hpp"
#include "pmr/base/stop.hpp"

namespace pmr::coupling {

using In = std::span<const double>;
using Out = std::span<double>;

// y' = f(t, y), q' = g(t, y). A callback that returns false asks for a smaller step.
struct OdeProblem {
  std::function<bool(double t, In y, Out rate)> rate;
  std::function<bool(double t, In y, Out rate)> quadrature;
  // J(t, y); none where y lies outside the domain of f.
  std::function<std::shared_ptr<const Linearisation>(double t, In y)> linearise;
  std::function<void(In y, Out weight)> weigh;  // 1/tolerance of each unknown
  std::function<double(double t, In y)> event;  // empty: none; its first zero is told
  std::size_t quadratures = 0;                  // [1] length of q
  // Unknowns from here on are solved for more strictly, for the books' sake.
  std::size_t strict_from = std::numeric_limits<std::size_t>::max();
  StopToken stop = {};  // looked at in each evaluation of the rate
};

struct OdeResult {
  std::vector<double> quadrature;                             // [unit of q] integral over [t0, t1]
  double next_step = 0.0;                                     // [s] to begin with where this ends
  double event_at = std::numeric_limits<double>::infinity();  // [s]
  long steps = 0, rate_calls = 0, newton = 0, krylov = 0;
};

// Integrates y in place from t0 to t1 [s]; first_step 0 lets CVODES choose. NumericsError when it
// cannot, with the component of the largest weighted error; Stopped when asked to.
OdeResult integrate(const OdeProblem& problem, std::vector<double>& y, double t0, double t1,
                    double first_step);

}  // namespace pmr::coupling
