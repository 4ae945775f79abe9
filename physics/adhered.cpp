#include "physics/adhered.hpp"

#include <algorithm>

#include "physics/contact_law.hpp"
#include "physics/neighbours.hpp"

namespace pmr::physics {
namespace {

constexpr double nowhere = 1e9;  // [m] where empty places stand

std::vector<Pose> poses_of(const Walls& walls, double t) {
  std::vector<Pose> all;
  for (const Body& body : walls.bodies) all.push_back(pose(body.motion, t));
  return all;
}

// The order of particles that stand where the grains do.
std::vector<std::uint32_t> order_of(const std::vector<Grain>& grains) {
  Particles at;
  resize(at, grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    at.id[k] = static_cast<ParticleId>(k);
    at.position[k] = grains[k].centre;
  }
  return spatial_order(at);
}

Kinetics moved_with(const Pose& body, const Vec3& x) {
  return {body.velocity_at(x), 0.0, body.spin, 0.0};
}

}  // namespace

std::vector<Vec3> adhered_places(const Walls& walls, double t) {
  const std::vector<Pose> bodies = poses_of(walls, t);
  std::vector<Vec3> places;
  places.reserve(walls.grains.size());
  for (const Grain& grain : walls.grains)
    places.push_back(bodies[grain.body].to_world(grain.centre));
  return places;
}

AdheredGrains::AdheredGrains(const Case& c) : walls_(c.walls) {
  if (walls_.grains.empty()) return;
  for (const std::uint32_t k : order_of(walls_.grains)) {
    const Grain& grain = walls_.grains[k];
    spheres_.sphere.push_back({grain.centre, grain.radius});
    spheres_.label.push_back({ContactLaws::kind_of_adhered(c, grain.material),
                              first_adhered_id + static_cast<ParticleId>(k)});
  }
  for (const Grain& grain : walls_.grains) body_.push_back(grain.body);
}

void AdheredGrains::join(double t, Spheres& spheres, std::vector<Block>& blocks) const {
  if (empty()) return;
  const std::size_t first = (spheres.size() + run_length - 1) / run_length * run_length;
  spheres.sphere.resize(first, {Vec3::Constant(nowhere), 0.0});
  spheres.kinetics.resize(first, {Vec3::Zero(), 0.0, Vec3::Zero(), 0.0});
  spheres.label.resize(first, spheres_.label.front());
  const std::vector<Pose> bodies = poses_of(walls_, t);
  for (std::size_t k = 0; k < spheres_.size(); ++k) {
    const Pose& body = bodies[body_of(spheres_.label[k])];
    const Vec3 x = body.to_world(spheres_.sphere[k].position);
    spheres.sphere.push_back({x, spheres_.sphere[k].radius});
    spheres.kinetics.push_back(moved_with(body, x));
    spheres.label.push_back(spheres_.label[k]);
  }
  spheres.load.resize(spheres.size());
  spheres.adhered_from = first;
  for (Block block : cut(spheres_.size())) {
    block.number = static_cast<std::uint32_t>(blocks.size());
    block.first += static_cast<std::uint32_t>(first);
    block.last += static_cast<std::uint32_t>(first);
    blocks.push_back(block);
  }
}

Passage AdheredGrains::follow(const Spheres& spheres, std::span<const Load> loads,
                              const Block& block, double t, double dt, double passed,
                              Places& after) const {
  const std::vector<Pose> bodies = poses_of(walls_, t);
  const std::size_t offset = spheres.size() - spheres_.size();
  Passage passage;
  Box block_box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
  VelocityRange of_block;
  for (std::uint32_t first = block.first; first < block.last; first += run_length) {
    const std::uint32_t last = std::min(block.last, first + run_length);
    Box box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    VelocityRange range;
    for (std::uint32_t i = first; i < last; ++i) {
      const Load& load = loads[i - block.first];
      const Kinetics& now = spheres.kinetics[i];
      passage.contact_work += passed * (load.force.dot(now.velocity) + load.torque.dot(now.spin));
      const Pose& body = bodies[body_of(spheres.label[i])];
      const Vec3 x = body.to_world(spheres_.sphere[i - offset].position);
      after.sphere[i] = {x, spheres.sphere[i].radius};
      after.kinetics[i] = moved_with(body, x);
      range.include(Vec3((x - spheres.sphere[i].position) / dt));
      box.low = box.low.cwiseMin(x);
      box.high = box.high.cwiseMax(x);
    }
    after.run_box[first / run_length] = box;
    after.run_velocity[first / run_length] = range;
    block_box.low = block_box.low.cwiseMin(box.low);
    block_box.high = block_box.high.cwiseMax(box.high);
    of_block.include(range);
  }
  after.block_box[block.number] = block_box;
  after.block_velocity[block.number] = of_block;
  return passage;
}

void AdheredGrains::add_impulse(const Spheres& spheres, std::span<const Load> loads,
                                const Block& block, double passed,
                                std::span<Wrench> impulse) const {
  for (std::uint32_t i = block.first; i < block.last; ++i)  // what they bear, the body bears
    add_reaction(loads[i - block.first], spheres.sphere[i].position, -passed,
                 impulse[body_of(spheres.label[i])]);
}

}  // namespace pmr::physics
