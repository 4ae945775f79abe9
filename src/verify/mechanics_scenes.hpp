// Small scenes for the checks of the mechanics: two spheres, or one and a plane.
#pragma once
#include "physics/mechanics.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::verify {

// Species of the demonstrator study's table 1, its contact parameters, and the coated wall.
inline constexpr SpeciesIndex granule = 0, bead = 1;
inline constexpr std::uint32_t coated_wall = 2;  // material
inline double radius_of(SpeciesIndex species) { return species == bead ? 1.495e-3 : 0.735e-3; }
inline constexpr double start_gap = 1e-9;  // [m] between surfaces at the start
inline constexpr const char* liggghts =
    "LIGGGHTS 3.8.0 (Debian), hertz + tangential history + epsd2";

// No walls, no gravity, no particles; moduli softened to 5 MPa as in the study.
Case study_case(double time_step);

// The plane z = 0, facing up.
void add_floor(Case& c);

// One species of one material (modulus [Pa], density [kg/m3]) against a wall of modulus `wall`.
struct OneMaterial {
  double radius;   // [m]
  double young;    // [Pa]
  double poisson;  // [1]
  double density;  // [kg/m3]
  double wall;     // [Pa] modulus of the wall
  PairContact contact;
};
Case one_material_case(const OneMaterial& m, double time_step);

void add_particle(Case& c, SpeciesIndex species, const Vec3& position, const Vec3& velocity,
                  const Vec3& spin = Vec3::Zero());

// A state at time 0 with the case's particles, and the machine that moves it.
class Scene {
 public:
  explicit Scene(Case c);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void advance(std::uint64_t sub_steps) { mechanics_.advance(state, sub_steps, timings_); }
  bool is_touching() const {
    return !state.pair_contacts.partner.empty() || !state.wall_contacts.partner.empty();
  }
  std::size_t place_of(ParticleId id) const;  // index today

 private:
  Case case_;
  Timings timings_;
  physics::Mechanics mechanics_;

 public:
  State state;
};

// What a sub-step by sub-step look at a collision gives; stops when the contact is over.
struct Collision {
  double peak_force = 0.0;  // [N] on particle 0
  double duration = 0.0;    // [s] from the first to the last step with contact, plus one step
};
Collision watch_collision(Scene& scene, double time_step, std::uint64_t most_steps);

}  // namespace pmr::verify
