// Contacts between particles: the list of candidates and the forces of those that touch.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/contact_law.hpp"
#include "physics/spheres.hpp"
#include "pmr/state/contacts.hpp"

namespace pmr::physics {

// A pair stands once, in the row of its lower id; rows are sorted by the partner's id. Each
// particle also knows in which slots it is the partner (`reverse`, sorted by the owner's id), so
// that its force is a gather in an order that depends neither on the list nor on threads.
class PairContacts {
 public:
  // Lists all pairs whose surfaces are closer than `skin` [m], with the springs of `history`.
  void rebuild(const Spheres& spheres, double skin, const ContactHistory& history);

  // Springs of the touching pairs, rows in the particles' order.
  ContactHistory history(const Spheres& spheres) const;

  // Adds the forces of all touching pairs to the loads of their owners and keeps the reactions.
  // Moves the springs by dt [s].
  ContactBook add_forces(Spheres& spheres, const ContactLaws& laws, double dt);

  // Adds to particle i the reactions of the contacts whose partner it is.
  void gather_reactions(std::size_t i, Load& load) const {
    for (std::uint32_t k = reverse_start_[i]; k < reverse_start_[i + 1]; ++k) {
      const std::uint32_t slot = reverse_[k];
      if (!touches_[slot]) continue;
      load.force -= reaction_[slot].force;
      load.torque += reaction_[slot].torque;
    }
  }

 private:
  struct Reaction {
    Vec3 force;   // [N] on the owner
    Vec3 torque;  // [N m] on the partner
  };
  void find_rows(const Spheres& spheres, double skin);
  void link_reverse(const std::vector<std::uint32_t>& owner);
  void load_springs(const Spheres& spheres, const ContactHistory& history);
  std::size_t find_hits(const Spheres& spheres, std::uint32_t first, std::uint32_t last);
  ContactBook add_forces_of(Spheres& spheres, const ContactLaws& laws, double dt, std::size_t first,
                            std::size_t count);

  std::vector<std::uint32_t> start_, partner_;          // rows of candidates
  std::vector<std::uint32_t> reverse_start_, reverse_;  // slots where i is the partner
  std::vector<std::uint8_t> touches_;                   // [slots] since the last force pass
  std::vector<Springs> springs_;                        // [slots] meaningful while touching
  std::vector<Reaction> reaction_;                      // [slots] likewise
  std::vector<std::uint32_t> owner_;                    // [slots] whose row it is in
  std::vector<std::uint32_t> hit_;                      // [slots] scratch: touching ones of a block
  std::vector<ContactBook> book_;                       // [blocks] scratch
};

// History for particles in a new order: row i becomes what was row order[i].
ContactHistory reordered(const ContactHistory& history, const std::vector<std::uint32_t>& order);

// History without the partners `gone`, ascending or not, few.
ContactHistory without(const ContactHistory& history, const std::vector<ParticleId>& gone);

}  // namespace pmr::physics
