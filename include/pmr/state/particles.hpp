// The spheres, as a structure of arrays in spatial order. The index is today's place; the id is for
// life: ids are 0..inserted-1 and never reused.
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr {

using ParticleId = std::uint32_t;
using SpeciesIndex = std::uint8_t;

struct Particles {
  std::vector<ParticleId> id;         // [1]
  std::vector<SpeciesIndex> species;  // [1] index into Case::species
  std::vector<double> radius;         // [m]
  std::vector<double> mass;           // [kg] falls as oxygen leaves
  std::vector<Vec3> position;         // [m]
  std::vector<Vec3> velocity;         // [m/s]
  std::vector<Vec3> spin;             // [rad/s]
  std::vector<Vec3> force;            // [N] at the end of the last sub-step
  std::vector<Vec3> torque;           // [N m] likewise
  std::vector<double> formula_units;  // [mol] of oxide (of its Fe or Ce), constant; 0 if inert
  std::vector<double> delta;          // [1] oxygen non-stoichiometry; 0 for inert particles
  std::vector<double> enthalpy;       // [J] of the solid, zero of chemistry/solids.hpp
  std::vector<double> temperature;    // [K] follows from enthalpy and delta

  std::size_t size() const { return id.size(); }
};

// Names each field once, with its unit, for HDF5, restart, reorder, resize and hash.
// visit(name, unit, vector&).
template <class P, class Visitor>
void for_each_field(P& p, Visitor&& visit) {
  visit("id", "1", p.id);
  visit("species", "1", p.species);
  visit("radius", "m", p.radius);
  visit("mass", "kg", p.mass);
  visit("position", "m", p.position);
  visit("velocity", "m s-1", p.velocity);
  visit("spin", "rad s-1", p.spin);
  visit("force", "N", p.force);
  visit("torque", "N m", p.torque);
  visit("formula_units", "mol", p.formula_units);
  visit("delta", "1", p.delta);
  visit("enthalpy", "J", p.enthalpy);
  visit("temperature", "K", p.temperature);
}

// New places hold zeros; the caller fills every field.
inline void resize(Particles& particles, std::size_t count) {
  const auto zero = []<class T>(const std::vector<T>&) {
    if constexpr (std::is_same_v<T, Vec3>)
      return Vec3(Vec3::Zero());
    else
      return T{};
  };
  for_each_field(particles,
                 [&](const char*, const char*, auto& field) { field.resize(count, zero(field)); });
}

}  // namespace pmr
