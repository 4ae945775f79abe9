// One granule at a held temperature in the network, against an integration of its own.
#include <cmath>

#include "chemistry/kinetics.hpp"
#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"
#include "verify/check.hpp"
#include "verify/coupling_scenes.hpp"

namespace pmr::verify {
namespace {

constexpr double granule_temperature = 400.0 + zero_celsius;  // [K]
constexpr double start = 0.2264;                              // [1] delta in equilibrium with air
constexpr double low = 1e3, high = 21e3;                      // [Pa] of oxygen

// Runge-Kutta of fourth order, steps of 1 ms: its error is below 1e-10 (halving changes the 12th
// digit).
class Integration {
 public:
  explicit Integration(const Material& material) : material_(material) {}
  void advance(double duration, double pressure) {
    const auto steps = static_cast<int>(std::lround(duration / 1e-3));
    const double h = duration / steps;
    const auto rate = [&](double d) {
      return chemistry::delta_rate(material_, {granule_temperature, d, pressure});
    };
    for (int k = 0; k < steps; ++k) {
      const double k1 = rate(delta), k2 = rate(delta + 0.5 * h * k1);
      const double k3 = rate(delta + 0.5 * h * k2), k4 = rate(delta + h * k3);
      delta += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
  }
  double delta = start;

 private:
  const Material& material_;
};

// Open air of pure oxygen, and a wall that holds the granule's temperature.
Case in_oxygen() {
  Case c = redox_case(0.735e-3);
  std::get<PowerRate>(c.materials.list[0].redox->rate).factor = 1.0;
  c.species[0].initial_delta = start;
  c.materials.list[0].redox->density_delta =
      start;  // mass and formula units as the lone rate has them
  c.chamber =
      ChamberCase{1e9, 1.0, low, 1.0, granule_temperature, 0.0, std::nullopt, std::nullopt, 0.0};
  return c;
}

}  // namespace

std::vector<Check> granule_checks() {
  ThermalScene scene(in_oxygen());
  scene.add(Vec3(0, 0, 0), granule_temperature);
  scene.add_plate(granule_temperature);
  scene.begin();
  const Material& material = scene.setup.materials.list[0];
  Integration alone(material);
  const auto both = [&](double duration) {
    scene.advance(duration, {{0, scene.nodes.patch(0), 1e3, 0.0}});
    alone.advance(duration, scene.setup.chamber->pressure);
  };
  const char* const source = "an integration of its own, Runge-Kutta with an error below 1e-10";
  std::vector<Check> checks;
  const auto check = [&](const char* id, const char* what) {
    checks.push_back({id, what, scene.state.particles.delta[0], alone.delta, 1e-6, "1", source});
  };
  both(27.2);
  check("coupling.granule.t50", "delta of a granule at 400 degC into 1000 Pa after 27.2 s (t50)");
  both(129.9 - 27.2);
  check("coupling.granule.t90", "The same after 129.9 s (t90)");
  scene.setup.chamber->pressure = high;
  both(5.0);
  check("coupling.granule.reversed", "5 s after a step of the oxygen pressure to 21 kPa");
  both(60.0);
  check("coupling.granule.restored", "65 s after that step, nearly where it began");
  return checks;
}

}  // namespace pmr::verify
