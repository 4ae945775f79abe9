#include "physics/spheres.hpp"

namespace pmr::physics {

Spheres gather_spheres(const Particles& p) {
  Spheres s;
  s.sphere.resize(p.size());
  s.kinetics.resize(p.size());
  s.label.resize(p.size());
  s.load.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double inverse_mass = 1.0 / p.mass[i];
    const double inverse_inertia = 2.5 * inverse_mass / (p.radius[i] * p.radius[i]);
    s.sphere[i] = {p.position[i], p.radius[i]};
    s.kinetics[i] = {p.velocity[i], inverse_mass, p.spin[i], inverse_inertia};
    s.label[i] = {p.species[i], p.id[i]};
    s.load[i] = {p.force[i], 0.0, p.torque[i], 0.0};
  }
  return s;
}

void put_back(const Spheres& s, Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.position[i] = s.sphere[i].position;
    p.velocity[i] = s.kinetics[i].velocity;
    p.spin[i] = s.kinetics[i].spin;
    p.force[i] = s.load[i].force;
    p.torque[i] = s.load[i].torque;
  }
}

}  // namespace pmr::physics
