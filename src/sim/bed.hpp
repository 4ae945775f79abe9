// A run that starts from particles that are there already: the settled bed of an earlier run, or
// the last frame of a text dump of LIGGGHTS or LAMMPS.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::sim {

struct Bed {
  Particles particles;  // ids 0.. in the order of the source's; heat and chemistry still zero
  ContactHistory pair_contacts, wall_contacts;  // springs; a dump has none
  double time = 0.0;                            // [s] clock at which the run goes on; 0 of a dump
  double rest_since;        // [s] minus infinity of a run's settled bed, infinity of a dump
  double overlap_ratio;     // [1] largest overlap over the smaller radius, with walls too
  std::uint64_t hash;       // [1] of the bytes of the file that was read
  std::string description;  // one line for log and report
};

// The bed that the case names in `bed`. From a run folder: places, radii, motions and springs, bit
// for bit, of the end of its motion; species and walls are matched by name, springs of walls that
// the case has not are dropped. From a dump: its last frame, types matched by Species::dump_type or
// else 1 for the first species by name and so on. Temperatures are the case's, masses follow from
// its densities. Throws CaseError with all faults: unknown species or types, particles outside the
// domain, overlaps of more than half of the radius with
// each other or with walls, nothing left to simulate.
Bed read_bed(const Case& c);

// Tells the case the counts and sizes of the particles that it was opened with.
void count_bed(const Particles& particles, Case& c);

}  // namespace pmr::sim
