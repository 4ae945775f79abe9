#include "coupling/network.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "chemistry/chamber.hpp"
#include "chemistry/gas.hpp"
#include "chemistry/heat_curve.hpp"
#include "coupling/cvode.hpp"
#include "coupling/flux_rates.hpp"
#include "coupling/linearisation.hpp"
#include "coupling/system.hpp"
#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"
#include "pmr/base/vec3.hpp"

namespace pmr::coupling {
namespace {

// Absolute tolerances: a temperature's times the heat capacity, a delta's, and for the gas what the
// relative tolerance leaves of 1 Pa.
std::vector<double> tolerances(const Case& c, const System& system, std::span<const double> y,
                               const Evaluation& at) {
  const NetworkModel& model = c.models.network;
  std::vector<double> atol(system.size(), 1.0);
  parallel_for(system.solid.size(), [&](std::size_t id) {
    if (system.stores[id] != 0)
      atol[id] =
          model.temperature_tolerance *
          chemistry::heat_capacity(system.solid[id], at.temperature[id], delta_of(system, y, id));
  });
  for (std::size_t k = 0; k < system.reactants.size(); ++k)
    atol[system.delta_begin() + k] = model.delta_tolerance;
  for (const WallProfile& wall : system.profiles) {
    const auto& column = system.nodes->columns[wall.surface];
    for (std::size_t j = 0; j < column.size(); ++j)
      atol[system.cell_begin() + wall.first_cell + j] =
          model.temperature_tolerance * column.capacity[j] * wall.area;
  }
  for (std::size_t zone = 0; zone < system.zones(); ++zone) {
    const double volume =
        zone < system.pores.layers.size() ? system.pores.layers[zone].volume : system.free_volume;
    const double pascal = volume / (gas_constant * at.gas.zone_temperature[zone]);  // [mol/Pa]
    double* const of_zone = atol.data() + system.gas_begin() + 3 * zone;
    of_zone[0] = of_zone[1] = model.relative_tolerance * pascal;
    of_zone[2] = model.relative_tolerance * volume;  // [J], U ~ p V
  }
  return atol;
}

// What the relative tolerance is of, for the three unknowns of a gas zone: its oxygen; all of
// its moles for nitrogen, of which the last traces drive nothing; its energy counted from 0 K
// (diatomic), since U is zero at some 420 K, where nothing happens.
Vec3 measures(const double* gas) {
  const double moles = std::abs(gas[0]) + std::abs(gas[1]);
  return {std::abs(gas[0]), moles,
          std::abs(gas[2] + moles * chemistry::enthalpy_from_zero(chemistry::enthalpy_zero))};
}

// The gas of the pores follows its granules at once, and ln p of their equilibrium changes by some
// 0.036/K: this multiple of the relative tolerance [1] is then 0.015 K of theirs at 1e-4, a fifth
// of what the same 1e-4 of their own enthalpy is.
constexpr double pores_part = 5.0;

// Weights 1/(rtol |y| + atol) of CVODES' root mean square norm. The gas' unknowns stand for
// whole zones of it and must not drown among the particles': each weighs as if it were alone.
void weigh_unknowns(const System& system, double relative, const std::vector<double>& absolute,
                    In y, Out weight) {
  const std::size_t gas = system.gas_begin();
  parallel_for(gas,
               [&](std::size_t k) { weight[k] = 1.0 / (relative * std::abs(y[k]) + absolute[k]); });
  const double alone = std::sqrt(static_cast<double>(y.size()));
  for (std::size_t zone = gas; zone < y.size(); zone += 3) {
    const Vec3 measure = measures(y.data() + zone);
    const double part = (zone < system.chamber_begin() ? pores_part : 1.0) * relative;
    for (std::size_t k = 0; k < 3; ++k)
      weight[zone + k] =
          alone / (part * measure[static_cast<Eigen::Index>(k)] + absolute[zone + k]);
  }
}

// All rates one after the other, and back.
std::vector<double> as_vector(const FluxRates& rates) {
  std::vector<double> values;
  for_each_flux(rates.sums,
                [&](const char*, const char*, const double& flux) { values.push_back(flux); });
  for_each_part(rates.by, [&](const char*, const char*, const std::vector<double>& part) {
    values.insert(values.end(), part.begin(), part.end());
  });
  return values;
}

void add_fluxes(std::span<const double> integral, State& state) {
  std::size_t k = 0;
  for_each_flux(state.fluxes,
                [&](const char*, const char*, double& flux) { flux += integral[k++]; });
  for_each_part(state.breakdown, [&](const char*, const char*, std::vector<double>& part) {
    for (double& flux : part) flux += integral[k++];
  });
}

// The evaluation at the point that was asked for last: CVODES wants rates, quadratures and the
// Jacobian at the same (t, y), one after the other.
class EvaluationCache {
 public:
  explicit EvaluationCache(const System& system) : system_(system) {}

  // False where y lies outside the domain of the physics.
  bool evaluate_at(double t, In y) {
    if (is_valid_ && has_heat_ && is_here(t, y)) return true;
    has_heat_ = true;
    return evaluate_anew(t, y, evaluate);
  }
  // The heat that each node receives is then that of the evaluation before, which for quadratures
  // is at Newton's last but one iterate, less than newton_limit of the tolerance away.
  bool evaluate_at_without_heat(double t, In y) {
    if (is_valid_ && is_here(t, y)) return true;
    has_heat_ = false;
    return evaluate_anew(t, y, evaluate_without_heat);
  }
  const Evaluation& at() const { return at_; }

 private:
  bool is_here(double t, In y) const {
    return t == t_ && std::equal(y.begin(), y.end(), y_.begin());
  }
  template <class Evaluate>
  bool evaluate_anew(double t, In y, const Evaluate& physics) {
    is_valid_ = physics(system_, t, y, at_);
    t_ = t;
    y_.assign(y.begin(), y.end());
    return is_valid_;
  }

  const System& system_;
  Evaluation at_;
  double t_ = 0.0;
  std::vector<double> y_;
  bool is_valid_ = false, has_heat_ = false;
};

}  // namespace

NetworkWork advance_network(const Case& c, const Nodes& nodes, const Outlook& outlook,
                            std::vector<HeatLink> links, const PoreSpace& pores, double from,
                            double until, State& state, StopToken stop) {
  const System system = assemble_system(c, nodes, state, outlook, std::move(links), pores);
  std::vector<double> y = pack(system, state);
  if (y.empty()) return {};
  EvaluationCache cache(system);
  if (!cache.evaluate_at(from, y))
    throw NumericsError("heat and reaction network: its state lies outside the physics at t = " +
                        std::to_string(from) + " s");
  const RowSums sums(system);

  OdeProblem problem;
  problem.rate = [&](double t, In now, Out rate) {
    if (!cache.evaluate_at(t, now)) return false;
    fill_rates(system, cache.at(), rate);
    return true;
  };
  problem.quadrature = [&](double t, In now, Out rate) {
    if (!cache.evaluate_at_without_heat(t, now)) return false;
    const auto values = as_vector(flux_rates(system, cache.at()));
    std::copy(values.begin(), values.end(), rate.begin());
    return true;
  };
  problem.linearise = [&](double t, In now) -> std::shared_ptr<const Linearisation> {
    if (!cache.evaluate_at(t, now)) return nullptr;
    return std::make_shared<const Linearisation>(system, sums, t, now, cache.at());
  };
  const std::vector<double> absolute = tolerances(c, system, y, cache.at());
  problem.weigh = [&](In now, Out weight) {
    weigh_unknowns(system, c.models.network.relative_tolerance, absolute, now, weight);
  };
  if (system.closed && c.chamber->pump && !std::isfinite(state.set_point_at))
    problem.event = [&, reached = c.chamber->pump->set_point * (1.0 + chemistry::control_band)](
                        double t, In now) {
      return gas_rates(system, t, now.subspan(system.gas_begin())).pressure - reached;
    };
  problem.quadratures = as_vector({{}, empty_breakdown(system.groups)}).size();
  problem.stop = stop;
  // What passes the border: from the chamber, or from the pores into open air.
  problem.strict_from = system.closed ? system.chamber_begin() : system.gas_begin();

  const OdeResult result = integrate(problem, y, from, until, state.network_step);
  unpack(system, y, state);
  add_fluxes(result.quadrature, state);
  // While the bed moves the mechanics keeps the masses of the charge: its course then depends on no
  // temperature, and one mixing serves many thermal cases (the change is below 1e-3).
  if (state.phase == Phase::react) renew_masses(c, state.particles);
  state.network_step = result.next_step;
  return {result.steps, result.rate_calls, result.newton, result.krylov, result.event_at};
}

}  // namespace pmr::coupling
