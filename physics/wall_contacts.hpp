// Contacts of particles with walls that may move.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact_law.hpp"
#include "physics/motion.hpp"
#include "physics/spheres.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/contacts.hpp"

namespace pmr::physics {

// A sphere has one contact with each surface it overlaps, at the surface's nearest point, except
// that a point which also lies on a surface with a deeper contact counts only there: over the
// shared edge of flat or convex surfaces there is one contact, in a concave corner one per side.
// Springs are kept by surface; a contact that is new takes over the springs of a contact of the
// same body that ends in the same step under a similar normal, so they follow across triangles.
class WallContacts {
 public:
  explicit WallContacts(const Case& c);

  // Moves the walls to time t [s].
  void place(double t);

  // Bound on how far any wall moves within the domain in [t0, t1] [m].
  double displacement_bound(double t0, double t1) const;

  // Lists the surfaces closer than `skin` [m] to each particle as the walls stand, present or not.
  void rebuild(const Spheres& spheres, double skin, const ContactHistory& history);

  // Springs of the touching walls, rows in the particles' order.
  ContactHistory history() const;

  // Sets all loads to the forces of the walls, and moves the springs by dt [s].
  ContactBook set_forces(Spheres& spheres, const ContactLaws& laws, double dt);

 private:
  // One surface as a sphere meets it.
  struct Meeting {
    std::uint32_t slot;
    Vec3 point;      // [m] nearest point of the surface
    Vec3 n;          // [1] from it to the centre
    double overlap;  // [m] negative where they are apart
  };
  static constexpr std::size_t most_meetings = 32;  // surfaces that one sphere can touch at once
  struct Meetings {
    Meeting list[most_meetings];
    std::size_t count = 0;
  };

  Vec3 nearest(std::uint32_t surface, const Vec3& x) const;
  void find_rows_near(std::span<const Sphere> group, double skin,
                      std::vector<std::uint32_t>& found);
  Meetings meet(const Sphere& sphere, std::size_t row) const;
  void drop_shared(Meetings& meetings, double radius) const;
  Springs inherited(const Meeting& fresh, const Sphere& sphere, std::size_t row);
  void add_forces_on(Spheres& spheres, std::size_t i, const ContactLaws& laws, double dt,
                     ContactBook& book);
  void push(Spheres& spheres, std::size_t i, const Meeting& met, const ContactLaws& laws, double dt,
            ContactBook& book);

  const Case& case_;
  Box domain_;
  std::vector<Pose> pose_;             // [bodies] now
  std::vector<std::uint8_t> present_;  // [surfaces] now

  std::vector<std::uint32_t> start_, surface_;  // rows of candidates, by surface
  std::vector<std::uint8_t> touches_;           // [slots] since the last force pass
  std::vector<Springs> springs_;                // [slots] meaningful while touching
  std::vector<ContactBook> book_;               // [blocks] scratch
};

}  // namespace pmr::physics
