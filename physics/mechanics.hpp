// The discrete element method: Newton's equations of spheres under gravity and contacts, by the
// leapfrog (velocity Verlet): half kick, drift, forces, half kick; second order in the step.
// Forces use the half-step velocities. Gas drag is neglected (demonstrator study).
#pragma once
#include <cstdint>
#include <vector>

#include "physics/contact_law.hpp"
#include "physics/pair_contacts.hpp"
#include "physics/spheres.hpp"
#include "physics/wall_contacts.hpp"
#include "pmr/base/timer.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::physics {

// Advances a state. Holds nothing between calls that the result depends on: at the start of a call
// the particles are put into spatial order and the lists are built anew from the state.
class Mechanics {
 public:
  explicit Mechanics(const Case& c);  // keeps a reference: the case must live on

  double time_step() const { return dt_; }  // [s]

  // Moves the state on by whole sub-steps. Writes the particles' places, motions, forces (of
  // contacts, without weight), both contact histories, time, step, lost, extremes and
  // fluxes.dissipated (see contact_law.hpp). Throws NumericsError, when a particle's motion is no
  // longer finite; the state is then the one before the call (perhaps in another order).
  void advance(State& state, std::uint64_t sub_steps, Timings& timings);

 private:
  struct Stages {
    double kick = 0.0, lists = 0.0, walls = 0.0, pairs = 0.0;  // [s] of wall time
  };
  void open(State& state);
  void close(State& state);
  void kick_and_drift();
  void take_out_lost(double t);
  bool lists_are_due(double t0, double t1);
  void rebuild_lists(const ContactHistory& pairs, const ContactHistory& walls);
  void refresh_lists();
  void wall_forces(double dt);
  void pair_forces(double dt);
  void gather();
  void gather_and_kick();
  void book(const ContactBook& sums);

  const Case& case_;
  double dt_;  // [s]
  ContactLaws laws_;
  WallContacts walls_;
  PairContacts pairs_;

  // Of the current call.
  Spheres spheres_;
  double smallest_ = 0.0;    // [m] radius
  double skin_ = 0.0;        // [m] of the lists in use
  double speed_ = 0.0;       // [m/s] fastest particle in this sub-step
  double gone_ = 0.0;        // [m] bound on a particle's way since the lists were built
  double wall_gone_ = 0.0;   // [m] likewise of the walls
  bool all_inside_ = true;   // in this sub-step
  double dissipated_ = 0.0;  // [J]
  Extremes extremes_;
  std::vector<LostParticle> lost_;
  std::vector<double> fastest_;        // [blocks] scratch, squared speeds
  std::vector<std::uint8_t> outside_;  // [blocks] scratch
};

double kinetic_energy(const Particles& particles);  // [J] of translation and rotation
double rms_speed(const Particles& particles);       // [m/s] sqrt(2 kinetic energy / mass)

}  // namespace pmr::physics
