// Pluviation: particles that rain into the run from a source, one after another.
#pragma once
#include <vector>

#include "pmr/base/errors.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::physics {

double begin_of_run(const Case& c);  // [s] of one that inserts its particles

// When each poured particle is due, a function of the case alone: particle k of a species enters
// when its source has given the particles before it, by mass or by number; all species by time.
struct Entry {
  double due;  // [s]
  SpeciesIndex species;
  double radius;  // [m]
};
std::vector<Entry> entries(const Case& c);

// All particles to be poured, in the order of their entry, with ids from `first`; at rest at the
// origin until they enter.
Particles waiting_particles(const Case& c, ParticleId first);

// Moves the waiting particles that are due at state.time into the run: at random places of their
// source that are free of other particles, with the source's velocity. One that finds no free place
// waits, and those behind it, until the next call. Number that came in.
std::size_t pour(const Case& c, const std::vector<Entry>& entries, State& state);

// Sources that are too narrow for their largest particle, that lie outside the domain, or that are
// not done when the motion ends.
std::vector<Fault> pouring_faults(const Case& c);

}  // namespace pmr::physics
