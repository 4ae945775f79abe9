// Grains that adhere to walls: spheres which move as the body does and give way to nothing. They
// meet particles as particles do, with R* = R_i R_j/(R_i + R_j); their inverse mass is zero, so
// that m* = m_i (as LIGGGHTS' fix freeze has it).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/leapfrog.hpp"
#include "physics/motion.hpp"
#include "physics/spheres.hpp"
#include "pmr/state/case.hpp"

namespace pmr::physics {

// Ids of adhered grains count from here: in the history of contacts they stand as partners.
inline constexpr ParticleId first_adhered_id = 0x80000000U;

// Where the adhered grains of a case are at time t [s], in the order of Walls::grains.
std::vector<Vec3> adhered_places(const Walls& walls, double t);

// The grains in the mechanics' working copy: blocks of their own behind those of the particles.
class AdheredGrains {
 public:
  explicit AdheredGrains(const Case& c);
  bool empty() const { return spheres_.size() == 0; }
  // Appends the grains and their blocks, as they stand at time t [s]. Blocks start at multiples of
  // a run, so up to a run of places stays empty between: no block holds them.
  void join(double t, Spheres& spheres, std::vector<Block>& blocks) const;
  // The drift of a block of grains from its places to those at time t [s]; `loads` of the grains
  // have done work at the body's velocity over `passed` [s].
  Passage follow(const Spheres& spheres, std::span<const Load> loads, const Block& block, double t,
                 double dt, double passed, Places& after) const;
  // Adds what the particles do to the grains of a block in `passed` [s] to the bodies' impulses.
  void add_impulse(const Spheres& spheres, std::span<const Load> loads, const Block& block,
                   double passed, std::span<Wrench> impulse) const;
  std::uint32_t body_of(const Label& label) const { return body_[label.id - first_adhered_id]; }

 private:
  const Walls& walls_;
  Spheres spheres_;                  // in spatial order, in the frames of their bodies
  std::vector<std::uint32_t> body_;  // [grains] by id
};

}  // namespace pmr::physics
