#include <algorithm>
#include <cmath>
#include <openturns/ComposedFunction.hxx>
#include <openturns/ConstantBasisFactory.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/MaternModel.hxx>
#include <openturns/NLopt.hxx>
#include <openturns/ResourceMap.hxx>
#include <openturns/SymbolicFunction.hxx>

#include "statistics/kriging.hpp"

namespace pmr::statistics {
namespace {

// Where to search [1] (values have mean 0 and deviation 1, variables go from 0 to 1), and where the
// starts lie: the likelihood is flat outside.
constexpr Span scale_bounds{0.05, 20.0, true}, scale_starts{0.2, 4.0, true};
constexpr Span deviation_bounds{1e-2, 1e2, true}, deviation_starts{0.5, 10.0, true};
constexpr std::size_t starts = 32, climbs = 4;

// Settings of the process while the library works, put back at the end. It takes the amplitude s
// out of the likelihood unless told otherwise, and would then read a noise as a fraction of s^2;
// and it warns on the terminal of bounds that are not used here.
class Settings {
 public:
  Settings() {
    OT::ResourceMap::SetAsBool(key, false);
    OT::Log::Show(OT::Log::NONE);
  }
  ~Settings() {
    OT::ResourceMap::SetAsBool(key, has_analytical_amplitude_);
    OT::Log::Show(shown_);
  }
  Settings(const Settings&) = delete;
  Settings& operator=(const Settings&) = delete;

 private:
  static constexpr const char* key = "GeneralLinearModelAlgorithm-UseAnalyticalAmplitudeEstimate";
  bool has_analytical_amplitude_ = OT::ResourceMap::GetAsBool(key);
  OT::Log::Severity shown_ = OT::Log::Flags();
};

OT::KrigingAlgorithm problem_of(const Points& points, const std::vector<double>& values,
                                const std::vector<double>& noise) {
  const std::size_t n = points.size(), dimension = points.front().size();
  OT::Sample inputs(n, dimension), outputs(n, 1);
  OT::Point variances(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < dimension; ++k) inputs(i, k) = points[i][k];
    outputs(i, 0) = values[i];
    variances[i] = noise[i];
  }
  OT::MaternModel model(OT::Point(dimension, 1.0), OT::Point(1, 1.0), 2.5);
  model.setNuggetFactor(nugget);
  OT::KrigingAlgorithm algorithm(inputs, outputs, model,
                                 OT::ConstantBasisFactory(dimension).build());
  algorithm.setNoise(variances);
  return algorithm;
}

// exp of each of the parameters.
OT::SymbolicFunction exponentials(std::size_t count) {
  OT::Description names, formulas;
  for (std::size_t k = 0; k < count; ++k) {
    names.add("p" + std::to_string(k));
    formulas.add("exp(p" + std::to_string(k) + ")");
  }
  return {names, formulas};
}

struct Candidate {
  double likelihood;
  OT::Point logarithms;
};

bool is_likelier(const Candidate& a, const Candidate& b) { return a.likelihood > b.likelihood; }

// The best few of the starts, spread evenly in the logarithms.
std::vector<Candidate> best_starts(const OT::Function& likelihood, std::size_t dimension) {
  std::vector<Span> ranges(dimension, scale_starts);
  ranges.push_back(deviation_starts);
  std::vector<Candidate> candidates;
  for (const std::vector<double>& start : sample(Sequence::sobol, ranges, starts, 0)) {
    OT::Point logarithms(dimension + 1);
    for (std::size_t k = 0; k <= dimension; ++k) logarithms[k] = std::log(start[k]);
    candidates.push_back({likelihood(logarithms)[0], logarithms});
  }
  std::stable_sort(candidates.begin(), candidates.end(), is_likelier);
  candidates.resize(climbs);
  return candidates;
}

Candidate climb(const OT::OptimizationProblem& problem, const Candidate& start) {
  OT::NLopt solver(problem, "LN_BOBYQA");
  solver.setStartingPoint(start.logarithms);
  solver.setMaximumEvaluationNumber(2000);
  solver.setMaximumAbsoluteError(1e-4);
  solver.setMaximumRelativeError(1e-4);
  try {
    solver.run();
  } catch (const std::exception&) {  // stopped by rounding: the start is a candidate still
    return start;
  }
  const OT::OptimizationResult result = solver.getResult();
  const Candidate end{result.getOptimalValue()[0], result.getOptimalPoint()};
  return is_likelier(end, start) ? end : start;
}

}  // namespace

Matern likeliest(const Points& points, const std::vector<double>& values,
                 const std::vector<double>& noise) {
  const Settings settings;
  const std::size_t dimension = points.front().size();
  OT::KrigingAlgorithm algorithm = problem_of(points, values, noise);
  const OT::ComposedFunction likelihood(algorithm.getReducedLogLikelihoodFunction(),
                                        exponentials(dimension + 1));
  OT::OptimizationProblem problem(likelihood);
  problem.setMinimization(false);
  OT::Point low(dimension + 1, std::log(scale_bounds.low));
  OT::Point high(dimension + 1, std::log(scale_bounds.high));
  low[dimension] = std::log(deviation_bounds.low);
  high[dimension] = std::log(deviation_bounds.high);
  problem.setBounds(OT::Interval(low, high));

  std::vector<Candidate> ends;
  for (const Candidate& start : best_starts(likelihood, dimension))
    ends.push_back(climb(problem, start));
  const OT::Point& best = std::min_element(ends.begin(), ends.end(), is_likelier)->logarithms;
  Matern covariance{std::vector<double>(dimension), std::exp(best[dimension])};
  for (std::size_t k = 0; k < dimension; ++k) covariance.scale[k] = std::exp(best[k]);
  return covariance;
}

}  // namespace pmr::statistics
