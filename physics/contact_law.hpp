// Contact laws of the materials of a case (the law itself: contact_force.hpp).
#pragma once
#include <cstdint>
#include <vector>

#include "physics/contact_force.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/materials.hpp"

namespace pmr::physics {

ContactLaw contact_law(const Material& a, const Material& b, const PairContact& pair);

// 1/Y* = (1 - nu_a^2)/Y_a + (1 - nu_b^2)/Y_b [Pa], softened moduli.
double effective_young(const Material& a, const Material& b);

// One contact under a force law and a rolling law: `evaluate` of both.
using SingleContact = ContactForce<double> (*)(const ContactLaw&, const Touch<double>&,
                                               const double& dt, Springs<double>&);
SingleContact single_contact(const ContactModel& model);

// Laws of all pairs of kinds of spheres and of all species with all wall materials. Kinds are the
// species, then the materials of adhered grains in the order in which they first appear.
class ContactLaws {
 public:
  explicit ContactLaws(const Case& c);
  static std::uint32_t kind_of_adhered(const Case& c, std::uint32_t material);
  std::size_t kinds() const { return kinds_; }
  const ContactModel& model() const { return model_; }
  // Of kind i with kind j at [i * kinds + j].
  const std::vector<ContactLaw>& pairs() const { return pairs_; }
  const ContactLaw& with_wall(std::uint32_t species, std::uint32_t material) const {
    return walls_[species * materials_ + material];
  }

 private:
  ContactModel model_;
  std::size_t kinds_, materials_;
  std::vector<ContactLaw> pairs_, walls_;
};

// Restitution of a contact between unlike materials from those of like pairs: the mean of the
// squares, weighed crosswise with (Y/(1-nu^2) sqrt(R))^(2/3), the share of a body's deformation
// being the larger the softer it is (demonstrator study, eq. 9; with equal moduli eq. 10).
struct RestitutionSide {
  double restitution;  // [1] of the like pair
  double radius;       // [m]
  double young;        // [Pa]
  double poisson;      // [1]
};
double composite_restitution(const RestitutionSide& a, const RestitutionSide& b);

}  // namespace pmr::physics
