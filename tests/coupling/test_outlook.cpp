// What coefficients are taken at, and how nodes are numbered in a bed at rest.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "coupling/nodes.hpp"
#include "coupling/outlook.hpp"

using namespace pmr;

namespace {

Particles rows_of(const std::vector<double>& places) {
  Particles p;
  for_each_field(p, [&](const char*, const char*, auto& field) { field.resize(places.size()); });
  for (std::size_t i = 0; i < places.size(); ++i) {
    p.id[i] = static_cast<ParticleId>(places.size() - 1 - i);
    p.radius[i] = 1e-3;
    p.position[i] = Vec3(places[i], 0.0, 0.0);
    p.temperature[i] = 1000.0 + 10.0 * static_cast<double>(i);
  }
  return p;
}

}  // namespace

TEST_CASE("an outlook goes on as the last interval went") {
  const Case c{};
  State state;
  state.particles = rows_of({0.0, 0.01});
  state.opening.particles = 2;
  state.walls.cell_energy = {5.0};
  CHECK(coupling::look_ahead(c, state, 1.0).temperature == state.particles.temperature);

  const coupling::TrendWatch watch(c, state);
  state.particles.temperature = {1004.0, 1002.0};  // + 4 K, - 8 K in 2 s
  state.walls.cell_energy = {7.0};
  watch.set(c, 2.0, state);
  CHECK(state.trend.warming == std::vector<double>{-8.0, 4.0});  // by id
  const auto outlook = coupling::look_ahead(c, state, 1.5);
  CHECK(outlook.temperature[0] == Approx(1007.0));
  CHECK(outlook.temperature[1] == Approx(996.0));
  CHECK(outlook.walls.cell_energy[0] == Approx(8.5));
  CHECK(outlook.gas.pressure == coupling::atmosphere(c, state).pressure);
}

TEST_CASE("nodes in space: each particle has its own, neighbours lie close, the lost come last") {
  constexpr std::size_t alive = 200;  // ids 200 down to 1; 0 is lost
  std::vector<double> places;
  for (std::size_t i = 0; i < alive; ++i) places.push_back(static_cast<double>(i * 77 % alive));
  Particles p = rows_of(places);
  for (ParticleId& id : p.id) ++id;
  coupling::Nodes nodes;
  nodes.particles = alive + 1;
  coupling::number_in_space(p, nodes);
  std::vector<coupling::Node> all = nodes.place;
  std::sort(all.begin(), all.end());
  for (coupling::Node node = 0; node < all.size(); ++node) CHECK(all[node] == node);
  CHECK(nodes.particle(0) == alive);
  for (std::size_t i = 0; i < alive; ++i)  // in a row: its order, but within runs of 32
    CHECK(std::abs(nodes.particle(p.id[i]) - places[i]) < 32.0);
  CHECK(nodes.shell(p.id[1], 2) == nodes.particle(p.id[1]) + 2 * nodes.particles);
}
