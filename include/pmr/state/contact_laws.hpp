// Laws of contacts by name: two closed sets, of which a run has one law each. The equations are
// overloads on these types in physics/contact_force.hpp.
#pragma once
#include <variant>

namespace pmr {

// Hertz with damping, tangential spring with history, Coulomb friction.
struct HertzCoulomb {
  static constexpr const char* name = "hertz";
};
using ForceLaw = std::variant<HertzCoulomb>;

// Elastic-plastic spring without damping: type C of Ai et al., Powder Technol. 206 (2011) 269.
struct Epsd2 {
  static constexpr const char* name = "epsd2";
};
// Constant directional torque: type A of Ai et al.
struct Cdt {
  static constexpr const char* name = "cdt";
};
using RollingLaw = std::variant<Epsd2, Cdt>;

struct ContactModel {
  ForceLaw force;
  RollingLaw rolling;
};

}  // namespace pmr
