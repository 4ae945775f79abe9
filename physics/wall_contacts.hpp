// Contacts of particles with walls that may move.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/blocks.hpp"
#include "physics/contact_law.hpp"
#include "physics/motion.hpp"
#include "physics/pair_kernel.hpp"
#include "physics/spheres.hpp"
#include "physics/wall_feet.hpp"
#include "physics/wall_tree.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/contacts.hpp"

namespace pmr::physics {

// A sphere has one contact with each surface it overlaps, at the surface's nearest point; what is
// one surface, wall_feet.hpp says: the facets of a mesh, patches side by side and surfaces that lie
// on each other are one, the sides of a concave corner are two. Springs are kept by surface; a
// contact that is new takes over the springs of one that ends in the same step under nearly the
// same normal, so they follow over triangles, patches and bodies.
//
// Each block of particles lists the surfaces near its particles and renews the list by itself when
// it or a wall has moved by the list's skin; a surface that was far off at the last look is not
// looked at again before it can have come near.
class WallContacts {
 public:
  explicit WallContacts(const Case& c);

  // Moves the walls to time t [s].
  void place(double t);

  // Bound on how far any wall moves within the domain in [t0, t1] [m].
  double displacement_bound(double t0, double t1) const;

  // Lists the surfaces closer than `skin` [m] to each particle as the walls stand, present or not,
  // with the springs of `history`.
  void open(const Spheres& spheres, const std::vector<Block>& blocks, double skin,
            const ContactHistory& history);

  // Springs of the touching walls, rows in the particles' order.
  ContactHistory history(std::size_t particles) const;

  // To be called after every drift, in which no particle of block b came closer to a wall by more
  // than `closer` [m]: keeps the block's list complete.
  void follow(std::size_t b, const Spheres& spheres, double closer);

  // Adds the forces of the walls to the loads of block b's particles; moves the springs by dt [s].
  // What the particles push back in dt is added to `impulse` [N s, N m s] of each body, where one
  // is given.
  ContactBook add_forces(std::size_t b, const Spheres& spheres, double dt, std::span<Load> loads,
                         std::span<Wrench> impulse = {});

 private:
  struct Slot {
    std::uint32_t surface;
    std::uint32_t first, last;  // triangles of a facet that are near, in List::triangles
    bool touches = false;       // since the last force pass
    bool touches_now = false;   // scratch of a force pass
    double wake = 0.0;          // [m] way of the block up to which it surely does not touch
    Springs<double> springs{};  // meaningful while touching
  };
  struct Row {
    std::uint32_t particle;
    std::uint32_t first, last;  // slots
  };
  struct List {
    Block block;
    std::vector<Row> rows;  // particles near walls, ascending
    std::vector<Slot> slots;
    std::vector<std::uint32_t> triangles;
    double skin = 0.0;      // [m]
    double gone = 0.0;      // [m] bound on the way of any particle towards any wall since
    std::vector<Foot> met;  // scratch: contacts of one sphere, their slots as places
  };
  void relist(List& list, const Spheres& spheres, double skin);
  void list_row(List& list, const Spheres& spheres, std::uint32_t i,
                std::span<const WallPart> near);
  double distance_to(const WallPart& part, const Vec3& x, double reach) const;
  Vec3 nearest(const List& list, const Slot& slot, const Vec3& x) const;
  void meet(List& list, const Row& row, const Sphere& sphere) const;
  Springs<double> inherited(List& list, const Row& row, const Foot& fresh,
                            const Sphere& sphere) const;
  struct Sums {
    ContactBook book;
    std::span<Wrench> impulse;
  };
  template <class Force, class Rolling>
  void add_forces_on(List& list, const Row& row, const Spheres& spheres, double dt, Load& load,
                     Sums& sums) const;
  template <class Force, class Rolling>
  void push(const Spheres& spheres, std::size_t i, const Foot& met, double dt,
            Springs<double>& springs, Load& load, ContactBook& book) const;

  const Case& case_;
  ContactLaws laws_;
  Box domain_;
  WallTree tree_;
  std::vector<Pose> pose_;             // [bodies] now
  std::vector<std::uint8_t> present_;  // [surfaces] now
  double thinnest_ = 0.0;              // [m] skin
  std::vector<List> lists_;            // [blocks]
};

}  // namespace pmr::physics
