// Contacts between particles: the lists of candidates and the forces of those that touch.
//
// A block knows every pair that one of its particles takes part in; a pair that crosses two blocks
// stands in both and is evaluated in both, with its particles in the same order and so to the same
// bits, each block adding up the loads of its own particles. Blocks therefore need nothing of each
// other within a sub-step, and no sum depends on threads.
//
// There are two lists, as in molecular dynamics codes: the wide one, searched anew when any two
// particles may have come closer by its skin; and per block the near one of those pairs that may
// touch within a few sub-steps, thinned out from the wide one when the block and its neighbours
// have moved. Only near pairs carry springs and are evaluated.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/contact_law.hpp"
#include "physics/pair_kernel.hpp"
#include "physics/spheres.hpp"
#include "physics/wide_list.hpp"
#include "pmr/state/contacts.hpp"

namespace pmr::physics {

class PairContacts {
 public:
  explicit PairContacts(const ContactLaws& laws);

  // Lists all pairs whose surfaces are closer than `skin` [m], with the springs of `history`.
  void open(const Spheres& spheres, const std::vector<Block>& blocks, double skin,
            const ContactHistory& history);

  // The same anew for particles that have moved since, with the springs that they have now.
  void refresh(const Spheres& spheres, const std::vector<Block>& blocks, double skin);

  // Springs of the touching pairs, rows in the particles' order.
  ContactHistory history(const Spheres& spheres) const;

  // To be called after every drift by dt [s], velocities of which were in `ranges` [blocks]: keeps
  // block b's near list such that it holds all of its touching pairs.
  void follow(std::size_t b, const Spheres& spheres, std::span<const VelocityRange> ranges,
              double dt);

  // Adds the forces of block b's touching pairs to the loads of its particles; moves the springs
  // by dt [s].
  ContactBook add_forces(std::size_t b, const Spheres& spheres, double dt, std::span<Load> loads);

 private:
  struct Lists {
    Block block;
    WideList wide;
    std::vector<PairGroup> near;  // all groups but the last are full
    double skin = 0.0;            // [m] of the near list
    double gone = 0.0;            // [m] bound on how much closer its pairs have come since
    double closer = 0.0;          // [m] likewise in the last drift
  };
  struct Remembered;  // springs of touching pairs, in rows of the block's particles
  struct ListedPair {
    std::uint32_t own, partner;
  };
  // By law; pairs that touch stand before the others.
  using PairsByLaw = std::vector<std::vector<ListedPair>>;

  Remembered remembered(const Lists& lists) const;
  Remembered remembered(const Lists& lists, const Spheres& spheres,
                        const ContactHistory& history) const;
  void thin_out(Lists& lists, const Spheres& spheres, const Remembered& springs) const;
  static void append(Lists& lists, const Remembered& springs, std::uint32_t law,
                     std::span<const ListedPair> pairs);

  std::vector<ContactLaw> laws_;  // [species * species]
  std::uint32_t species_;
  PairKernel kernel_;
  double skin_ = 0.0;  // [m] of the wide lists
  std::vector<Lists> lists_;
};

// History for particles in a new order: row i becomes what was row order[i].
ContactHistory reordered(const ContactHistory& history, const std::vector<std::uint32_t>& order);

// History without the partners `gone`, ascending or not, few.
ContactHistory without(const ContactHistory& history, const std::vector<ParticleId>& gone);

}  // namespace pmr::physics
