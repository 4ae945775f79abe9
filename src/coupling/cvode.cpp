#include "coupling/cvode.hpp"

#include <cvodes/cvodes.h>
#include <fmt/format.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <optional>

#include "coupling/preconditioner.hpp"
#include "coupling/sum_keeper.hpp"
#include "coupling/vectors.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::coupling {
namespace {

// The books ask for more than the solution does, since residuals add up over steps and unknowns;
// most of all where a border is passed by nonlinear flows (strict_limit: what pump and vent take).
// Newton's last correction has to be below newton_limit of the tolerance [1]: CVODES' own test
// extrapolates with the rate of earlier steps and widens with the order, and where the pump's
// valve moves neither holds. Linear systems are solved to linear_part of the tolerance, times
// CVODES' 0.05, and mended to keep their sums exactly; CVODES may skip one only if its right-hand
// side is below skipped_part, likewise.
constexpr double newton_limit = 1e-2;
constexpr double strict_limit = 3e-4;  // of the unknowns from OdeProblem::strict_from on
constexpr double linear_part = 1e-1;
constexpr double skipped_part = 2e-5;
constexpr int newton_iterations = 6;  // at most
constexpr double divergence = 2.0;    // [1] a correction that grows by more is given up

constexpr int krylov_space = 30;  // vectors kept by SPGMR; no restart needed in practice

using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, void (*)(N_Vector)>;

Out view(N_Vector v) { return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength(v))}; }

// What the C callbacks see. An exception is kept and rethrown once C has returned.
struct Frame {
  const OdeProblem& problem;
  std::exception_ptr thrown = nullptr;
  double last_correction = 0.0;  // [1] of Newton's iteration, weighted
  double linearised_at = std::numeric_limits<double>::quiet_NaN();  // [s]
  std::shared_ptr<const Linearisation> jacobian = nullptr;
  std::optional<Preconditioner> preconditioner = {};
  std::optional<SumKeeper> keeper = {};  // of `jacobian`

  bool linearise(double t, In y) {
    auto here = problem.linearise(t, y);
    if (!here) return false;
    keeper.reset();
    jacobian = std::move(here);
    linearised_at = t;
    return true;
  }
  void keep_sums(double gamma, In b, Out x) {
    if (!keeper || keeper->gamma() != gamma) keeper.emplace(jacobian, gamma);
    keeper->mend(b, x);
  }

  // 0 done, 1 recoverable, -1 give up.
  template <class Call>
  int guard(const Call& call) {
    try {
      return call() ? 0 : 1;
    } catch (...) {
      thrown = std::current_exception();
      return -1;
    }
  }
};

Frame& frame_of(void* data) { return *static_cast<Frame*>(data); }

int rate(realtype t, N_Vector y, N_Vector ydot, void* data) {
  Frame& f = frame_of(data);
  return f.guard([&] {
    f.problem.stop.check();
    return f.problem.rate(t, view(y), view(ydot));
  });
}

int weigh(N_Vector y, N_Vector weight, void* data) {
  Frame& f = frame_of(data);
  return f.guard([&] { return f.problem.weigh(view(y), view(weight)), true; });
}

int quadrature(realtype t, N_Vector y, N_Vector qdot, void* data) {
  Frame& f = frame_of(data);
  return f.guard([&] { return f.problem.quadrature(t, view(y), view(qdot)); });
}

int event(realtype t, N_Vector y, realtype* value, void* data) {
  Frame& f = frame_of(data);
  return f.guard([&] { return *value = f.problem.event(t, view(y)), true; });
}

// J stays for Newton's iterations of one step.
int linearise(realtype t, N_Vector y, N_Vector, void* data) {
  Frame& f = frame_of(data);
  if (t == f.linearised_at) return 0;
  return f.guard([&] { return f.linearise(t, view(y)); });
}

int product(N_Vector v, N_Vector jv, realtype, N_Vector, N_Vector, void* data, N_Vector) {
  Frame& f = frame_of(data);
  return f.guard([&] { return product(*f.jacobian, view(v), view(jv)), true; });
}

int prepare(realtype t, N_Vector y, N_Vector, booleantype, booleantype* renewed, realtype gamma,
            void* data) {
  Frame& f = frame_of(data);
  *renewed = SUNTRUE;
  return f.guard([&] {
    if (!f.linearise(t, view(y))) return false;
    f.preconditioner.emplace(*f.jacobian, gamma);
    return true;
  });
}

int precondition(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype, realtype, int,
                 void* data) {
  Frame& f = frame_of(data);
  return f.guard([&] { return f.preconditioner->solve(*f.jacobian, view(r), view(z)), true; });
}

// SPGMR's solve, its solution mended. What it iterates with belongs to CVODES, which knows us.
int solve(SUNLinearSolver solver, SUNMatrix none, N_Vector x, N_Vector b, realtype tolerance) {
  const int flag = SUNLinSolSolve_SPGMR(solver, none, x, b, linear_part / skipped_part * tolerance);
  if (flag < 0) return flag;
  void* cvode = static_cast<SUNLinearSolverContent_SPGMR>(solver->content)->ATData;
  void* data = nullptr;
  realtype gamma = 0.0;
  if (CVodeGetUserData(cvode, &data) != CV_SUCCESS ||
      CVodeGetCurrentGamma(cvode, &gamma) != CV_SUCCESS)
    return SUNLS_ATIMES_FAIL_UNREC;
  Frame& f = frame_of(data);
  const int done = f.guard([&] { return f.keep_sums(gamma, view(b), view(x)), true; });
  return done == 0 ? flag : SUNLS_ATIMES_FAIL_UNREC;
}

// The norm of the unknowns from `first` on alone.
double strict_size(In correction, In weight, std::size_t first) {
  double sum = 0.0;
  for (std::size_t k = first; k < correction.size(); ++k) {
    const double weighted = correction[k] * weight[k];
    sum += weighted * weighted;
  }
  return std::sqrt(sum / static_cast<double>(correction.size()));
}

int converged(SUNNonlinearSolver newton, N_Vector, N_Vector correction, realtype, N_Vector weight,
              void* data) {
  Frame& f = frame_of(data);
  int iteration = 0;
  SUNNonlinSolGetCurIter(newton, &iteration);
  const double size = N_VWrmsNorm(correction, weight);
  if (size <= newton_limit &&
      strict_size(view(correction), view(weight), f.problem.strict_from) <= strict_limit)
    return SUN_NLS_SUCCESS;
  const bool diverges = iteration > 0 && size > divergence * f.last_correction;
  f.last_correction = size;
  return diverges ? SUN_NLS_CONV_RECVR : SUN_NLS_CONTINUE;
}

void silence(int, const char*, const char*, char*, void*) {}

// The worst component of the last step, for the message of a failure.
std::string worst_component(void* solver, N_Vector like) {
  N_Vector error = N_VClone(like), weight = N_VClone(like);
  CVodeGetEstLocalErrors(solver, error);
  CVodeGetErrWeights(solver, weight);
  std::size_t worst = 0;
  double largest = 0.0;
  for (std::size_t k = 0; k < view(error).size(); ++k) {
    const double weighted = std::abs(view(error)[k] * view(weight)[k]);
    if (weighted > largest) {
      largest = weighted;
      worst = k;
    }
  }
  N_VDestroy(error);
  N_VDestroy(weight);
  return fmt::format("unknown {} with a weighted error of {:.3g}", worst, largest);
}

// CVODES memory with its linear solver, set up for one problem.
class Solver {
 public:
  Solver(Frame& frame, N_Vector y, double t0, SUNContext context)
      : memory_(CVodeCreate(CV_BDF, context)),
        linear_(SUNLinSol_SPGMR(y, SUN_PREC_RIGHT, krylov_space, context)),
        newton_(SUNNonlinSol_Newton(y, context)) {
    require(CVodeInit(memory_, rate, t0, y), "CVodeInit");
    require(CVodeSetErrHandlerFn(memory_, silence, nullptr), "CVodeSetErrHandlerFn");
    require(CVodeSetUserData(memory_, &frame), "CVodeSetUserData");
    require(CVodeWFtolerances(memory_, weigh), "CVodeWFtolerances");
    require(CVodeSetNonlinConvCoef(memory_, skipped_part), "CVodeSetNonlinConvCoef");
    require(CVodeSetMaxNumSteps(memory_, 100'000), "CVodeSetMaxNumSteps");
    require(CVodeSetMaxErrTestFails(memory_, 20), "CVodeSetMaxErrTestFails");
    require(CVodeSetMaxConvFails(memory_, 30), "CVodeSetMaxConvFails");
    require(CVodeSetNonlinearSolver(memory_, newton_), "CVodeSetNonlinearSolver");
    require(SUNNonlinSolSetConvTestFn(newton_, converged, &frame), "SUNNonlinSolSetConvTestFn");
    require(CVodeSetMaxNonlinIters(memory_, newton_iterations), "CVodeSetMaxNonlinIters");
    linear_->ops->solve = solve;
    require(CVodeSetLinearSolver(memory_, linear_, nullptr), "CVodeSetLinearSolver");
    require(CVodeSetJacTimes(memory_, linearise, product), "CVodeSetJacTimes");
    require(CVodeSetPreconditioner(memory_, prepare, precondition), "CVodeSetPreconditioner");
  }
  ~Solver() {
    CVodeFree(&memory_);
    SUNLinSolFree(linear_);
    SUNNonlinSolFree(newton_);
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  void* get() const { return memory_; }
  static void require(int flag, const char* what) {
    if (flag < 0) throw NumericsError(fmt::format("CVODES: {} failed with flag {}", what, flag));
  }

 private:
  void* memory_;
  SUNLinearSolver linear_;
  SUNNonlinearSolver newton_;
};

// The step whose error by Euler's formula, h^2/2 y'', is what CVODES aims at: the next integration
// begins with order 1, and the last step may have been cut short at the end.
double euler_step(void* solver, N_Vector like, double t) {
  constexpr double aim = 1.0 / 6.0;  // [1] of the tolerance
  int order = 0;
  double step = 0.0;
  CVodeGetLastStep(solver, &step);
  CVodeGetLastOrder(solver, &order);
  if (order < 2) return step;
  const Vector curvature(N_VClone(like), N_VDestroy), weight(N_VClone(like), N_VDestroy);
  CVodeGetDky(solver, t, 2, curvature.get());
  CVodeGetErrWeights(solver, weight.get());
  const double size = N_VWrmsNorm(curvature.get(), weight.get());  // [1/s2]
  return size > 0.0 ? std::sqrt(2.0 * aim / size) : step;
}

OdeResult statistics(void* solver, std::vector<double> quadratures) {
  OdeResult result;
  result.quadrature = std::move(quadratures);
  CVodeGetNumSteps(solver, &result.steps);
  CVodeGetNumRhsEvals(solver, &result.rate_calls);
  CVodeGetNumNonlinSolvIters(solver, &result.newton);
  CVodeGetNumLinIters(solver, &result.krylov);
  return result;
}

}  // namespace

OdeResult integrate(const OdeProblem& problem, std::vector<double>& y, double t0, double t1,
                    double first_step) {
  const sundials::Context context;
  Frame frame{problem};
  std::vector<double> integral(problem.quadratures, 0.0);
  const Vector y_vector(make_vector(y, context), N_VDestroy);
  const Vector integral_vector(make_vector(integral, context), N_VDestroy);

  const Solver solver(frame, y_vector.get(), t0, context);
  Solver::require(CVodeQuadInit(solver.get(), quadrature, integral_vector.get()), "CVodeQuadInit");
  // Error control of the quadratures is on, with a tolerance that never binds: without it
  // CVODES 6.4 forgets their last correction where the order rises, and the integrals part from the
  // solution.
  Solver::require(CVodeSetQuadErrCon(solver.get(), SUNTRUE), "CVodeSetQuadErrCon");
  Solver::require(CVodeQuadSStolerances(solver.get(), 0.0, 1e100), "CVodeQuadSStolerances");
  Solver::require(CVodeSetStopTime(solver.get(), t1), "CVodeSetStopTime");
  if (first_step > 0.0) CVodeSetInitStep(solver.get(), std::min(first_step, t1 - t0));

  if (problem.event) Solver::require(CVodeRootInit(solver.get(), 1, event), "CVodeRootInit");

  double t = t0, event_at = std::numeric_limits<double>::infinity();
  int flag = CVode(solver.get(), t1, y_vector.get(), &t, CV_NORMAL);
  if (flag == CV_ROOT_RETURN) {
    event_at = t;  // the first alone is asked for: a zero that lasts would be an error of CVODES
    Solver::require(CVodeRootInit(solver.get(), 0, nullptr), "CVodeRootInit");
    flag = CVode(solver.get(), t1, y_vector.get(), &t, CV_NORMAL);
  }
  if (frame.thrown) std::rethrow_exception(frame.thrown);
  if (flag < 0) {
    const std::unique_ptr<char, decltype(&std::free)> name(CVodeGetReturnFlagName(flag), std::free);
    throw NumericsError(fmt::format("heat and reaction network: {} at t = {:.6g} s; {}", name.get(),
                                    t, worst_component(solver.get(), y_vector.get())));
  }
  Solver::require(CVodeGetQuad(solver.get(), &t, integral_vector.get()), "CVodeGetQuad");
  OdeResult result = statistics(solver.get(), std::move(integral));
  result.event_at = event_at;
  result.next_step = euler_step(solver.get(), y_vector.get(), t1);
  return result;
}

}  // namespace pmr::coupling
