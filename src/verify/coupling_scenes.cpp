#include "verify/coupling_scenes.hpp"

#include <cmath>

#include "coupling/thermal_state.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::verify {
namespace {

Case one_species(Material material, double radius) {
  Case c{};
  material.accommodation = 0.9;
  c.materials.list = {std::move(material)};
  c.materials.pairs = {{0.3, 0.1, 0.5}};
  Species ball{};
  ball.name = "ball";
  ball.diameter = 2.0 * radius;
  ball.initial_temperature = 300.0;
  ball.initial_delta = 0.3;
  c.species = {ball};
  c.domain_low = Vec3(-1, -1, -1);
  c.domain_high = Vec3(1, 1, 1);
  c.models.network = {1e-7, 1e-4, 1e-8};
  c.seed = 1;
  return c;
}

Facet rectangle(const Vec3& corner, const Vec3& a, const Vec3& b) {
  return {{{corner, corner + a, corner + a + b}, {corner, corner + a + b, corner + b}},
          a.cross(b).normalized()};
}

}  // namespace

Case inert_case(Material material, double radius) {
  return one_species(std::move(material), radius);
}

Case redox_case(double radius) {
  Case c = one_species(reference_ferrite(), radius);
  c.models.reaction = true;
  return c;
}

void ThermalScene::add(const Vec3& position, double temperature) {
  Particles& p = state.particles;
  const std::size_t i = p.size();
  resize(p, i + 1);
  p.id[i] = static_cast<ParticleId>(i);
  p.position[i] = position;
  p.radius[i] = 0.5 * setup.species[0].diameter;
  p.mass[i] = setup.materials.list[0].density * 4.0 / 3.0 * pi * std::pow(p.radius[i], 3.0);
  p.temperature[i] = temperature;
}

void ThermalScene::add_plate(double temperature) {
  if (setup.walls.bodies.empty()) setup.walls.bodies.push_back({"frame", Rest{}});
  Surface plate;
  plate.name = "plate";
  plate.shape = rectangle(Vec3(0.5, 0.5, 0.5), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0));
  plate.thermal = FixedTemperature{temperature};
  setup.walls.surfaces.push_back(plate);
}

void ThermalScene::add_box(const Vec3& low, const Vec3& high, double temperature) {
  const Vec3 size = high - low;
  const Vec3 x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  for (const Facet& face :
       {rectangle(low, x, y), rectangle(low, y, z), rectangle(low, z, x), rectangle(high, -y, -x),
        rectangle(high, -z, -y), rectangle(high, -x, -z)}) {
    add_plate(temperature);
    setup.walls.surfaces.back().shape = face;
  }
}

void ThermalScene::begin() {
  nodes = coupling::number_nodes(setup, state.particles.size());
  coupling::begin_thermal_state(setup, nodes, state);
  state.phase = Phase::react;
}

void ThermalScene::advance(double dt, std::vector<coupling::HeatLink> links) {
  coupling::advance_network(setup, nodes, coupling::look_ahead(setup, state, 0.0), std::move(links),
                            {}, state.time, state.time + dt, state);
  state.time += dt;
}

}  // namespace pmr::verify
