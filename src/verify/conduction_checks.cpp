// Contact, gap and wall conduction against closed forms.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/bed_conductivity.hpp"
#include "physics/conduction.hpp"
#include "physics/gap.hpp"
#include "physics/wall_column.hpp"
#include "pmr/base/constants.hpp"
#include "verify/check.hpp"
#include "verify/reference_materials.hpp"
#include "verify/resolved_lens.hpp"

namespace pmr::verify {
namespace {

using namespace physics;

constexpr double ideal_solid = std::numeric_limits<double>::infinity();  // [W/m/K] of a solid

Check closed_form(std::string id, std::string what, double measured,
                  std::pair<double, double> expected, std::string unit) {
  const char* const source = "closed form";
  return {std::move(id),
          std::move(what),
          measured,
          expected.first,
          expected.second * std::abs(expected.first),
          std::move(unit),
          source};
}

// phi of the bed that gives the lens of a sphere (R = 1, plane at distance D1) the radius r_l.
double solid_fraction_of_lens(double lens_radius, double D1) {
  const double r_ij = lens_radius * D1 / std::sqrt(1.0 - lens_radius * lens_radius);
  return std::pow(0.560 / r_ij, 3.0);
}

// Orientation values of the VDI Heat Atlas' equations, to two digits: 3 mm spheres of 6 W/m/K with
// an emissivity of 0.8, porosity 0.4, in air at 1000 K.
void add_packed_bed(std::vector<Check>& checks) {
  constexpr double air = 0.0675;  // [W/m/K]
  const std::pair<const char*, std::pair<double, double>> cases[] = {
      {"1atm", {1.1e-6, 1.05}}, {"1000Pa", {1.1e-4, 0.84}}, {"vacuum", {1.1, 0.56}}};
  for (const auto& [name, figures] : cases)
    checks.push_back(
        {std::string("conduction.packed-bed.") + name, "Zehner-Bauer-Schl\u00fcnder bed, 1000 K",
         zehner_bauer_schluender({0.6, 3e-3, 6.0, 0.8, 1000.0, air, figures.first}), figures.second,
         0.03 * figures.second, "W/m/K",
         "VDI Heat Atlas D6.3, evaluated apart; the flattening of contacts and air's properties "
         "differ"});
}

void add_gap(std::vector<Check>& checks) {
  // Steel in air, alumina and SrFeO3 in oxygen at 1 atm, 1000 and 10 Pa; unlike spheres, walls,
  // gaps, spots. Radii and gas conductivity 1.
  const struct {
    const char* name;
    GapPair pair;
    GapMedium medium;
  } lenses_held[] = {{"steel.air", {1.0, 1.0, 2.0, 0.0, 0.6}, {1600.0, 1600.0, 1.0, 5e-5}},
                     {"alumina.1atm", {1.0, 1.0, 2.0, 0.0, 0.6}, {100.0, 100.0, 1.0, 3e-4}},
                     {"alumina.1000Pa", {1.0, 1.0, 2.0, 0.0, 0.6}, {100.0, 100.0, 1.0, 0.04}},
                     {"alumina.10Pa", {1.0, 1.0, 2.0, 0.0, 0.6}, {100.0, 100.0, 1.0, 4.0}},
                     {"srfeo3.1atm", {1.0, 1.0, 2.0, 0.0, 0.6}, {20.0, 20.0, 1.0, 6e-4}},
                     {"srfeo3.1000Pa", {1.0, 1.0, 2.0, 0.0, 0.6}, {20.0, 20.0, 1.0, 0.08}},
                     {"poor", {1.0, 1.0, 2.0, 0.0, 0.6}, {5.0, 5.0, 1.0, 5e-5}},
                     {"unlike", {1.0, 2.03, 3.03, 0.0, 0.6}, {20.0, 100.0, 1.0, 3e-4}},
                     {"worst", {1.0, 2.03, 3.03, 0.0, 0.5}, {633.0, 128.0, 1.0, 5.7e-5}},
                     {"wall", {1.0, plane_wall, 1.0, 0.0, 0.6}, {50.0, 1.0, 1.0, 1e-3}},
                     {"apart", {1.0, 1.0, 2.02, 0.0, 0.6}, {50.0, 50.0, 1.0, 1e-3}},
                     {"far", {1.0, 1.0, 3.0, 0.0, 0.6}, {7.0, 7.0, 1.0, 1e-3}},
                     {"wall.far", {1.0, plane_wall, 3.0, 0.0, 0.6}, {20.0, 1.0, 1.0, 1e-3}},
                     {"spot", {1.0, 1.0, 2.0, 0.005, 0.6}, {1600.0, 1600.0, 1.0, 5e-5}},
                     {"spot.1000Pa", {1.0, 1.0, 2.0, 0.005, 0.6}, {100.0, 100.0, 1.0, 0.04}},
                     {"spot.wide", {1.0, 1.3, 2.3, 0.03, 0.7}, {165.0, 165.0, 1.0, 2e-4}},
                     {"spot.wall", {1.0, plane_wall, 1.0, 0.01, 0.6}, {50.0, 1e12, 1.0, 1e-3}},
                     {"spot.vacuum", {1.0, 1.0, 2.0, 0.005, 0.6}, {1e9, 1e9, 1.0, 1.0}}};
  for (const auto& [name, pair, medium] : lenses_held) {
    const double resolved = resolved_conductance(pair, medium);
    const auto law = pair_conductance(pair, medium);
    checks.push_back({std::string("conduction.lens.resolved.") + name,
                      "Spot and lens against conduction resolved in both bodies",
                      law.contact + law.gas, resolved, 0.03 * resolved, "1",
                      "rings and Legendre polynomials (verify/resolved_lens.hpp); 3 %"});
  }
  // The resolved solution itself: a spot in vacuum has 2 k a, less what the spheres add.
  const GapPair touching{1.0, 1.0, 2.0, 0.005, 0.6};
  checks.push_back(closed_form(
      "conduction.lens.resolved.2ka", "Resolved spot in vacuum against that of half-spaces, 2 k a",
      resolved_conductance(touching, {1e9, 1e9, 1.0, 1.0}), {2.0 * 1e9 * 0.005, 0.015}, "1"));
  const std::pair<double, double> lenses[] = {
      {1e-3, 32.098332}, {1e-2, 18.063955}, {1e-1, 6.336426}};
  for (const auto& [h, conductance] : lenses) {
    const GapPair pair{1.0, plane_wall, 1.0 + h, 0.0, solid_fraction_of_lens(0.6, 1.0 + h)};
    const GapMedium medium{ideal_solid, ideal_solid, 1.0, 0.0};
    checks.push_back(closed_form("conduction.lens." + std::to_string(std::lround(h * 1000)) + "e-3",
                                 "Gas lens between an ideal sphere and a plane",
                                 gap_conductance(pair, medium), {conductance, 2e-5}, "1"));
  }
  const GapPair pair{1.0, 1.0, 2.0, 0.0, solid_fraction_of_lens(0.6, 1.0)};
  checks.push_back(closed_form("conduction.lens.jump", "Gas lens of touching spheres, jump 0.01 R",
                               gap_conductance(pair, {ideal_solid, ideal_solid, 1.0, 0.01}),
                               {11.096545, 2e-5}, "1"));
}

void add_softening(std::vector<Check>& checks) {
  const Material alumina = reference_alumina(), ferrite = reference_ferrite();
  const auto softening = [&](const char* id, const Material& a, const Material& b, double value) {
    checks.push_back({std::string("conduction.softening.") + id,
                      "True over soft contact radius at equal force", contact_softening(a, b),
                      value, 5e-5, "1", "(Y*_soft/Y*_real)^(1/3) by hand, three digits"});
  };
  softening("al2o3", alumina, alumina, 0.0259);
  softening("srfeo3", ferrite, ferrite, 0.0460);
  softening("mixed", alumina, ferrite, 0.0386);
  const std::pair<double, double> values[] = {{20, 20.0}, {400, 8.0}, {700, 5.4}, {1000, 4.3}};
  for (const auto& [celsius, k] : values)
    checks.push_back({"conduction.al2o3.k." + std::to_string(static_cast<int>(celsius)) + "C",
                      "Conductivity of 92 % alumina",
                      conductivity(alumina.conductivity, celsius + zero_celsius, bar), k, 0.02 * k,
                      "W/m/K", "Munro 1997 times 0.6, by hand, two digits"});
}

// What acts on the face of a semi-infinite wall.
struct FaceLoad {
  double film;         // [W/m2/K] to a gas
  double temperature;  // [K] of that gas
  double flux;         // [W/m2] besides
};

// A column of constant properties and the means to step it implicitly, by its own functions.
class Transient {
 public:
  Transient(double density, double heat, double k)
      : materials_{{constant_solid(density, heat, k)}, {}},
        column_(make_column({{{0, 0.3}}, wall_energy_zero, 0.0, wall_energy_zero}, materials_)),
        energy_(column_.size()),
        temperature_(column_.size()),
        conductance_(column_.size()) {
    initial_energies(column_, 1.0, energy_);
    column_temperatures(column_, 1.0, energy_, temperature_);
    column_conductances(column_, materials_, bar, temperature_, conductance_);
  }

  // To time t [s] from zero, in steps that grow with time (error about the ratio's excess / 2).
  void advance(const FaceLoad& load, double until) {
    constexpr double ratio = 1.001;
    double next = std::max(time_ * ratio, 1e-5);
    for (; next < until; next *= ratio) step(load, next - time_);
    if (until > time_) step(load, until - time_);
  }

  double face() const { return temperature_[0]; }  // [K]
  double flux_in(const FaceLoad& load) const {     // [W/m2]
    return load.film * (load.temperature - face()) + load.flux;
  }

 private:
  // Implicit Euler: (C/dt - J) dT = rates(T), J tridiagonal, by Thomas' algorithm.
  void step(const FaceLoad& load, double dt) {
    const std::size_t n = column_.size();
    std::vector<double> rate(n), upper(n), change(n);
    column_rates(column_, {1.0, flux_in(load)}, temperature_, conductance_, rate);
    for (std::size_t j = 0; j < n; ++j) {
      const double before = j > 0 ? conductance_[j - 1] : 0.0;
      double diagonal = column_.capacity[j] / dt + before + conductance_[j];
      if (j == 0) diagonal += load.film;
      const double pivot = diagonal - before * (j > 0 ? upper[j - 1] : 0.0);
      upper[j] = conductance_[j] / pivot;
      change[j] = (rate[j] + before * (j > 0 ? change[j - 1] : 0.0)) / pivot;
    }
    for (std::size_t j = n - 1; j-- > 0;) change[j] += upper[j] * change[j + 1];
    for (std::size_t j = 0; j < n; ++j) energy_[j] += column_.capacity[j] * change[j];
    column_temperatures(column_, 1.0, energy_, temperature_);
    time_ += dt;
  }

  Materials materials_;
  WallColumn column_;
  std::vector<double> energy_, temperature_, conductance_;  // [J], [K], [W/m2/K]
  double time_ = 0.0;                                       // [s]
};

// Fibre board of constant properties: rho 300, c 1100, k 0.18.
constexpr double rho = 300.0, heat = 1100.0, k = 0.18;  // [kg/m3], [J/kg/K], [W/m/K]
constexpr double diffusivity = k / (rho * heat);        // [m2/s]

void add_convective_face(std::vector<Check>& checks) {
  const std::pair<double, double> values[] = {
      {0.1, 0.103543}, {0.5, 0.384310}, {1.0, 0.572416}, {2.0, 0.744604}};
  Transient wall(rho, heat, k);
  const double film = k / std::sqrt(diffusivity * 100.0);  // z = 1 after 100 s
  const FaceLoad load{film, wall_energy_zero + 100.0, 0.0};
  for (const auto& [z, theta] : values) {
    wall.advance(load, 100.0 * z * z);
    checks.push_back(
        closed_form("conduction.wall.convective." + std::to_string(std::lround(10.0 * z)) + "e-1",
                    "Face of a semi-infinite wall under a film, 1 - exp(z^2) erfc(z)",
                    (wall.face() - wall_energy_zero) / 100.0, {theta, 5e-3}, "1"));
  }
}

void add_step_and_flux(std::vector<Check>& checks) {
  Transient step(rho, heat, k), heated(rho, heat, k);
  const FaceLoad held{1e8, wall_energy_zero + 1000.0, 0.0}, flux{0.0, 0.0, 1e4};
  const std::pair<const char*, double> step_times[] = {
      {"200ms", 0.2}, {"10s", 10.0}, {"600s", 600.0}};
  for (const auto& [name, t] : step_times) {
    step.advance(held, t);
    checks.push_back(closed_form(std::string("conduction.wall.step.") + name,
                                 "Flux after a step of 1000 K, k dT/sqrt(pi alpha t)",
                                 step.flux_in(held),
                                 {k * 1000.0 / std::sqrt(pi * diffusivity * t), 5e-3}, "W/m2"));
  }
  const std::pair<const char*, double> flux_times[] = {
      {"50ms", 0.05}, {"10s", 10.0}, {"600s", 600.0}};
  for (const auto& [name, t] : flux_times) {
    heated.advance(flux, t);
    checks.push_back(closed_form(std::string("conduction.wall.flux.") + name,
                                 "Rise of the face under 10 kW/m2, 2 q sqrt(alpha t/pi)/k",
                                 heated.face() - wall_energy_zero,
                                 {2.0 * 1e4 * std::sqrt(diffusivity * t / pi) / k, 5e-3}, "K"));
  }
}

}  // namespace

std::vector<Check> conduction_checks() {
  std::vector<Check> checks;
  add_packed_bed(checks);
  add_gap(checks);
  add_softening(checks);
  add_convective_face(checks);
  add_step_and_flux(checks);
  return checks;
}

}  // namespace pmr::verify
