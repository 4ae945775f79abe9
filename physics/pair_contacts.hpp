// Contacts between particles: the lists of candidates and the forces of those that touch.
//
// A block knows every pair that one of its particles takes part in; a pair that crosses two blocks
// stands in both and is evaluated in both, with its particles in the same order and so to the same
// bits, each block adding up the loads of its own particles. Blocks therefore need nothing of each
// other within a sub-step, and no sum depends on threads.
//
// There are two lists, as in molecular dynamics codes: the wide one of all pairs closer than a
// skin, and the near one of those pairs that may touch within a few sub-steps, thinned out from it.
// Only near pairs carry springs and are evaluated. Each run has a wide list and skins that suit the
// velocities around it, so that a fast grain shortens the life of few lists; each block has one
// near list, thinned out when one of its runs asks for it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/contact_law.hpp"
#include "physics/near_pairs.hpp"
#include "physics/pair_kernel.hpp"
#include "physics/spheres.hpp"
#include "physics/wide_list.hpp"
#include "pmr/state/contacts.hpp"

namespace pmr::physics {

class PairContacts {
 public:
  explicit PairContacts(const ContactLaws& laws);

  // Lists the pairs of all blocks, with the springs of `history`. Wide skins are at least `skin`
  // [m]; the velocities and dt [s] say how soon lists will end.
  void open(const Spheres& spheres, const std::vector<Block>& blocks, double dt, double skin,
            const ContactHistory& history);

  // Springs of the touching pairs, rows in the order of the first `particles` spheres: adhered
  // grains have none.
  ContactHistory history(const Spheres& spheres, std::size_t particles) const;

  // To be called after every drift by dt [s], in which no two velocities differed by more than
  // `spread` [m/s]: keeps block b's near list such that it holds all of its touching pairs.
  void follow(std::size_t b, const Spheres& spheres, double spread, double dt);

  // Adds the forces of block b's touching pairs to the loads of its particles; moves the springs
  // by dt [s].
  ContactBook add_forces(std::size_t b, const Spheres& spheres, double dt, std::span<Load> loads);

 private:
  // Holds while bounds on how much closer its pairs have come stay below a reach.
  struct Term {
    double reach = 0.0, gone = 0.0;                       // [m]
    double left() const { return 0.999 * reach - gone; }  // sums round
  };
  struct Run {
    WideList wide;
    Term wide_term;  // reach: the wide list's skin; for pairs with runs around
    Term near_term;  // reach: the near list's skin; likewise
    Term horizon;    // for pairs with all other runs of the blocks around
  };
  struct Lists {
    Block block;
    std::vector<std::uint32_t> around;  // blocks, itself among them
    Term far;  // until what is not around may have come as near as a run's horizon
    std::vector<Run> runs;
    std::vector<PairGroup> near;  // all groups but the last of a law are full
  };
  struct Remembered;  // springs of touching pairs, in rows of the block's particles
  Remembered remembered(const Lists& lists) const;
  Remembered remembered(const Lists& lists, const Spheres& spheres,
                        const ContactHistory& history) const;
  static std::uint32_t number_of(const Lists& lists, const Run& run);
  static double speed_around(const Run& run, const Spheres& spheres);
  static double speed_around(const Lists& lists, const Spheres& spheres);
  void look_around(Lists& lists, const Spheres& spheres) const;
  void renew(Lists& lists, const Spheres& spheres, double dt) const;
  void thin_out(Lists& lists, const Spheres& spheres, const Remembered& springs) const;
  static PairGroup group_of(std::span<const NearPair> pairs, const Block& block,
                            const Remembered& springs);

  std::vector<ContactLaw> laws_;  // [kinds * kinds]
  std::uint32_t kinds_;
  PairKernel kernel_;
  WideSearch search_;
  double thinnest_ = 0.0;  // [m] skin of a wide list
  std::vector<Lists> lists_;
};

// History for particles in a new order: row i becomes what was row order[i].
ContactHistory reordered(const ContactHistory& history, const std::vector<std::uint32_t>& order);

// History without the partners `gone`, ascending or not, few.
ContactHistory without(const ContactHistory& history, const std::vector<ParticleId>& gone);

}  // namespace pmr::physics
