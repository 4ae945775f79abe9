// The discrete element method: Newton's equations of spheres under gravity and contacts. Forces use
// the half-step velocities. Gas drag is neglected (demonstrator study).
#pragma once
#include <cstdint>
#include <vector>

#include "physics/adhered.hpp"
#include "physics/blocks.hpp"
#include "physics/leapfrog.hpp"
#include "physics/pair_contacts.hpp"
#include "physics/spheres.hpp"
#include "physics/wall_contacts.hpp"
#include "pmr/base/stop.hpp"
#include "pmr/base/timer.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::physics {

// Advances a state. Holds nothing between calls that the result depends on: at the start of a call
// the particles are put into spatial order and the lists are built anew from the state.
class Mechanics {
 public:
  explicit Mechanics(const Case& c);  // keeps a reference: the case must live on

  double time_step() const { return leapfrog_.dt; }  // [s]

  // What particles did to each body in the mean over the last call of `advance`; empty where the
  // case measures no force on a wall.
  const std::vector<Wrench>& mean_wall_loads() const { return wall_loads_; }

  // Moves the state on by whole sub-steps. Writes the particles' places, motions, forces (of
  // contacts, without weight), both contact histories, time, step, lost, extremes and
  // fluxes.dissipated and elastic_energy (kinetic + potential + elastic
  // energy + dissipated change by the work of moving walls only, adhered grains being part of
  // them). Throws NumericsError, when a particle's motion is no longer finite, and Stopped; the
  // state is then the one before the call (perhaps in another order).
  void advance(State& state, std::uint64_t sub_steps, Timings& timings, StopToken stop = {});

 private:
  struct Stages {
    double kick = 0.0, lists = 0.0, walls = 0.0, pairs = 0.0;  // [s]
  };
  // Of one block in one sub-step.
  struct BlockPass {
    Passage passage;
    ContactBook sums;
    std::vector<Wrench> impulse;  // [bodies] on walls, since the blocks were cut; if measured
    Stages stages;                // of its thread
  };
  void open(State& state);
  void close(State& state);
  void opening_forces();
  void opening_drift(double t);
  void open_blocks(double t);
  void take_out_lost(double t);
  struct Pass {
    double walls_moved;  // [m] at most, in the drift that led here
    double now, next;    // [s] of the places before and after it
    bool is_last;
  };
  void pass(const Pass& at, Stages& stages);
  void pass_block(std::size_t b, const Pass& at);
  Passage move_block(const Block& block, std::span<const Load> loads, const Pass& at);
  bool adheres(const Block& block) const { return block.number >= free_blocks_; }
  void take_over_sums();
  void take_over_motion();
  void take_over_impulses();
  void build_lists(const ContactHistory& pairs, const ContactHistory& walls);

  const Case& case_;
  Leapfrog leapfrog_;
  Box domain_;
  AdheredGrains adhered_;
  WallContacts walls_;
  PairContacts pairs_;

  // Of the current call.
  Spheres spheres_;
  Places after_;                 // places after the pass that is going on
  std::size_t free_ = 0;         // spheres that are particles: the first ones
  std::size_t free_blocks_ = 0;  // of them; blocks of adhered grains follow
  std::vector<Block> blocks_;
  std::vector<BlockPass> pass_;  // [blocks]
  double smallest_ = 0.0;        // [m] radius
  double spread_ = 0.0;          // [m/s] bound on their relative speed in the last drift
  bool all_inside_ = true;       // after the last drift
  double elastic_ = 0.0;         // [J] energy of the Hertz springs
  double dissipated_ = 0.0;      // [J]
  Extremes extremes_;
  std::vector<LostParticle> lost_;
  std::vector<Wrench> wall_loads_;  // [bodies] impulses of the call, at its end the mean load
};

// Leaves the particles at these places in the state, ascending, with their contacts.
void leave_in(State& state, const std::vector<std::uint32_t>& places);

double kinetic_energy(const Particles& particles);  // [J] of translation and rotation
double rms_speed(const Particles& particles);       // [m/s] sqrt(2 kinetic energy / mass)

}  // namespace pmr::physics
