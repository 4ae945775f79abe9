// Equilibrium, kinetics, heat and rarefaction against closed forms and publications, and the
// adiabatic balance of the mixed and reduced bed, computed here without the network.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "case/case.hpp"
#include "chemistry/gas.hpp"
#include "chemistry/kinetics.hpp"
#include "chemistry/redox.hpp"
#include "chemistry/solids.hpp"
#include "pmr/base/constants.hpp"
#include "verify/check.hpp"
#include "verify/reference_materials.hpp"

namespace pmr::verify {
namespace {

using namespace chemistry;

constexpr double kelvin(double celsius) { return celsius + zero_celsius; }

const char* const vieten_formula =
    "formula of Vieten et al., Energy Environ. Sci. 12 (2019) 1369, evaluated independently";

struct Expected {
  double value;      // [unit]
  double tolerance;  // [1] relative or [unit] absolute, as the function's name says
  const char* unit;
};

Check relative(std::string id, std::string what, double measured, const Expected& expected,
               std::string source) {
  return {std::move(id),
          std::move(what),
          measured,
          expected.value,
          expected.tolerance * std::abs(expected.value),
          expected.unit,
          std::move(source)};
}

Check absolute(std::string id, std::string what, double measured, const Expected& expected,
               std::string source) {
  return {std::move(id),      std::move(what), measured,         expected.value,
          expected.tolerance, expected.unit,   std::move(source)};
}

void add_redox_functions(std::vector<Check>& checks, const RedoxEquilibrium& eq) {
  checks.push_back(relative("chemistry.dh.035", "Reduction enthalpy at delta = 0.35",
                            reduction_enthalpy(eq, 0.35), {85135.4, 1e-5, "J/mol"},
                            vieten_formula));
  checks.push_back(relative("chemistry.dh.040", "Reduction enthalpy at delta = 0.40",
                            reduction_enthalpy(eq, 0.40), {86209.2, 1e-5, "J/mol"},
                            vieten_formula));
  checks.push_back(relative("chemistry.ds.035", "Reduction entropy at delta = 0.35",
                            reduction_entropy(eq, 1000.0, 0.35), {76.8158, 1e-5, "J/mol/K"},
                            vieten_formula));
  checks.push_back(relative("chemistry.p_eq.035", "Equilibrium pressure at delta 0.35, 1000 K",
                            equilibrium_pressure(eq, 1000.0, 0.35) / bar, {0.13517, 1e-3, "bar"},
                            vieten_formula));
  checks.push_back(relative("chemistry.dlnp.040", "d ln p/d delta at delta 0.40, 1000 K",
                            ln_pressure_delta_slope(eq, 1000.0, 0.40), {-40.6165, 1e-4, "1"},
                            vieten_formula));
  checks.push_back(relative("chemistry.dlnp.030", "d ln p/d delta at delta 0.30, 873.15 K",
                            ln_pressure_delta_slope(eq, 873.15, 0.30), {-143.687, 1e-4, "1"},
                            vieten_formula));
  checks.push_back(relative("chemistry.heat.integral", "H(0.45) - H(0.20), closed form",
                            reduction_heat(eq, 0.45) - reduction_heat(eq, 0.20),
                            {19470.15, 1e-6, "J/mol"}, "integral of dh in closed form"));
}

// -(R/2) d ln p/d(1/T) at fixed delta, by central differences, worst case over delta.
double gibbs_helmholtz_error(const RedoxEquilibrium& eq) {
  double worst = 0.0;
  for (double delta = 0.05; delta < 0.49; delta += 0.05) {
    const double T1 = 900.0, T2 = 1100.0;
    const double rise =
        ln_equilibrium_pressure(eq, T2, delta) - ln_equilibrium_pressure(eq, T1, delta);
    const double heat = -0.5 * gas_constant * rise / (1.0 / T2 - 1.0 / T1);
    worst = std::max(worst, std::abs(heat / reduction_enthalpy(eq, delta) - 1.0));
  }
  return worst;
}

// Places where delta_eq does not rise with T or does not fall with pO2.
double monotony_violations(const RedoxEquilibrium& eq) {
  int violations = 0;
  for (double T = 300.0; T <= 1500.0; T += 20.0)
    for (double exponent = -7.0; exponent <= 0.0; exponent += 0.125) {
      const double p = bar * std::pow(10.0, exponent);
      const double here = equilibrium_delta(eq, T, p);
      if (T < 1500.0 && equilibrium_delta(eq, T + 20.0, p) <= here) ++violations;
      if (exponent < 0.0 && equilibrium_delta(eq, T, p * std::pow(10.0, 0.125)) >= here)
        ++violations;
    }
  return violations;
}

// Largest distance from a table of delta_eq that was made independently, to four digits.
double table_deviation(const RedoxEquilibrium& eq) {
  const double pressures[] = {1.0, 0.21, 0.1, 0.01, 1e-3, 1e-4};  // [bar]
  const std::pair<double, std::array<double, 6>> rows[] = {
      {300.0, {0.0672, 0.1020, 0.1224, 0.1957, 0.2569, 0.2826}},
      {400.0, {0.1756, 0.2264, 0.2464, 0.2808, 0.2950, 0.3090}},
      {600.0, {0.2899, 0.3004, 0.3061, 0.3410, 0.4001, 0.4461}},
      {800.0, {0.3348, 0.3760, 0.3956, 0.4436, 0.4717, 0.4863}},
      {1000.0, {0.4133, 0.4437, 0.4547, 0.4776, 0.4892, 0.4949}}};
  double worst = 0.0;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < 6; ++k) {
      const double delta = equilibrium_delta(eq, kelvin(row.first), pressures[k] * bar);
      worst = std::max(worst, std::abs(delta - row.second[k]));
    }
  return worst;
}

void add_equilibrium(std::vector<Check>& checks, const RedoxEquilibrium& eq) {
  const auto at = [&](double celsius, double pressure) {
    return equilibrium_delta(eq, kelvin(celsius), pressure * bar);
  };
  const std::pair<int, double> air[] = {
      {400, 0.22643}, {600, 0.30039}, {700, 0.32688}, {800, 0.37604}};
  for (const auto& [celsius, delta] : air)
    checks.push_back(absolute("chemistry.d_eq.air." + std::to_string(celsius) + "C",
                              "delta in equilibrium with 0.21 bar O2", at(celsius, 0.21),
                              {delta, 2e-5, "1"}, vieten_formula));
  checks.push_back(absolute("chemistry.d_eq.table", "Largest deviation from 30 tabulated delta_eq",
                            table_deviation(eq), {0.0, 6e-5, "1"},
                            "independent evaluation, rounded to four digits"));
  checks.push_back(absolute("chemistry.d_eq.reference", "delta_eq at 400 degC, 0.18 bar is d0",
                            at(400.0, 0.18), {0.2365, 0.008, "1"},
                            "measured reference point of Vieten et al. 2019"));
  checks.push_back(absolute("chemistry.d_eq.published.900C", "delta_eq at 900 degC in air",
                            at(900.0, 0.21), {0.40, 0.035, "1"},
                            "published value; band of the fit's uncertainty"));
  checks.push_back(absolute("chemistry.d_eq.published.1000C", "delta_eq at 1000 degC in air",
                            at(1000.0, 0.21), {0.41, 0.04, "1"},
                            "published value; band of the fit's uncertainty"));
  checks.push_back(absolute("chemistry.gibbs_helmholtz",
                            "Heat from the slope of ln p over 1/T against dh, worst case",
                            gibbs_helmholtz_error(eq), {0.0, 1e-6, "1"}, "thermodynamics"));
  checks.push_back(absolute("chemistry.d_eq.monotonic",
                            "Places in 300-1500 K, 1e-7-1 bar where delta_eq is not monotonic",
                            monotony_violations(eq), {0.0, 0.0, "1"}, "thermodynamics"));
}

void add_heat(std::vector<Check>& checks, const Material& alumina, const Material& ferrite) {
  const char* const nist = "NIST Chemistry WebBook, Shomate equation";
  const char* const janaf = "NIST-JANAF thermochemical tables, 4th ed. (1998)";
  const double rise = specific_enthalpy(alumina, 1373.15) - specific_enthalpy(alumina, 298.15);
  checks.push_back(relative("chemistry.al2o3.cp", "Al2O3 heat capacity at 1000 K",
                            specific_heat(alumina, 1000.0), {1224.86, 1e-4, "J/kg/K"}, nist));
  checks.push_back(relative("chemistry.al2o3.h", "Al2O3 enthalpy from 298.15 to 1373.15 K",
                            rise / 1e3, {1233.44, 1e-4, "kJ/kg"}, nist));
  const double mass = molar_mass(*ferrite.redox, 0.25);
  checks.push_back(relative("chemistry.ferrite.cp", "SrFeO2.75 heat capacity at 1000 K",
                            molar_heat_capacity(ferrite, 1000.0, 0.25) / mass,
                            {720.6, 1e-4, "J/kg/K"}, "Neumann-Kopp sum by hand, four digits"));
  const double heated =
      molar_enthalpy(ferrite, 973.15, 0.25) - molar_enthalpy(ferrite, 298.15, 0.25);
  checks.push_back(relative("chemistry.ferrite.h", "SrFeO2.75 enthalpy from 298.15 to 973.15 K",
                            heated / mass / 1e3, {451.39, 5e-5, "kJ/kg"},
                            "Neumann-Kopp sum by hand, five digits"));
  checks.push_back(relative("chemistry.o2.h", "O2 enthalpy from 298.15 to 1000 K",
                            oxygen_heat(1000.0).enthalpy, {22703.0, 1e-3, "J/mol"}, janaf));
  checks.push_back(relative("chemistry.n2.h", "N2 enthalpy from 298.15 to 1000 K",
                            nitrogen_heat(1000.0).enthalpy, {21463.0, 1e-3, "J/mol"}, janaf));
  const double step =
      oxygen_heat(700.0).enthalpy - oxygen_heat(std::nextafter(700.0, 0.0)).enthalpy;
  checks.push_back(absolute("chemistry.o2.continuous", "O2 enthalpy: jump at 700 K", step,
                            {0.0, 1e-9, "J/mol"}, "the books would show it"));
  checks.push_back(relative(
      "chemistry.mass_lost", "Mass lost per mol O2",
      2.0 * (molar_mass(*ferrite.redox, 0.3) - molar_mass(*ferrite.redox, 0.4)) / 0.1 * 1e3,
      {31.998, 1e-6, "g/mol"}, "atomic weights"));
}

void add_rarefaction(std::vector<Check>& checks) {
  const double lambda = mean_free_path(1.0, 1000.0, 1000.0);
  const double g = jump_length(lambda, 1.32, 0.9);
  const char* const kinetic = "kinetic theory, evaluated independently";
  checks.push_back(relative("chemistry.mean_free_path", "Mean free path, O2, 1000 K, 1000 Pa",
                            lambda * 1e6, {30.62, 1e-3, "um"}, kinetic));
  checks.push_back(relative("chemistry.jump", "Temperature jump length, alpha 0.9, gamma 1.32",
                            g * 1e6, {60.83, 1e-3, "um"}, kinetic));
  const std::pair<const char*, std::array<double, 2>> gaps[] = {{"0", {0.0, 580.8}},
                                                                {"10um", {1e-5, 536.7}},
                                                                {"100um", {1e-4, 318.8}},
                                                                {"1mm", {1e-3, 63.0}}};
  for (const auto& gap : gaps)
    checks.push_back(relative(std::string("chemistry.gap.") + gap.first,
                              "Film of a plane gap, O2, 1000 K, 1000 Pa, k/(L + 2 g)",
                              gas_conductivity(1.0, 1000.0) / (gap.second[0] + 2.0 * g),
                              {gap.second[1], 2e-3, "W/m2/K"}, kinetic));
  const std::pair<int, double> gammas[] = {
      {300, 1.395}, {700, 1.337}, {1000, 1.313}, {1300, 1.300}};
  for (const auto& [T, gamma] : gammas)
    checks.push_back(absolute("chemistry.gamma." + std::to_string(T) + "K",
                              "Ratio of the heat capacities of O2", heat_capacity_ratio(1.0, T),
                              {gamma, 1e-3, "1"}, "handbook values, four digits"));
}

// Simpson's rule.
double integrate(const std::function<double(double)>& f, double from, double to) {
  constexpr int panels = 2000;
  const double h = (to - from) / panels;
  double sum = 0.0;
  for (int k = 0; k < panels; ++k)
    sum += f(from + k * h) + 4.0 * f(from + (k + 0.5) * h) + f(from + (k + 1) * h);
  return sum * h / 6.0;
}

void add_kinetics(std::vector<Check>& checks, Material ferrite) {
  auto& law = std::get<PowerRate>(ferrite.redox->rate);
  law.factor = 1.0;
  const double T = 673.15, start = 0.2264, pressure = 1000.0;
  checks.push_back(relative("chemistry.k1.673K", "Rate constant K1 at 673.15 K",
                            rate_constant(law.factor, law.reduction, T),
                            {8.327e-4, 1e-3, "mol/s/m3/Pa"},
                            "Harrison et al., Energy Fuels 37 (2023) 9487, by hand"));
  const double end = equilibrium_delta(ferrite.redox->equilibrium, T, pressure);
  const auto time_to = [&](double extent) {  // t = int d(delta)/(d delta/dt)
    const auto slowness = [&](double d) { return 1.0 / delta_rate(ferrite, {T, d, pressure}); };
    return integrate(slowness, start, start + extent * (end - start));
  };
  const char* const source = "independent integration of the same law";
  checks.push_back(relative("chemistry.k1.t50", "Half of the way to equilibrium, 400 degC, 1000 Pa",
                            time_to(0.5), {27.2, 0.01, "s"}, source));
  checks.push_back(relative("chemistry.k1.t90", "90 % of the way to equilibrium", time_to(0.9),
                            {129.9, 0.01, "s"}, source));
}

// Half of the oxygen gas's entropy in place of the constant: what the data set's plotting code
// does.
void add_variant_a(std::vector<Check>& checks, RedoxEquilibrium eq) {
  eq.oxygen_entropy.reset();
  for (const auto& [celsius, expected] : {std::pair{900.0, 0.455}, {1000.0, 0.474}})
    checks.push_back(absolute("chemistry.variant_a." + std::to_string(static_cast<int>(celsius)),
                              "delta in air with the entropy of oxygen gas at T, variant A",
                              equilibrium_delta(eq, kelvin(celsius), 0.21 * bar),
                              {expected, 1e-3, "1"}, "independent evaluation, three digits"));
}

// K2 at constant T and pO2 is an exponential; its time constant at 400 degC and 100 K above.
void add_relaxation(std::vector<Check>& checks, Material ferrite) {
  const RelaxationRate law{40.0, 673.15, 144e3, 92e3, 1.0};
  ferrite.redox->rate = law;
  const double pressure = 1000.0;
  const auto relaxed = [&](double T, double start, double duration) {  // Heun's method
    double delta = start;
    constexpr int steps = 20000;
    const double h = duration / steps;
    for (int k = 0; k < steps; ++k) {
      const double first = delta_rate(ferrite, {T, delta, pressure});
      delta += 0.5 * h * (first + delta_rate(ferrite, {T, delta + h * first, pressure}));
    }
    return delta;
  };
  const auto check = [&](const char* id, const char* what, double T, double start, double tau) {
    const double end = equilibrium_delta(ferrite.redox->equilibrium, T, pressure);
    checks.push_back(absolute(id, what, relaxed(T, start, 30.0),
                              {end + (start - end) * std::exp(-30.0 / tau), 1e-8, "1"},
                              "closed form delta_eq + (delta_0 - delta_eq) exp(-t/tau)"));
  };
  check("chemistry.k2.reduction", "delta after 30 s by K2, 400 degC into 1000 Pa", 673.15, 0.2264,
        40.0);
  check("chemistry.k2.oxidation", "delta after 30 s by K2 from 0.4 at 300 degC into 1000 Pa",
        573.15, 0.4, 40.0 * std::exp(92e3 / gas_constant * (1.0 / 573.15 - 1.0 / 673.15)));
}

// The smooth law of SrFeO3 against the same law solved apart.
void add_smooth(std::vector<Check>& checks) {
  const RedoxEquilibrium eq = smooth_equilibrium();
  const struct {
    double celsius, pressure, delta;  // [degC], [bar], [1]
  } points[] = {{350.0, 0.21, 0.1652028},
                {400.0, 0.01, 0.2184038},
                {700.0, 0.21, 0.3140780},
                {900.0, 0.01, 0.4488731},
                {1100.0, 0.9, 0.4184190}};
  for (const auto& [celsius, pressure, delta] : points)
    checks.push_back(absolute("chemistry.smooth." + std::to_string(static_cast<int>(celsius)),
                              "delta of the smooth law of SrFeO3",
                              equilibrium_delta(eq, kelvin(celsius), pressure * bar),
                              {delta, 1e-7, "1"}, "Brent's method apart, seven digits"));
  checks.push_back(relative("chemistry.smooth.heat", "Heat of reduction from delta 0.2 to 0.35",
                            reduction_heat(eq, 0.35) - reduction_heat(eq, 0.2),
                            {12483.212625, 1e-9, "J/mol Fe"}, "adaptive quadrature apart"));
}

// Ceria is another material by data alone: its shipped file against the published formula.
void add_ceria(std::vector<Check>& checks) {
  const Case c = casefile::load_case_text(R"(
title = "Ceria"
gravity = "none"
domain = {low = "-1 -1 -1 m", high = "1 1 1 m"}
[species.grain]
material = "CeO2"
diameter = "1 mm"
count = 1
temperature = "1500 degC"
delta = 0.01
region = {base = "0 0 0 mm", radius = "2 mm", height = "5 mm"}
[fill]
duration = "1 s"
rest_speed = "2 mm/s"
rest_hold = "20 ms"
)",
                                          "ceria", ".", {});
  const Redox& redox = *c.materials.list[c.species[0].material].redox;
  for (const auto& [celsius, pressure] :
       {std::pair{1300.0, 1e-4}, {1500.0, 1e-5}, {1700.0, 1e-3}}) {
    const double filled =
        8700.0 * std::pow(pressure, -0.217) * std::exp(-195.6e3 / (gas_constant * kelvin(celsius)));
    checks.push_back(relative("chemistry.ceria." + std::to_string(static_cast<int>(celsius)),
                              "delta of ceria in oxygen of " + std::to_string(pressure) + " bar",
                              equilibrium_delta(redox.equilibrium, kelvin(celsius), pressure * bar),
                              {0.35 * filled / (1.0 + filled), 1e-4, "1"},
                              "Bulfin et al., J. Phys. Chem. C 117 (2013) 24129: delta/(0.35 - "
                              "delta) = 8700 (p/bar)^-0.217 exp(-195.6 kJ/mol/RT)"));
  }
}

// One kilogram of each, as solids.
struct Bed {
  Solid beads, granules;

  double energy(double T, double delta) const {  // [J]
    return enthalpy(beads, T, 0.0) + enthalpy(granules, T, delta);
  }
  double heat_capacity_at(double T, double delta) const {  // [J/K]
    return heat_capacity(beads, T, 0.0) + heat_capacity(granules, T, delta);
  }
  // T [K] of the whole at `energy` [J].
  double temperature_of(double energy_now, double delta) const {
    double T = 700.0;
    for (int k = 0; k < 50; ++k) T += (energy_now - energy(T, delta)) / heat_capacity_at(T, delta);
    return T;
  }
};

struct AdiabaticEnd {
  double mixed, temperature, delta, oxygen;  // [K], [K], [1], [mol]
};

// Mixed at delta `start`, then reduced to equilibrium with 1000 Pa; oxygen leaves at the bed's
// temperature of that moment: C dT = -n dh d(delta). Heun's method in delta, 20,000 steps.
AdiabaticEnd reduce_adiabatically(const Bed& bed, double mixed, double start) {
  const RedoxEquilibrium& eq = bed.granules.material->redox->equilibrium;
  const double n = bed.granules.amount;
  const auto slope = [&](double T, double delta) {
    return -n * reduction_enthalpy(eq, delta) / bed.heat_capacity_at(T, delta);
  };
  double T = mixed, delta = start;
  constexpr double step = 1e-5;
  while (delta < equilibrium_delta(eq, T, 1000.0)) {
    const double first = slope(T, delta);
    T += 0.5 * step * (first + slope(T + step * first, delta + step));
    delta += step;
  }
  return {mixed, T, delta, 0.5 * n * (delta - start)};
}

struct MixingTarget {
  const char* name;
  double beads, granules, freeze;                  // [degC]
  double mixed, temperature, delta, oxygen, heat;  // [degC], [degC], [1], [mol], [kJ]
};

void add_adiabatic(std::vector<Check>& checks, const Material& alumina, const Material& ferrite,
                   const MixingTarget& target) {
  const RedoxEquilibrium& eq = ferrite.redox->equilibrium;
  const double start = equilibrium_delta(eq, kelvin(target.freeze), 0.21 * bar);
  const Bed bed{{&alumina, 1.0}, {&ferrite, 1.0 / molar_mass(*ferrite.redox, start)}};
  const double energy = enthalpy(bed.beads, kelvin(target.beads), 0.0) +
                        enthalpy(bed.granules, kelvin(target.granules), start);
  const AdiabaticEnd end = reduce_adiabatically(bed, bed.temperature_of(energy, start), start);
  const double heat =
      bed.granules.amount * (reduction_heat(eq, end.delta) - reduction_heat(eq, start));
  const std::string id = std::string("chemistry.adiabatic.") + target.name;
  const char* const source = "independent adiabatic balance of 1 kg + 1 kg at 1000 Pa O2";
  checks.push_back(absolute(id + ".mixed", "Mixing temperature without reaction",
                            end.mixed - zero_celsius, {target.mixed, 0.5, "degC"}, source));
  checks.push_back(absolute(id + ".temperature", "Temperature after the reduction",
                            end.temperature - zero_celsius, {target.temperature, 1.0, "degC"},
                            source));
  checks.push_back(absolute(id + ".delta", "delta after the reduction", end.delta,
                            {target.delta, 1e-3, "1"}, source));
  checks.push_back(relative(id + ".oxygen", "Oxygen released", end.oxygen,
                            {target.oxygen, 0.01, "mol"}, source));
  checks.push_back(relative(id + ".heat", "Heat taken up by the reduction", heat / 1e3,
                            {target.heat, 0.01, "kJ"}, source));
}

}  // namespace

std::vector<Check> chemistry_checks() {
  const Material alumina = reference_alumina(), ferrite = reference_ferrite();
  std::vector<Check> checks;
  add_redox_functions(checks, ferrite.redox->equilibrium);
  add_equilibrium(checks, ferrite.redox->equilibrium);
  add_heat(checks, alumina, ferrite);
  add_rarefaction(checks);
  add_kinetics(checks, ferrite);
  add_variant_a(checks, ferrite.redox->equilibrium);
  add_relaxation(checks, ferrite);
  add_smooth(checks);
  add_ceria(checks);
  const MixingTarget targets[] = {
      {"hot", 1100.0, 700.0, 700.0, 956.1, 922.8, 0.4689, 0.3812, 65.5},
      {"medium", 700.0, 400.0, 400.0, 589.1, 569.6, 0.3242, 0.2602, 37.1},
      {"cold", 400.0, 200.0, 350.0, 325.4, 315.5, 0.2181, 0.1367, 17.6}};
  for (const MixingTarget& target : targets) add_adiabatic(checks, alumina, ferrite, target);
  Material smooth = ferrite;
  smooth.redox->equilibrium = smooth_equilibrium();
  const MixingTarget smooth_targets[] = {
      {"smooth.hot", 1100.0, 700.0, 700.0, 956.1, 923.2, 0.4530, 0.3725, 64.6},
      {"smooth.medium", 700.0, 400.0, 400.0, 589.0, 562.0, 0.3045, 0.3176, 51.2},
      {"smooth.cold", 400.0, 200.0, 350.0, 325.4, 322.0, 0.1813, 0.0426, 6.0}};
  for (const MixingTarget& target : smooth_targets) add_adiabatic(checks, alumina, smooth, target);
  return checks;
}

}  // namespace pmr::verify
