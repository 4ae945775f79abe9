// When exchange factors are due to be scaled or traced anew.
#include <catch2/catch.hpp>
#include <cmath>

#include "coupling/retrace.hpp"

using namespace pmr;

TEST_CASE("the way since the last tracing counts in diameters") {
  State state;
  Particles& p = state.particles;
  for_each_field(p, [](const char*, const char*, auto& field) { field.resize(2); });
  p.id = {1, 0};
  p.radius = {1e-3, 2e-3};
  p.position = {Vec3(0.0, 0.0, 1e-3), Vec3(3e-3, 0.0, 0.0)};
  CHECK(std::isinf(coupling::mean_displacement(state)));
  state.exchange.traced_place = {Vec3(3e-3, 4e-3, 0.0), Vec3(0.0, 0.0, 0.0)};
  CHECK(coupling::mean_displacement(state) == Approx(0.5 * (0.5 + 1.0)).epsilon(1e-14));
}

TEST_CASE("a change of emissivity counts by what the node emits") {
  const Case c{};  // no walls
  State state;
  Particles& p = state.particles;
  for_each_field(p, [](const char*, const char*, auto& field) { field.resize(2); });
  p.id = {0, 1};
  p.radius = {1e-3, 2e-3};
  p.temperature = {1200.0, 600.0};
  const coupling::Nodes nodes = coupling::number_nodes(c, 2);
  const std::vector<double> then{0.50, 0.80, 1.0}, now{0.52, 0.70, 1.0};
  // Weights eps r^2 T^4: 0.52 x 1 x 16 against 0.70 x 4 x 1.
  const double expected = (8.32 * 0.02 + 2.8 * 0.1) / (8.32 + 2.8);
  CHECK(coupling::mean_change(c, nodes, state, now, then) == Approx(expected).epsilon(1e-12));
  CHECK(coupling::mean_change(c, nodes, state, now, now) == 0.0);
  CHECK(std::isinf(coupling::mean_change(c, nodes, state, now, {})));
}
