// Checks of the coupled network: relaxations with closed forms, equilibrium, closed books.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "chemistry/chamber.hpp"
#include "chemistry/redox.hpp"
#include "coupling/linearisation.hpp"
#include "coupling/network.hpp"
#include "coupling/retrace.hpp"
#include "coupling/sum_keeper.hpp"
#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"
#include "sim/ledger.hpp"
#include "verify/check.hpp"
#include "verify/coupling_scenes.hpp"

namespace pmr::verify {
namespace {

using coupling::HeatLink;

// MercuryDPM's self test: two balls, R 50 um, rho 1050, c 1200, k 0.12, overlap 0.1 R, conductance
// k pi R overlap/(2R - overlap): T = 421.15 +- 10 exp(-3.00752 t) K.
Check two_balls() {
  const double radius = 50e-6, overlap = 0.1 * radius, k = 0.12;
  ThermalScene scene(inert_case(constant_solid(1050.0, 1200.0, k), radius));
  scene.add(Vec3(0, 0, 0), 431.15);
  scene.add(Vec3(2.0 * radius - overlap, 0, 0), 411.15);
  scene.begin();
  const double conductance = k * pi * radius * overlap / (2.0 * radius - overlap);
  scene.advance(0.5, {{0, 1, conductance, 0.0}});
  return {"coupling.two-balls",
          "Two touching balls relax along their closed form, temperature after 0.5 s",
          scene.state.particles.temperature[0],
          421.15 + 10.0 * std::exp(-3.00752 * 0.5),
          1e-3,
          "K",
          "closed form; rate 3.00752 1/s from MercuryDPM's self test of its heat conduction; "
          "tolerance: ten times the solver's 1e-4 K"};
}

// A row of ten balls between plates at 0 and 50 degC ends as a straight line.
Check ten_balls() {
  const double radius = 5e-3;
  ThermalScene scene(inert_case(constant_solid(2500.0, 300.0, 3000.0), radius));
  for (int i = 0; i < 10; ++i) scene.add(Vec3(2.0 * radius * i, 0, 0), zero_celsius);
  scene.add_plate(zero_celsius);
  scene.add_plate(zero_celsius + 50.0);
  scene.begin();
  std::vector<HeatLink> links;
  for (std::uint32_t i = 0; i + 1 < 10; ++i) links.push_back({i, i + 1, 2.0, 0.0});
  links.push_back({0, scene.nodes.patch(0), 2.0, 0.0});
  links.push_back({9, scene.nodes.patch(1), 2.0, 0.0});
  scene.advance(500.0, links);
  double worst = 0.0;
  for (int i = 0; i < 10; ++i)
    worst =
        std::max(worst, std::abs(scene.state.particles.temperature[static_cast<std::size_t>(i)] -
                                 zero_celsius - 50.0 * (i + 1) / 11.0));
  return {"coupling.ten-balls",
          "Ten balls between plates at 0 and 50 degC end on a straight line, worst deviation",
          worst,
          0.0,
          1e-3,
          "K",
          "closed form of the steady series of equal conductances (geometry: Lethe's line of ten "
          "balls); tolerance: ten times the solver's 1e-4 K"};
}

// Mean temperature of a sphere that cools in a film, over its first difference [1]: Fourier series
// in the roots of z cot z = 1 - Bi (Carslaw & Jaeger).
double cooling_sphere(double biot, double fourier) {
  double sum = 0.0;
  for (int n = 1; n <= 30; ++n) {
    const auto f = [&](double z) { return z * std::cos(z) - (1.0 - biot) * std::sin(z); };
    double low = (n - 1) * pi + 1e-9, high = n * pi - 1e-9;
    for (int k = 0; k < 100; ++k) {
      const double z = 0.5 * (low + high);
      (f(low) * f(z) > 0.0 ? low : high) = z;
    }
    const double z = low, wave = std::sin(z) - z * std::cos(z);
    sum += 4.0 * wave / (2.0 * z - std::sin(2.0 * z)) * std::exp(-z * z * fourier) * 3.0 * wave /
           (z * z * z);
  }
  return sum;
}

Check shells() {
  const double radius = 5e-3, density = 2500.0, heat = 800.0, k = 1.0, biot = 0.5, fourier = 0.2;
  Case c = inert_case(constant_solid(density, heat, k), radius);
  c.models.conduction = ConductionModel{true, false, 0.5, 0.6, 6};
  ThermalScene scene(c);
  scene.add(Vec3(0, 0, 0), 1300.0);
  scene.add_plate(300.0);
  scene.begin();
  auto links = coupling::conduct(scene.setup, scene.nodes, scene.state);
  links.push_back({0, scene.nodes.patch(0), biot * k * 4.0 * pi * radius, 0.0});  // h A, Bi = h R/k
  scene.advance(fourier * radius * radius * density * heat / k, links);
  return {"coupling.shells",
          "A ball of six shells cools in a film, Biot number 0.5: mean temperature",
          scene.state.particles.temperature[0],
          300.0 + 1000.0 * cooling_sphere(biot, fourier),
          1.0,
          "K",
          "Fourier series; six shells are 0.7 K off, an isothermal ball 18 K"};
}

// dT/dt = -eps sigma A T^4/(m c) into cold surroundings: T = (T0^-3 + 3 eps sigma A t/(m
// c))^(-1/3).
Check radiating_ball() {
  const double radius = 1e-3, density = 3000.0, heat = 1000.0, start = 1200.0, t = 20.0;
  Material grey = constant_solid(density, heat, 5.0);
  grey.emissivity.table = constant(0.8);
  Case c = inert_case(grey, radius);
  c.models.radiation = RadiationModel{100.0, 100.0, 1.0, 1.0, 1.0};
  ThermalScene scene(c);
  scene.add(Vec3(0, 0, 0), start);
  scene.begin();
  scene.state.exchange = coupling::retrace(scene.setup, scene.nodes, scene.state, 100.0);
  scene.advance(t, {});
  const double rate = 0.8 * stefan_boltzmann * 3.0 / (radius * density * heat);
  return {"coupling.radiating-ball",
          "A lone ball cools by radiation into surroundings at 1 K, temperature after 20 s",
          scene.state.particles.temperature[0],
          std::pow(std::pow(start, -3.0) + 3.0 * rate * t, -1.0 / 3.0),
          1e-2,
          "K",
          "closed form of grey cooling; tolerance: solver's 1e-6 of the enthalpy's range, the 1 K "
          "surroundings matter below 1e-9 K"};
}

// n = n0 exp(-S t/V) whatever the temperature does, as long as the pump is unthrottled.
Check pump_down() {
  Case c = inert_case(constant_solid(1000.0, 1000.0, 1.0), 1e-3);
  c.chamber = ChamberCase{
      0.0, 1e-3, 101325.0, 0.21, 300.0, 0.0, Pump{0.0, constant(1e-4), 1e-9, 1e-6, 1.0}, {}, 0.0};
  ThermalScene scene(c);
  scene.add(Vec3(0, 0, 0), 300.0);
  scene.begin();
  coupling::close_chamber(scene.setup, scene.state);
  const double volume = coupling::gas_free_volume(scene.setup, scene.state);
  const double before = scene.state.gas.oxygen + scene.state.gas.nitrogen;
  scene.advance(6.0, {});
  return {"coupling.pump-down",
          "A pump of constant speed empties a chamber exponentially, fraction left after 6 s",
          (scene.state.gas.oxygen + scene.state.gas.nitrogen) / before,
          std::exp(-1e-4 * 6.0 / volume),
          1e-5,
          "1",
          "closed form n = n0 exp(-S t/V); tolerance: the solver's 1e-6 times the decay's e-folds"};
}

// A granule in a small closed chamber comes to equilibrium with its own oxygen.
std::vector<Check> closed_granule() {
  Case c = redox_case(0.735e-3);
  c.chamber = ChamberCase{0.0, 5e-7, 1000.0, 0.21, 900.0, 0.0, std::nullopt, std::nullopt, 0.0};
  ThermalScene scene(c);
  scene.add(Vec3(0, 0, 0), 1150.0);
  scene.begin();
  coupling::close_chamber(scene.setup, scene.state);
  for (int k = 0; k < 10; ++k) scene.advance(10.0, {});
  const Particles& p = scene.state.particles;
  const auto& redox = *scene.setup.materials.list[0].redox;
  const auto gas = coupling::atmosphere(scene.setup, scene.state);
  const sim::Balance balance = sim::close_books(scene.setup, scene.state);
  return {{"coupling.closed-granule.equilibrium",
           "A granule in a closed chamber ends with p_eq = pO2, ratio",
           gas.oxygen_fraction * gas.pressure /
               chemistry::equilibrium_pressure(redox.equilibrium, p.temperature[0], p.delta[0]),
           1.0, 1e-4, "1", "second law; tolerance: dlnp/ddelta of 140 times 1e-6 of the solver"},
          {"coupling.closed-granule.oxygen",
           "Its oxygen, in solid and gas, is conserved, relative to what was released",
           balance.oxygen_relative, 0.0, sim::oxygen_limit, "1",
           "conservation; limit of every run's books"},
          {"coupling.closed-granule.energy",
           "Its energy, in solid and gas, is conserved, relative to the solid's enthalpy",
           std::abs(balance.energy_residual / scene.state.opening.energy), 0.0, sim::energy_limit,
           "1", "conservation; limit of every run's books"}};
}

// Spheres in a box whose walls have their temperature: nothing may happen.
Check isothermal_box() {
  Case c = inert_case(constant_solid(3000.0, 1000.0, 5.0), 1e-3);
  c.materials.list[0].emissivity.table = constant(0.7);
  c.models.conduction = ConductionModel{true, true, 0.5, 0.6};
  c.models.radiation = RadiationModel{10.0, 10.0, 1.0, 1.0, 1273.15};
  ThermalScene scene(c);
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        scene.add(Vec3(x, y, z) * 1.99e-3, 1273.15);  // overlapping by 1 %
  scene.add_box(Vec3(-0.95e-3, -0.95e-3, -0.95e-3), Vec3(7e-3, 7e-3, 7e-3), 1273.15);
  scene.begin();
  scene.state.exchange = coupling::retrace(scene.setup, scene.nodes, scene.state, 10.0);
  scene.advance(1000.0, coupling::conduct(scene.setup, scene.nodes, scene.state));
  double drift = 0.0;
  for (const double T : scene.state.particles.temperature)
    drift = std::max(drift, std::abs(T - 1273.15));
  return {"coupling.isothermal",
          "A closed isothermal bed stays isothermal over 1000 s, ten rays a particle, drift",
          drift,
          0.0,
          1e-9,
          "K",
          "second law; symmetric exchange makes it exact but for rounding"};
}

// What stands round two granules that react, a link between them and one to the gas.
enum class GasAround { open_air, chamber, pores_in_air, pores_in_chamber };

struct ReactingPair {
  explicit ReactingPair(GasAround around) : scene(with_chamber()) {
    scene.add(Vec3(0, 0, 0), 1100.0);
    scene.add(Vec3(0, 0, 1.4e-3), 1000.0);
    scene.begin();
    coupling::PoreSpace pores;
    if (around == GasAround::pores_in_air || around == GasAround::pores_in_chamber) {
      const coupling::PoreLayer layer{4e-6, 1.4e-3, 2e-9, 1e-10, 1e-4, 0.3, 1e-3};
      pores = {{layer, layer}, {0, 1}, {1.0, 1.0}};
      coupling::fill_pores(scene.setup, scene.nodes, pores, scene.state);
    }
    if (around == GasAround::chamber || around == GasAround::pores_in_chamber)
      coupling::close_chamber(scene.setup, scene.state);
    system = coupling::assemble_system(
        scene.setup, scene.nodes, scene.state, coupling::look_ahead(scene.setup, scene.state, 0.0),
        {{0, 1, 1e-3, 2e-3}, {0, scene.nodes.gas(), 0.0, 1e-4}}, pores);
  }
  static Case with_chamber() {
    Case c = redox_case(0.735e-3);
    c.chamber = ChamberCase{
        0.0, 5e-7, 5000.0, 0.21, 900.0, 0.0, Pump{0.0, constant(1e-8), 10.0, 1000.0, 1.0}, {}, 0.0};
    return c;
  }
  ThermalScene scene;
  coupling::System system;
};

constexpr std::array surroundings{std::pair{GasAround::open_air, "open"},
                                  std::pair{GasAround::chamber, "closed"},
                                  std::pair{GasAround::pores_in_air, "pores-open"},
                                  std::pair{GasAround::pores_in_chamber, "pores-closed"}};

// Sums over a vector of unknowns: energy [J], oxygen in the solids and in the gas [mol].
Vec3 sums_of(const coupling::System& system, const std::vector<double>& v) {
  Vec3 sums = Vec3::Zero();
  for (std::size_t k = 0; k < system.solid.size(); ++k) sums[0] += v[k];
  for (std::size_t k = 0; k < system.reactants.size(); ++k)
    sums[1] -= 0.5 * system.reactants[k].formula_units * v[system.delta_begin() + k];
  for (std::size_t first = system.gas_begin(); first < system.size(); first += 3) {
    sums[0] += v[first + 2];
    sums[2] += v[first];
  }
  return sums;
}

// A poor solution of (I - gamma J) x = b, mended: its sums, and each granule's own oxygen, by the
// product itself.
Check kept_sums(GasAround around, const std::string& name) {
  const ReactingPair pair(around);
  const coupling::System& system = pair.system;
  const auto y = coupling::pack(system, pair.scene.state);
  const double gamma = 0.3;  // [s]
  coupling::Evaluation at;
  coupling::evaluate(system, 1.0, y, at);
  const coupling::RowSums sums(system);
  const auto J = std::make_shared<const coupling::Linearisation>(system, sums, 1.0, y, at);
  std::vector<double> b(y.size()), x(y.size()), product(y.size());
  for (std::size_t k = 0; k < y.size(); ++k) {
    b[k] = 1e-5 * y[k] * (k % 2 == 0 ? 1.0 : -0.7);
    x[k] = 1e-5 * y[k] * (k % 3 == 0 ? 0.4 : 0.9);
  }
  // Relative to the sums; with pores to what is summed up: flows through them are far larger than
  // what comes of them.
  const auto worst_sum = [&] {
    coupling::product(*J, x, product);
    std::vector<double> held = x, gross = x;
    for (std::size_t k = 0; k < held.size(); ++k) {
      held[k] -= gamma * product[k];
      gross[k] = std::abs(b[k]) + std::abs(gamma * product[k]);
    }
    double worst = 0.0;
    for (std::size_t k = system.delta_begin(); k < system.cell_begin(); ++k)
      worst = std::max(worst, std::abs((b[k] - held[k]) / gross[k]));
    const Vec3 wanted = sums_of(system, b), missing = wanted - sums_of(system, held);
    const Vec3 scale = system.pores.is_resolved() ? sums_of(system, gross) : wanted;
    for (Eigen::Index k = 0; k < (system.zones() > 0 ? 3 : 2); ++k)
      worst = std::max(worst, std::abs(missing[k] / scale[k]));
    return worst;
  };
  const double before = worst_sum();
  coupling::SumKeeper(J, gamma).mend(b, x);
  return {
      "coupling.kept_sums." + name,
      "A linear solve's sums of energy and oxygen and each granule's own, once mended (they were " +
          std::to_string(before) + " off)",
      worst_sum(),
      0.0,
      1e-11,
      "1",
      "conservation; the sums are taken with the Jacobian's product"};
}

// J v against central differences of the right-hand side, in a random direction.
Check jacobian(GasAround around, const std::string& name) {
  const ReactingPair pair(around);
  const coupling::System& system = pair.system;
  const ThermalScene& scene = pair.scene;
  const auto y = coupling::pack(system, scene.state);
  std::vector<double> v(y.size()), product(y.size()), up(y.size()), down(y.size());
  for (std::size_t k = 0; k < y.size(); ++k) v[k] = 1e-5 * y[k] * (k % 2 == 0 ? 1.0 : -0.7);
  coupling::Evaluation at;
  coupling::evaluate(system, 1.0, y, at);
  const coupling::RowSums sums(system);
  coupling::product(coupling::Linearisation(system, sums, 1.0, y, at), v, product);
  const auto rates = [&](double sign, std::vector<double>& out) {
    std::vector<double> shifted = y;
    for (std::size_t k = 0; k < y.size(); ++k) shifted[k] += sign * v[k];
    coupling::evaluate(system, 1.0, shifted, at);
    coupling::fill_rates(system, at, out);
  };
  rates(1.0, up);
  rates(-1.0, down);
  double worst = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double difference = 0.5 * (up[k] - down[k]);
    worst =
        std::max(worst, std::abs(product[k] - difference) / std::max(std::abs(difference), 1e-12));
  }
  return {"coupling.jacobian." + name,
          "The Jacobian's product agrees with central differences, worst relative deviation",
          worst,
          0.0,
          1e-4,
          "1",
          "definition; tolerance: rates are of third order in a step of 1e-5 with d ln p of 100"};
}

}  // namespace

std::vector<Check> coupling_checks() {
  std::vector<Check> checks{two_balls(),      ten_balls(), shells(),
                            radiating_ball(), pump_down(), isothermal_box()};
  for (const auto& [around, name] : surroundings) {
    checks.push_back(jacobian(around, name));
    checks.push_back(kept_sums(around, name));
  }
  for (Check& check : closed_granule()) checks.push_back(std::move(check));
  return checks;
}

}  // namespace pmr::verify
