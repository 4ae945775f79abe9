#include "physics/spheres.hpp"

#include <algorithm>

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

void Places::resize(std::size_t particles, std::size_t blocks) {
  sphere.resize(particles);
  kinetics.resize(particles);
  block_box.resize(blocks);
  block_velocity.resize(blocks);
  run_box.resize((particles + run_length - 1) / run_length);
  run_velocity.resize(run_box.size());
}

void bound(Spheres& s, const std::vector<Block>& blocks) {
  s.Places::resize(s.size(), blocks.size());
  const auto box_of = [&](std::size_t first, std::size_t last) {
    Box box{s.sphere[first].position, s.sphere[first].position};
    for (std::size_t i = first; i < last; ++i) {
      box.low = box.low.cwiseMin(s.sphere[i].position);
      box.high = box.high.cwiseMax(s.sphere[i].position);
    }
    return box;
  };
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    s.block_box[b] = box_of(blocks[b].first, blocks[b].last);
    for (std::uint32_t first = blocks[b].first; first < blocks[b].last; first += run_length)
      s.run_box[first / run_length] = box_of(first, std::min(blocks[b].last, first + run_length));
  }
  s.run_velocity.assign(s.run_box.size(), {});
  s.block_velocity.assign(blocks.size(), {});
  for (const Block& block : blocks)
    for (std::uint32_t i = block.first; i < block.last; ++i) {
      s.run_velocity[i / run_length].include(s.kinetics[i].velocity);
      s.block_velocity[block.number].include(s.kinetics[i].velocity);
    }
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
